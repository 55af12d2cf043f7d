// SPDX-License-Identifier: BSD-3-Clause
// Reads parts of a volume file in bricks (Documentation/Formats/nxv.md).
import { blockOf, copyCommon, countVoxels, fillCommon } from './blocks.js';
import { bytesOfType, isCount, lengthOfHeader, makeConverter, parseHeader, prefixLength } from './nxv.js';
import { joinParts } from './remoteFile.js';
import { inflate } from './unpacking.js';

const firstBytes = 16384; // the header of most files
const entrySize = 8; // of an index: length and first voxel of a brick
const mostBricks = 2 ** 22; // of an array

const isSize = (counts, most) => Array.isArray(counts) && counts.length === 3 &&
  counts.every((count) => isCount(count) && count >= 1 && count <= most);

function checkArray(array) {
  const voxels = isSize(array?.brick, 2 ** 24) ? array.brick.reduce((product, count) => product * count) : 0;
  if (array?.encoding !== 'bricks' || !(bytesOfType[array.type] <= 4) || !(voxels >= 512 && voxels <= 2 ** 24) ||
      ![array.offset, array.scale].every(Number.isFinite) || !isCount(array.index_length) || array.index_length > array.length) {
    throw new Error('its header is damaged');
  }
}

// The levels of a file from fine to coarse, the volume itself first. `place`: of the payload of the first array.
function levelsOf({ dimensions, arrays, levels }, place) {
  if (arrays[0].encoding !== 'bricks') {
    throw new Error('it is not in bricks, and the page was made for volumes that are; make the page again');
  }
  const lists = [{ voxels: [1, 1, 1], arrays }].concat(levels ?? []);
  const isLevel = (level) => isSize(level?.voxels, 65536) && level.arrays?.[0]?.name === arrays[0].name &&
    level.arrays.every((array) => isCount(array?.length));
  if (!isSize(dimensions, 2 ** 31) || !lists.every(isLevel)) {
    throw new Error('its header is damaged');
  }
  return lists.map(({ voxels, arrays: [array, ...others] }) => {
    checkArray(array);
    const level = { voxels, array, place, size: dimensions.map((count, axis) => Math.ceil(count / voxels[axis])) };
    place += others.reduce((sum, { length }) => sum + length, array.length);
    return level;
  });
}

const bricksAlong = ({ size, array }) => size.map((voxels, axis) => Math.ceil(voxels / array.brick[axis]));

// Where the bricks of a level begin in the file. The last entry is where they end.
function placesOf({ array, place }, index) {
  const places = new Float64Array(index.length / entrySize + 1);
  const view = new DataView(index.buffer, index.byteOffset, index.length);
  places[0] = place + array.index_length;
  for (let brick = 0; brick + 1 < places.length; brick++) {
    places[brick + 1] = places[brick] + view.getUint32(entrySize * brick, true);
  }
  if (places.at(-1) !== place + array.length) {
    throw new Error('its index does not fit its bricks');
  }
  return places;
}

export class BrickFile {
  // `shown`: scale and masked, as the page has them.
  static async open(remote, shown) {
    let head = await remote.read(0, firstBytes, { orFewer: true });
    if (head.length < prefixLength) {
      throw new Error('the file ends too early');
    }
    const payload = prefixLength + lengthOfHeader(head);
    head = payload > head.length ? await remote.read(0, payload) : head;
    return new BrickFile(remote, parseHeader(head.subarray(prefixLength, payload)), payload, shown);
  }

  constructor(remote, header, payload, { scale, masked }) {
    Object.assign(this, { remote, header, levels: levelsOf(header, payload) });
    for (const level of this.levels) {
      level.convert = makeConverter(level.array, scale, masked);
    }
  }

  // The number of the level with so many voxels; -1 for none.
  levelOf(size) {
    return this.levels.findIndex((level) => level.size.join() === size.join());
  }

  async readIndex(level) {
    const count = bricksAlong(level).reduce((product, bricks) => product * bricks);
    if (count > mostBricks) {
      throw new Error('it has too many bricks');
    }
    const packed = await this.remote.read(level.place, level.array.index_length);
    const index = await inflate(packed, count * entrySize);
    if (index.length !== count * entrySize) {
      throw new Error('its index does not fit its bricks');
    }
    return { values: index, places: placesOf(level, index) };
  }

  // The index of a level is read once, unless that fails.
  async indexOf(level) {
    level.index ??= this.readIndex(level);
    return level.index.catch((problem) => {
      level.index = null;
      throw problem;
    });
  }

  // The bricks that have voxels of a block, in the order of the file.
  async bricksOf(level, { begin, end }) {
    const { values, places } = await this.indexOf(level);
    const { brick } = level.array;
    const [across, , high] = bricksAlong(level);
    const [first, last] = [begin.map((place, axis) => Math.floor(place / brick[axis])),
      end.map((place, axis) => Math.ceil(place / brick[axis]))];
    const found = [];
    for (let y = first[1]; y < last[1]; y++) {
      for (let x = first[0]; x < last[0]; x++) {
        for (let z = first[2]; z < last[2]; z++) {
          const number = (y * across + x) * high + z;
          const lower = [x, y, z].map((place, axis) => place * brick[axis]);
          const upper = lower.map((place, axis) => Math.min(place + brick[axis], level.size[axis]));
          found.push({
            number, voxels: { begin: lower, end: upper }, offset: places[number], length: places[number + 1] - places[number],
            value: values.subarray(entrySize * number + 4, entrySize * number + 4 + bytesOfType[level.array.type]),
          });
        }
      }
    }
    return found;
  }

  // The voxels of a block of a level as bytes of the page's scale. `store` has bricks that were read before, and keeps those
  // that are read now; it knows this file as `name`.
  async read(number, block, { store, name, signal } = {}) {
    const level = this.levels[number];
    const bytes = new Uint8Array(countVoxels(block));
    const missing = [];
    for (const brick of await this.bricksOf(level, block)) {
      brick.key = `${name} ${number} ${brick.number}`;
      const kept = store?.get(brick.key);
      if (brick.length === 0) {
        fillCommon(brick.voxels, level.convert(brick.value, 1)[0], block, bytes);
      } else if (kept !== undefined) {
        copyCommon(brick.voxels, kept, block, bytes);
      } else {
        missing.push(brick);
      }
    }
    await Promise.all(joinParts(missing).map((run) => this.readRun(level, run, signal, (brick, voxels) => {
      store?.put(brick.key, voxels);
      copyCommon(brick.voxels, voxels, block, bytes);
    })));
    return bytes;
  }

  async readRun(level, { offset, end, parts }, signal, take) {
    const packed = await this.remote.read(offset, end - offset, { signal });
    await Promise.all(parts.map(async (brick) => {
      const stream = packed.subarray(brick.offset - offset, brick.offset - offset + brick.length);
      const voxels = countVoxels(brick.voxels);
      try {
        take(brick, level.convert(await inflate(stream, voxels * bytesOfType[level.array.type]), voxels));
      } catch (problem) {
        throw new Error(`a brick is damaged: ${problem.message}`);
      }
    }));
  }

  // The whole volume in the voxels of a level.
  readLevel(number) {
    return this.read(number, blockOf(this.levels[number].size));
  }
}

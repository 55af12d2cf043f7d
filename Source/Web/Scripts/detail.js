// SPDX-License-Identifier: BSD-3-Clause
// The part of a large volume that the camera sees, in voxels as large as the pixels there.
import { countVoxels, holdsBlock, sizeOfBlock } from './blocks.js';
import { BrickStore } from './brickStore.js';
import { Frame } from './frame.js';

const mostTexels = 2 ** 25; // bytes of its texture
const mostAlongAxis = 2048; // of a texture, in most browsers
const mostKeptBricks = 128e6; // bytes
const multiple = 4; // of voxels along x, with which a map of distances is made fastest

// The voxels of a level from one place to another along x or y, in km from the lower face of the domain; and one more on each
// side, so that what is between their centres covers that part.
function coverAlong(from, to, spacing, voxels, step) {
  const begin = Math.floor(from / spacing) - 1;
  const end = Math.ceil(to / spacing) + 1;
  return [Math.max(0, Math.floor(begin / step) * step), Math.min(voxels, Math.ceil(end / step) * step)];
}

// The level and the block of it to be drawn, of the levels of a file from fine to coarse. `whole`: the number of the one that
// is drawn as a whole, in `box`; `seen`: what findSeen found. Null where that level is fine enough. The rule is that of the
// program (Source/Core/Grid/FinerBox.cxx, Source/Filters/Series/VolumeFiles.cxx).
export function chooseDetail(levels, whole, box, seen, bytesPerVoxel) {
  const spacingOf = ({ voxels }, axis) =>
    ((box[2 * axis + 1] - box[2 * axis]) / levels[whole].size[axis]) * (voxels[axis] / levels[whole].voxels[axis]);
  const [west, east, south, north] = seen.faces;
  const blockIn = (level) => {
    const x = coverAlong(west - box[0], east - box[0], spacingOf(level, 0), level.size[0], multiple);
    const y = coverAlong(south - box[2], north - box[2], spacingOf(level, 1), level.size[1], 1);
    return { begin: [x[0], y[0], 0], end: [x[1], y[1], level.size[2]] };
  };
  const fits = (block) =>
    Math.max(...sizeOfBlock(block)) <= mostAlongAxis && countVoxels(block) * bytesPerVoxel <= mostTexels;
  let level = spacingOf(levels[whole], 0) <= seen.pixel ? whole : 0;
  while (level < whole && (2 * spacingOf(levels[level], 0) <= seen.pixel || !fits(blockIn(levels[level])))) {
    level++;
  }
  return level < whole ? { level, block: blockIn(levels[level]) } : null;
}

// Where a block lies in the whole volume, as shares of its edges: the lower and the upper corner.
function placeOf({ level, block }, levels, whole) {
  const share = (voxel, axis) =>
    (voxel * levels[level].voxels[axis]) / (levels[whole].size[axis] * levels[whole].voxels[axis]);
  return { lower: block.begin.map(share), upper: block.end.map(share) };
}

// Reads the detail of one time after the other. `show` draws one, or none for null.
export class Detail {
  constructor(scene, series, show, report) {
    Object.assign(this, { scene, series, show, report });
    this.store = new BrickStore(mostKeptBricks);
    this.wanted = null; // what is shown, or being read
    this.reading = null; // its promise
    this.turn = 0; // of the latest call
    this.loading = false;
    this.failed = false;
    this.stop = new AbortController();
  }

  // Whether what is shown or being read has it too.
  has({ whole, level, block }) {
    const { wanted } = this;
    return wanted !== null && wanted.whole === whole && wanted.level === level && holdsBlock(wanted.block, block);
  }

  // The picture is at rest: it shows `seen` of the volume number `index`, which is drawn as `frame`, in `box`.
  async follow(index, frame, seen, box) {
    const { scene, series } = this;
    const turn = ++this.turn;
    this.loading = true;
    try {
      const { file, name } = await series.open(index);
      if (turn !== this.turn) {
        return;
      }
      const whole = file.levelOf(scene.size);
      const chosen = seen === null ? null : chooseDetail(file.levels, whole, box, seen, scene.masked ? 2 : 1);
      if (chosen === null) {
        this.begin(null);
        this.show(null);
      } else {
        const wanted = { ...chosen, ...placeOf(chosen, file.levels, whole), whole: frame };
        this.reading = this.has(wanted) ? this.reading : this.load(file, name, wanted);
        await this.reading;
      }
    } catch (problem) {
      this.begin(null);
      this.failed = true;
      this.report(problem.message);
    } finally {
      this.loading = this.loading && turn !== this.turn;
    }
  }

  // What was being read is no longer wanted.
  begin(wanted) {
    this.stop.abort();
    this.stop = new AbortController();
    this.wanted = wanted;
  }

  async load(file, name, wanted) {
    this.begin(wanted);
    const { signal } = this.stop;
    try {
      const bytes = await file.read(wanted.level, wanted.block, { store: this.store, name, signal });
      if (!signal.aborted) {
        this.show({ ...wanted, frame: new Frame(sizeOfBlock(wanted.block), bytes, this.scene.masked) });
        if (this.failed) {
          this.report('');
        }
        this.failed = false;
      }
    } catch (problem) {
      if (!signal.aborted) {
        this.series.forget(name);
        throw new Error(`${name}: ${problem.message}`);
      }
    }
  }
}

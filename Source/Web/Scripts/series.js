// SPDX-License-Identifier: BSD-3-Clause
// Where the volumes come from: the page itself, or volume files beside it on a server. A series has `times` (milliseconds
// since 1970, ascending) and load(index), which gives a Frame.
import { BrickFile } from './brickFile.js';
import { Frame, unpackColumns } from './frame.js';
import { bytesOfMoment, readNxv } from './nxv.js';
import { RemoteFile } from './remoteFile.js';
import { bytesOfBase64, inflate } from './unpacking.js';

const mostKeptBytes = 160e6; // of frames that were unpacked
const pollInterval = 10000; // milliseconds between two looks at the index of a growing series

// Keeps what was used last: as much as `mayKeep` says of a number of things, by one of them.
class Shelf {
  constructor(mayKeep) {
    this.mayKeep = mayKeep;
    this.things = new Map();
  }
  // `make` returns a promise of the thing; two callers share one.
  get(key, make) {
    const found = this.things.get(key) ?? make();
    this.things.delete(key);
    this.things.set(key, found);
    found.then((thing) => this.leaveOut(thing), () => this.things.delete(key));
    return found;
  }
  leaveOut(thing) {
    for (const key of this.things.keys()) {
      if (this.mayKeep(this.things.size, thing)) {
        return;
      }
      this.things.delete(key);
    }
  }
}

const mayKeepFrames = (number, { bytes }) => number * bytes.length <= mostKeptBytes || number <= 4;
const mayKeepFiles = (number) => number <= 2; // a server that does not know parts sends them whole

// The volumes in the page: two elements of base64 for each time.
export class EmbeddedSeries {
  constructor(scene, document) {
    Object.assign(this, { scene, document, times: scene.times, shelf: new Shelf(mayKeepFrames) });
  }
  load(index) {
    return this.shelf.get(index, () => this.unpack(index));
  }
  async unpack(index) {
    const part = (name) => inflate(bytesOfBase64(this.document.getElementById(`${name}-${index}`).textContent));
    const [ends, differences] = await Promise.all([part('ends'), part('codes')]);
    const { size, codes, masked } = this.scene;
    return new Frame(size, unpackColumns(size, ends, differences, codes), masked);
  }
  follow() {}
}

// Seconds since 1970 of the years 1 to 9999.
const earliestTime = -62135596800;
const latestTime = 253402300799.999;

// The entries of an index, by their times.
function filesOfIndex(index, name) {
  const isTime = (time) => Number.isFinite(time) && time >= earliestTime && time <= latestTime;
  const isFile = (file) => typeof file?.name === 'string' && isTime(file.time);
  if (!Array.isArray(index?.files) || !index.files.every(isFile)) {
    throw new Error(`${name} is no index of a series.`);
  }
  return index.files.slice().sort((a, b) => a.time - b.time);
}

const addressOf = (name) => name.split('/').map(encodeURIComponent).join('/');

// Does what reads a file. An error names the file.
async function naming(name, work) {
  try {
    return await work();
  } catch (problem) {
    throw new Error(`${name}: ${problem.message}`);
  }
}

// The volumes that an index beside the page names.
export class FolderSeries {
  constructor(scene, fetchFile) {
    Object.assign(this, { scene, fetchFile, times: [], names: [] });
    this.shelf = new Shelf(mayKeepFrames);
    this.files = new Shelf(mayKeepFiles); // in bricks
  }
  // Reads the index. Returns whether there are new times.
  async refresh() {
    const response = await this.fetchFile(this.scene.series, { cache: 'no-cache' });
    if (!response.ok) {
      throw new Error(`${this.scene.series} cannot be read from the server (${response.status}).`);
    }
    const files = filesOfIndex(await response.json(), this.scene.series);
    const changed = files.map(({ name }) => name).join() !== this.names.join();
    this.names = files.map(({ name }) => name);
    this.times = files.map(({ time }) => Math.round(1000 * time));
    return changed;
  }
  load(index) {
    const name = this.names[index];
    return this.shelf.get(name, () => this.read(name));
  }
  async read(name) {
    if (this.scene.bricks) {
      return this.readInBricks(name);
    }
    const response = await this.fetchFile(addressOf(name));
    if (!response.ok) {
      throw new Error(`${name} cannot be read from the server (${response.status}).`);
    }
    const { size, scale, masked } = this.scene;
    return naming(name, async () => {
      const volume = await readNxv(response.body);
      this.check(volume.header, volume.header.dimensions.join() === size.join());
      return new Frame(size, await bytesOfMoment(volume, scale, masked), masked);
    });
  }
  check(header, hasSize) {
    if (!hasSize || header.arrays[0].name !== this.scene.array) {
      throw new Error('it has another grid or moment than the page was made for');
    }
  }
  async readInBricks(name) {
    const file = await this.openFile(name);
    const { size, masked } = this.scene;
    try {
      return new Frame(size, await naming(name, () => file.readLevel(file.levelOf(size))), masked);
    } catch (problem) {
      this.forget(name);
      throw problem;
    }
  }
  // A file in bricks, which has the level that the page shows.
  openFile(name) {
    return this.files.get(name, () => naming(name, async () => {
      const file = await BrickFile.open(new RemoteFile(this.fetchFile, addressOf(name)), this.scene);
      this.check(file.header, file.levelOf(this.scene.size) >= 0);
      return file;
    }));
  }
  async open(index) {
    const name = this.names[index];
    return { name, file: await this.openFile(name) };
  }
  // The next use of a file reads its header anew.
  forget(name) {
    this.files.things.delete(name);
  }
  // Looks at the index again and again, and says when there are other times, and when it can be read again.
  follow(changed, failed) {
    let missing = false;
    const look = async () => {
      try {
        const other = await this.refresh();
        if (other || missing) {
          changed();
        }
        missing = false;
      } catch (problem) {
        missing = true;
        failed(problem);
      }
    };
    setInterval(look, pollInterval);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// Where the volumes come from: the page itself, or volume files beside it on a server. A series has `times` (milliseconds
// since 1970, ascending) and load(index), which gives a Frame.
import { Frame, unpackColumns } from './frame.js';
import { bytesOfMoment, readNxv } from './nxv.js';
import { bytesOfBase64, inflate } from './unpacking.js';

const mostKeptBytes = 160e6; // of frames that were unpacked
const pollInterval = 10000; // milliseconds between two looks at the index of a growing series

// Keeps the frames that were used last.
class Shelf {
  constructor() {
    this.frames = new Map();
  }
  // `make` returns a promise of the frame; two callers share one.
  get(key, make) {
    const found = this.frames.get(key) ?? make();
    this.frames.delete(key);
    this.frames.set(key, found);
    found.then((frame) => this.leaveOut(frame.bytes.length), () => this.frames.delete(key));
    return found;
  }
  leaveOut(bytes) {
    for (const key of this.frames.keys()) {
      if (this.frames.size * bytes <= mostKeptBytes || this.frames.size <= 4) {
        return;
      }
      this.frames.delete(key);
    }
  }
}

// The volumes in the page: two elements of base64 for each time.
export class EmbeddedSeries {
  constructor(scene, document) {
    Object.assign(this, { scene, document, times: scene.times, shelf: new Shelf() });
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

// The volumes that an index beside the page names.
export class FolderSeries {
  constructor(scene, fetchFile) {
    Object.assign(this, { scene, fetchFile, times: [], names: [], shelf: new Shelf() });
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
    const response = await this.fetchFile(name.split('/').map(encodeURIComponent).join('/'));
    if (!response.ok) {
      throw new Error(`${name} cannot be read from the server (${response.status}).`);
    }
    const { size, scale, masked } = this.scene;
    try {
      const volume = await readNxv(response.body);
      if (volume.header.dimensions.join() !== size.join() || volume.header.arrays[0].name !== this.scene.array) {
        throw new Error('it has another grid or moment than the page was made for');
      }
      return new Frame(size, await bytesOfMoment(volume, scale, masked), masked);
    } catch (problem) {
      throw new Error(`${name}: ${problem.message}`);
    }
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

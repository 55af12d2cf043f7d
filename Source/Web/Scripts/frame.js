// SPDX-License-Identifier: BSD-3-Clause
// One time of the volume as the graphics card takes it: a byte for each voxel, x fastest, then y, then z upward.
import { Bricks } from './bricks.js';

export class Frame {
  // `masked`: byte 0 is no value.
  constructor(size, bytes, masked) {
    Object.assign(this, { size, bytes, masked });
    this.bricks = null;
  }
  // Of each brick to the nearest one where something is visible.
  distancesFor(visibility) {
    this.bricks ??= new Bricks(this.size, this.bytes, this.masked);
    if (this.visibility !== visibility) {
      this.visibility = visibility;
      this.distances = this.bricks.distances(visibility);
    }
    return this.distances;
  }
}

// Unpacks the voxels of a page (Documentation/Formats/web-page.md). `packedEnds` says for each column of voxels between
// which layers echo lies, `differences` has the codes of the echo, and `bytesOfCodes` what they stand for.
export function unpackColumns([columns, rows, layers], packedEnds, differences, bytesOfCodes) {
  const bytes = new Uint8Array(columns * rows * layers);
  const codes = new Uint8Array(bytes.length); // of the voxels, to add differences to
  const layer = columns * rows;
  let place = 0;
  let next = 0;
  let left = []; // layers at which echo begins or ends in the column before
  for (let column = 0; column < layer; column++) {
    const count = packedEnds[place++];
    const ends = [];
    for (let i = 0; i < count; i++) {
      const guess = count === left.length ? left[i] : i > 0 ? ends[i - 1] : 0;
      ends.push((packedEnds[place++] + guess) & 255);
    }
    left = ends;
    const hasLeft = column % columns > 0;
    for (let i = 0; i + 1 < count; i += 2) {
      for (let z = ends[i], voxel = column + ends[i] * layer; z < ends[i + 1]; z++, voxel += layer) {
        const guess = (z > 0 && codes[voxel - layer]) || (hasLeft && codes[voxel - 1]) ||
          (column >= columns && codes[voxel - columns]) || 0;
        codes[voxel] = guess + differences[next++];
        bytes[voxel] = bytesOfCodes[codes[voxel]];
      }
    }
  }
  if (place !== packedEnds.length || next !== differences.length) {
    throw new Error('The data of this page are damaged.');
  }
  return bytes;
}

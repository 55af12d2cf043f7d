// SPDX-License-Identifier: BSD-3-Clause
// Blocks of the voxels of a grid: the first along x, y and z, `begin`, and those after the last, `end`.

export const blockOf = (size) => ({ begin: [0, 0, 0], end: size });
export const sizeOfBlock = ({ begin, end }) => end.map((last, axis) => last - begin[axis]);
export const countVoxels = (block) => sizeOfBlock(block).reduce((product, extent) => product * extent, 1);
export const holdsBlock = (outer, inner) => [0, 1, 2].every((axis) =>
  outer.begin[axis] <= inner.begin[axis] && outer.end[axis] >= inner.end[axis]);

// Does something with each row of voxels along x that two blocks have in common: where it begins in the array of the one
// and in that of the other, and how many voxels it has.
function eachCommonRow(one, other, work) {
  const begin = one.begin.map((first, axis) => Math.max(first, other.begin[axis]));
  const end = one.end.map((last, axis) => Math.min(last, other.end[axis]));
  const placeIn = (block, y, z) => {
    const [columns, rows] = sizeOfBlock(block);
    return ((z - block.begin[2]) * rows + y - block.begin[1]) * columns + begin[0] - block.begin[0];
  };
  for (let z = begin[2]; z < end[2]; z++) {
    for (let y = begin[1]; y < end[1]; y++) {
      work(placeIn(one, y, z), placeIn(other, y, z), end[0] - begin[0]);
    }
  }
}

export function copyCommon(from, bytes, to, target) {
  eachCommonRow(from, to, (place, targetPlace, count) => target.set(bytes.subarray(place, place + count), targetPlace));
}

export function fillCommon(from, byte, to, target) {
  eachCommonRow(from, to, (place, targetPlace, count) => target.fill(byte, targetPlace, targetPlace + count));
}

// SPDX-License-Identifier: BSD-3-Clause
// Where a volume has nothing to see. A brick is a cube of voxels with the least and the greatest byte that interpolation can
// give anywhere in it.

export const brickSize = 4; // voxels along each edge

export class Bricks {
  // `size`: voxels along x, y and z; `bytes`: one for each voxel, x fastest; `masked`: byte 0 stands for no value.
  constructor(size, bytes, masked = false) {
    this.masked = masked;
    this.size = size.map((voxels) => Math.ceil(voxels / brickSize));
    const count = this.size[0] * this.size[1] * this.size[2];
    this.least = new Uint8Array(count).fill(255);
    this.most = new Uint8Array(count);
    this.measure(size, bytes);
    this.addNeighbours();
  }

  // The least and the greatest byte of the voxels of each brick.
  measure([columns, rows, layers], bytes) {
    const [across, along] = this.size;
    for (let z = 0, voxel = 0; z < layers; z++) {
      for (let y = 0; y < rows; y++, voxel += columns) {
        const brick = (Math.floor(z / brickSize) * along + Math.floor(y / brickSize)) * across;
        this.measureRow(bytes.subarray(voxel, voxel + columns), brick);
      }
    }
  }

  // Most rows hold little echo: where they can, four voxels are tested at a time.
  measureRow(row, brick) {
    const { least, most } = this;
    const fours = row.byteOffset % 4 === 0 && row.length % 4 === 0
      ? new Uint32Array(row.buffer, row.byteOffset, row.length / 4)
      : null;
    for (let x = 0; x < row.length; x += brickSize, brick++) {
      if (fours !== null && fours[x >> 2] === 0) {
        least[brick] = this.masked ? least[brick] : 0;
        continue;
      }
      const end = Math.min(x + brickSize, row.length);
      for (let voxel = x; voxel < end; voxel++) {
        const byte = row[voxel];
        most[brick] = byte > most[brick] ? byte : most[brick];
        least[brick] = byte < least[brick] && !(this.masked && byte === 0) ? byte : least[brick];
      }
    }
  }

  // A value at the edge of a brick is interpolated from the voxels of the next one too.
  addNeighbours() {
    this.most = this.spread(this.most, (a, b) => (a > b ? a : b));
    this.least = this.spread(this.least, (a, b) => (a < b ? a : b));
  }

  spread(values, choose) {
    return spreadAlongAxes(this.size, values, choose, 1);
  }

  // For each brick, 0 if it is visible, else how far the nearest visible one is, in bricks along the axis on which it is
  // farthest (at most 255).
  distances(visibility) {
    const distances = new Uint8Array(this.most.length);
    for (let brick = 0; brick < distances.length; brick++) {
      distances[brick] = visibility.isVisible(this.least[brick], this.most[brick]) ? 0 : 255;
    }
    return chessboard(this.size, distances);
  }
}

// Each value becomes that which `choose` makes of it and its neighbours along x, then y, then z.
function spreadAlongAxes(size, values, choose) {
  let from = values;
  const strides = [1, size[0], size[0] * size[1]];
  for (let axis = 0; axis < 3; axis++) {
    const to = from.slice();
    const stride = strides[axis];
    const extent = size[axis];
    for (let brick = 0; brick < from.length; brick++) {
      const place = Math.floor(brick / stride) % extent;
      if (place > 0) {
        to[brick] = choose(to[brick], from[brick - stride]);
      }
      if (place + 1 < extent) {
        to[brick] = choose(to[brick], from[brick + stride]);
      }
    }
    from = to;
  }
  return from;
}

// The chessboard distance to the nearest brick of 0, by one pass forwards and one backwards over half of the neighbours
// each.
function chessboard(size, distances) {
  const [across, along, high] = size;
  const relax = (x, y, z, step) => {
    const brick = (z * along + y) * across + x;
    let nearest = distances[brick];
    for (let k = -1; k <= 1; k++) {
      for (let j = -1; j <= 1; j++) {
        for (let i = -1; i <= 1; i++) {
          if (k * 9 + j * 3 + i >= 0) {
            continue; // the other half of the neighbours
          }
          const [a, b, c] = [x + step * i, y + step * j, z + step * k];
          if (a >= 0 && b >= 0 && c >= 0 && a < across && b < along && c < high) {
            nearest = Math.min(nearest, distances[(c * along + b) * across + a] + 1);
          }
        }
      }
    }
    distances[brick] = nearest;
  };
  for (let z = 0; z < high; z++) {
    for (let y = 0; y < along; y++) {
      for (let x = 0; x < across; x++) {
        relax(x, y, z, 1);
      }
    }
  }
  for (let z = high - 1; z >= 0; z--) {
    for (let y = along - 1; y >= 0; y--) {
      for (let x = across - 1; x >= 0; x--) {
        relax(x, y, z, -1);
      }
    }
  }
  return distances;
}

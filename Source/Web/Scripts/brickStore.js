// SPDX-License-Identifier: BSD-3-Clause
// Keeps the unpacked bricks that were used last, up to a number of bytes.
export class BrickStore {
  constructor(most) {
    Object.assign(this, { most, bytes: 0, bricks: new Map() });
  }
  get(key) {
    const found = this.bricks.get(key);
    if (found !== undefined) {
      this.bricks.delete(key);
      this.bricks.set(key, found);
    }
    return found;
  }
  put(key, brick) {
    this.bytes += brick.length - (this.bricks.get(key)?.length ?? 0);
    this.bricks.set(key, brick);
    for (const [oldest, { length }] of this.bricks) {
      if (this.bytes <= this.most) {
        return;
      }
      this.bytes -= length;
      this.bricks.delete(oldest);
    }
  }
}

// SPDX-License-Identifier: BSD-3-Clause
// Reads the first moment of a volume file (Documentation/Formats/nxv.md).
import { inflate } from './unpacking.js';

export const prefixLength = 8; // bytes before the header
const utf8 = new TextDecoder();

// Collects a stream until `wanted` bytes of it have come; `orFewer`: or it has ended.
export class ByteCollector {
  constructor(reader) {
    this.reader = reader;
    this.pieces = [];
    this.count = 0;
  }
  async collect(wanted, orFewer = false) {
    while (this.count < wanted) {
      const { done, value } = await this.reader.read();
      if (done && orFewer) {
        break;
      }
      if (done) {
        throw new Error('the file ends too early');
      }
      this.pieces.push(value);
      this.count += value.length;
    }
    if (this.pieces.length === 1) {
      return this.pieces[0];
    }
    const all = new Uint8Array(this.count);
    let place = 0;
    for (const piece of this.pieces) {
      all.set(piece, place);
      place += piece.length;
    }
    this.pieces = [all];
    return all;
  }
}

// Bytes of a voxel, by the type of an array; a run of voxels of the first takes 5 at most.
export const bytesOfType = { uint7: 5, uint8: 1, uint16: 2, float32: 4 };

export const isCount = (value) => Number.isSafeInteger(value) && value >= 0;

// How many bytes the header has, by what stands before it.
export function lengthOfHeader(prefix) {
  if (utf8.decode(prefix.subarray(0, 4)) !== 'NXV1') {
    throw new Error('it is no volume file');
  }
  const length = new DataView(prefix.buffer, prefix.byteOffset).getUint32(4, true);
  if (length > 1048576) {
    throw new Error('its header is too long');
  }
  return length;
}

// The header, of which only what is used here must be right.
export function parseHeader(bytes) {
  const header = JSON.parse(utf8.decode(bytes));
  const array = header?.arrays?.[0];
  if (!isCount(array?.length) || !Object.hasOwn(bytesOfType, array.type) || !Array.isArray(header.dimensions) ||
      !header.dimensions.every(isCount)) {
    throw new Error('its header is damaged');
  }
  return header;
}

// Reads header and first array of a stream and leaves the arrays after it alone.
export async function readNxv(stream) {
  const reader = stream.getReader();
  const collector = new ByteCollector(reader);
  const first = await collector.collect(prefixLength);
  const payload = prefixLength + lengthOfHeader(first);
  const head = await collector.collect(payload);
  const header = parseHeader(head.subarray(prefixLength, payload));
  const all = await collector.collect(payload + header.arrays[0].length);
  await reader.cancel().catch(() => {});
  return { header, payload: all.subarray(payload, payload + header.arrays[0].length) };
}

// Undoes run lengths (Formulas T8).
function expandRuns(stream, voxels) {
  const codes = new Uint8Array(voxels);
  const view = new DataView(stream.buffer, stream.byteOffset, stream.length);
  for (let place = 0, voxel = 0; voxel < voxels;) {
    const byte = stream[place++];
    if (byte >= 128) {
      codes[voxel++] = byte - 128;
    } else {
      const count = view.getUint32(place, true);
      if (count > voxels - voxel) {
        throw new Error('it has more codes than voxels');
      }
      codes.fill(byte, voxel, voxel + count);
      place += 4;
      voxel += count;
    }
  }
  return codes;
}

// Makes what turns the stored voxels of an array into bytes of the page's scale (first, step); 0 where there is no value.
// `masked`: 0 is kept for those voxels.
export function makeConverter(array, scale, masked) {
  const toByte = (value) => {
    const byte = Math.round((value - scale.first) / scale.step);
    return Math.min(Math.max(byte, masked ? 1 : 0), 255);
  };
  const isNothing = (code) => (array.type === 'uint7' ? code === 0 || code === 127 : code < 2);
  const ofCode = (code) => (isNothing(code) ? 0 : toByte(array.offset + array.scale * code));
  const table = Uint8Array.from({ length: array.type === 'uint16' ? 65536 : 256 }, (_, code) => ofCode(code));
  return (stored, voxels) => {
    const most = voxels * bytesOfType[array.type];
    if (array.type !== 'uint7' && stored.length !== most) {
      throw new Error(`it has ${stored.length} bytes of codes, not ${most}`);
    }
    const bytes = new Uint8Array(voxels);
    if (array.type === 'uint7' || array.type === 'uint8') {
      const codes = array.type === 'uint7' ? expandRuns(stored, voxels) : stored;
      for (let voxel = 0; voxel < voxels; voxel++) {
        bytes[voxel] = table[codes[voxel]];
      }
    } else if (array.type === 'uint16') {
      for (let voxel = 0; voxel < voxels; voxel++) {
        bytes[voxel] = table[stored[voxel] + 256 * stored[voxel + voxels]];
      }
    } else {
      const values = new DataView(stored.buffer, stored.byteOffset, stored.length);
      for (let voxel = 0; voxel < voxels; voxel++) {
        const value = values.getFloat32(4 * voxel, true);
        bytes[voxel] = value === array.fill || Number.isNaN(value) ? 0 : toByte(value);
      }
    }
    return bytes;
  };
}

// The first moment of a file that is not in bricks.
export async function bytesOfMoment({ header, payload }, scale, masked) {
  const array = header.arrays[0];
  if (array.encoding === 'bricks') {
    throw new Error('it is in bricks, and the page was made for volumes that are not; make the page again');
  }
  const voxels = header.dimensions.reduce((product, count) => product * count, 1);
  const stored = array.encoding === 'rle' ? payload : await inflate(payload, voxels * bytesOfType[array.type]);
  return makeConverter(array, scale, masked)(stored, voxels);
}

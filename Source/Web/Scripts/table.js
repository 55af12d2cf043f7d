// SPDX-License-Identifier: BSD-3-Clause
// What values look like: colour and opacity over the texels of a volume, and their integrals.
//
// A volume is a texture of bytes. A preset has samples of red, green, blue and opacity, two for each step of the byte from
// 0 to 255. Pre-integrated classification (Formulas L1) needs the integrals of the optical depth and of depth times colour;
// they have four entries for each sample.
import { clamp } from './vectors.js';

const samplesPerByte = 2;
export const samples = 255 * samplesPerByte + 1;
const partsOfSample = 4;
export const entries = (samples - 1) * partsOfSample + 1;

// Optical depths of a unit distance count as at most this: differences of large sums lose precision.
const mostDepth = 64;

// The optical depth of an opacity, for each factor of 2 by which it weakens what is behind.
const depthOf = (opacity) => Math.min(opacity < 1 ? -Math.log2(1 - opacity) : mostDepth, mostDepth);

// `rgba`: samples of red, green, blue and opacity, 0 to 1. Returns RGBA of every entry: the integrals, from byte 0 on, of
// depth times colour, and of the depth.
export function integrate(rgba) {
  const integrals = new Float32Array(4 * entries);
  const at = (entry) => {
    const sample = Math.min(Math.floor(entry / partsOfSample), samples - 2);
    const way = entry / partsOfSample - sample;
    const mix = (from, to) => from + way * (to - from);
    const [a, b] = [4 * sample, 4 * sample + 4];
    const depth = mix(depthOf(rgba[a + 3]), depthOf(rgba[b + 3]));
    return [0, 1, 2].map((channel) => mix(rgba[a + channel], rgba[b + channel]) * depth).concat(depth);
  };
  const sum = [0, 0, 0, 0];
  let last = at(0);
  for (let entry = 1; entry < entries; entry++) {
    const current = at(entry);
    for (let channel = 0; channel < 4; channel++) {
      sum[channel] += 0.5 * (last[channel] + current[channel]);
      integrals[4 * entry + channel] = sum[channel];
    }
    last = current;
  }
  return integrals;
}

// Tells whether any value between two bytes is visible.
export class Visibility {
  constructor(rgba) {
    this.before = new Uint16Array(samples + 1); // visible samples before each one
    for (let sample = 0; sample < samples; sample++) {
      this.before[sample + 1] = this.before[sample] + (rgba[4 * sample + 3] > 0 ? 1 : 0);
    }
  }
  isVisible(low, high) {
    return low <= high && this.before[high * samplesPerByte + 1] > this.before[low * samplesPerByte];
  }
}

// The same for surfaces of values: `bytes` are where they lie on the scale of bytes.
export class SurfaceVisibility {
  constructor(bytes) {
    this.bytes = bytes;
  }
  isVisible(low, high) {
    return this.bytes.some((byte) => byte >= low && byte <= high);
  }
}

// Red, green and blue of a value that lies at `byte`, which need not be a whole number.
export function colourAt(rgba, byte) {
  const place = clamp(byte * samplesPerByte, 0, samples - 1);
  const sample = Math.min(Math.floor(place), samples - 2);
  const way = place - sample;
  return [0, 1, 2].map((channel) =>
    rgba[4 * sample + channel] + way * (rgba[4 * sample + 4 + channel] - rgba[4 * sample + channel]));
}

// SPDX-License-Identifier: BSD-3-Clause
// Draws a volume: keeps the textures of two times, and marches along the rays of the pixels.
import { Program, Texture } from './graphics.js';
import { colourAt, entries, integrate, samples, SurfaceVisibility, Visibility } from './table.js';
import { brickSize } from './bricks.js';
import { divide, subtract } from './vectors.js';

const farCut = [0, 0, 0, 1]; // leaves everything

// The textures of one time.
class VolumeSlot {
  constructor(gl, size, masked) {
    this.masked = masked;
    this.volume = new Texture(gl, masked ? 'byteAndMask' : 'byte', size);
    this.distances = new Texture(gl, 'distance', size.map((voxels) => Math.ceil(voxels / brickSize)));
    this.frame = null;
  }
  fill(frame, visibility) {
    if (this.frame !== frame) {
      this.volume.fill(this.masked ? withMask(frame.bytes) : frame.bytes);
    }
    if (this.frame !== frame || this.visibility !== visibility) {
      this.distances.fill(frame.distancesFor(visibility));
    }
    this.frame = frame;
    this.visibility = visibility;
  }
  free() {
    this.volume.free();
    this.distances.free();
  }
}

function withMask(bytes) {
  const pairs = new Uint8Array(2 * bytes.length);
  for (let voxel = 0; voxel < bytes.length; voxel++) {
    if (bytes[voxel] !== 0) {
      pairs[2 * voxel] = bytes[voxel];
      pairs[2 * voxel + 1] = 255;
    }
  }
  return pairs;
}

export class VolumePicture {
  // `size`: voxels; `masked`: byte 0 is no value; `opacityDistance`: km of the stretched scene, to which opacities belong.
  constructor(gl, shaders, { size, masked, opacityDistance }) {
    Object.assign(this, { gl, shaders, size, masked, opacityDistance });
    this.slots = [new VolumeSlot(gl, size, masked), new VolumeSlot(gl, size, masked)];
    this.detail = null;
    this.integrals = new Texture(gl, 'float4', [entries, 1]);
    this.colours = new Texture(gl, 'float4', [samples, 1]);
    this.programs = new Map();
    this.framebuffer = gl.createFramebuffer();
    this.target = null;
    this.over = new Program(gl, shaders.volumeVertex, shaders.pictureFragment);
  }

  // `rgba`: samples of the preset; `surfaces`: [byte, opacity] in ascending order, none for the volume itself.
  setLook(rgba, surfaces) {
    this.surfaces = surfaces;
    this.visibility = surfaces.length > 0
      ? new SurfaceVisibility(surfaces.map(([byte]) => byte))
      : new Visibility(rgba);
    this.integrals.fill(integrate(rgba));
    const colours = new Float32Array(4 * samples);
    for (let sample = 0; sample < samples; sample++) {
      colours.set(colourAt(rgba, (sample * 255) / (samples - 1)), 4 * sample);
    }
    this.colours.fill(colours);
  }

  // Shows one time, or two blended: `share` is that of the second. A texture that has a frame already keeps it.
  setFrames(frame, next, share) {
    if (this.slots[1].frame === frame || (next !== null && this.slots[0].frame === next)) {
      this.slots.reverse();
    }
    this.slots[0].fill(frame, this.visibility);
    this.blended = next !== null && share > 0;
    if (next !== null) {
      this.slots[1].fill(next, this.visibility);
    }
    this.share = share;
  }

  // Shows a finer volume in place of a part of `whole`, while that is not blended: `frame`, and where it lies, `lower` and
  // `upper`, in shares of the whole volume. Null for none. Returns whether that changes anything.
  setDetail(detail) {
    if (detail === this.detail) {
      return false;
    }
    this.detail?.slot.free();
    this.detail = detail === null ? null : { ...detail, slot: new VolumeSlot(this.gl, detail.frame.size, this.masked) };
    return true;
  }

  // The detail that belongs to what is shown.
  shownDetail() {
    const { detail } = this;
    if (detail === null || this.blended || detail.whole !== this.slots[0].frame) {
      return null;
    }
    detail.slot.fill(detail.frame, this.visibility);
    return detail;
  }

  program(detail) {
    const defines = {
      BLENDED: this.blended ? 1 : 0, MASKED: this.masked ? 1 : 0, SURFACES: this.surfaces.length,
      DETAIL: detail === null ? 0 : 1, ENTRIES: entries, BRICK: brickSize,
    };
    const key = JSON.stringify(defines);
    if (!this.programs.has(key)) {
      this.programs.set(key, new Program(this.gl, this.shaders.volumeVertex, this.shaders.volumeFragment, defines));
    }
    return this.programs.get(key);
  }

  // Draws the volume into a picture of its own, of `pixels` wide and high.
  march(rays, box, pixels, { stepVoxels, strength, cut }) {
    const { gl } = this;
    this.prepareTarget(pixels);
    const corner = [box[0], box[2], box[4]];
    const extent = [box[1] - box[0], box[3] - box[2], box[5] - box[4]];
    const detail = this.shownDetail();
    const program = this.program(detail);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.viewport(0, 0, ...pixels);
    gl.disable(gl.BLEND);
    program.use();
    program.set({
      blend: this.share, voxels: this.size, boxSize: extent,
      rayOrigin: divide(subtract(rays.origin, corner), extent),
      rayOriginX: divide(rays.originX, extent), rayOriginY: divide(rays.originY, extent),
      rayDirection: divide(rays.direction, extent),
      rayDirectionX: divide(rays.directionX, extent), rayDirectionY: divide(rays.directionY, extent),
      cut: cut === null ? farCut : cutInBox(cut, corner, extent), stepVoxels, depthPerKilometre: strength / this.opacityDistance,
    });
    if (this.surfaces.length > 0) {
      gl.uniform2fv(program.place('surfaces'), this.surfaces.flatMap(([byte, opacity]) => [byte / 255, opacity]));
    }
    program.bind({
      volume: this.slots[0].volume, nextVolume: this.slots[1].volume, distances: this.slots[0].distances,
      nextDistances: this.slots[1].distances, integrals: this.integrals, colours: this.colours,
      ...(detail === null ? {} : { detailVolume: detail.slot.volume, detailDistances: detail.slot.distances }),
    });
    if (detail !== null) {
      program.set({ detailVoxels: detail.frame.size, detailLower: detail.lower, detailUpper: detail.upper });
    }
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    this.pixels = pixels;
  }

  prepareTarget([width, height]) {
    const { gl } = this;
    if (this.target !== null && this.target.size[0] >= width && this.target.size[1] >= height) {
      return;
    }
    this.target?.free();
    this.target = new Texture(gl, 'colour', [width, height]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.target.handle, 0);
  }

  // Puts that picture over what is drawn.
  compose() {
    const { gl } = this;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.over.use();
    this.over.set({ used: [this.pixels[0] / this.target.size[0], this.pixels[1] / this.target.size[1]] });
    this.over.bind({ picture: this.target });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}

// A plane of the scene, dot(normal, place) + distance = 0, as one of texture coordinates.
function cutInBox({ normal, distance }, corner, extent) {
  const scaled = normal.map((part, axis) => part * extent[axis]);
  return [...scaled, distance + normal.reduce((sum, part, axis) => sum + part * corner[axis], 0)];
}

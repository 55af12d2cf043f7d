// SPDX-License-Identifier: BSD-3-Clause
// Small helpers about WebGL2: programs, textures, and what the browser must be able to do.

const version = '#version 300 es\n';

// What is missing in this browser, as a sentence for its user; null when nothing is.
export function whatIsMissing(window) {
  if (typeof window.DecompressionStream !== 'function') {
    return 'This browser cannot unpack compressed data (DecompressionStream). Chrome or Edge from 80, Firefox from 113 and ' +
      'Safari from 16.4 on can.';
  }
  if (typeof window.WebGL2RenderingContext !== 'function') {
    return 'This browser has no WebGL2, which draws the volume. Chrome, Edge, Firefox and Safari 15 or newer have it; it may ' +
      'be switched off in the settings.';
  }
  return null;
}

function compile(gl, type, source) {
  const shader = gl.createShader(type);
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  return shader;
}

function refuse(gl, program, shaders) {
  const texts = [gl.getProgramInfoLog(program), ...shaders.map((shader) => gl.getShaderInfoLog(shader))];
  throw new Error(`The graphics driver refuses a shader: ${texts.filter(Boolean).join(' ')}`);
}

// A program with its uniforms by name. `defines`: what the texts may test with #if.
export class Program {
  constructor(gl, vertexText, fragmentText, defines = {}) {
    this.gl = gl;
    const head = version + Object.entries(defines).map(([name, value]) => `#define ${name} ${value}\n`).join('');
    const shaders = [
      compile(gl, gl.VERTEX_SHADER, head + vertexText), compile(gl, gl.FRAGMENT_SHADER, head + fragmentText)];
    this.handle = gl.createProgram();
    shaders.forEach((shader) => gl.attachShader(this.handle, shader));
    gl.linkProgram(this.handle);
    if (!gl.getProgramParameter(this.handle, gl.LINK_STATUS) && !gl.isContextLost()) {
      refuse(gl, this.handle, shaders);
    }
    shaders.forEach((shader) => gl.deleteShader(shader));
    this.places = new Map();
  }
  use() {
    this.gl.useProgram(this.handle);
  }
  place(name) {
    if (!this.places.has(name)) {
      this.places.set(name, this.gl.getUniformLocation(this.handle, name));
    }
    return this.places.get(name);
  }
  attribute(name) {
    return this.gl.getAttribLocation(this.handle, name);
  }
  // Sets uniforms: numbers, or arrays of two to four numbers, or of sixteen.
  set(values) {
    for (const [name, value] of Object.entries(values)) {
      const place = this.place(name);
      if (typeof value === 'number') {
        this.gl.uniform1f(place, value);
      } else if (value.length === 16) {
        this.gl.uniformMatrix4fv(place, false, value);
      } else {
        this.gl[`uniform${value.length}fv`](place, value);
      }
    }
  }
  // Binds textures to samplers, in the order given.
  bind(textures) {
    Object.entries(textures).forEach(([name, texture], unit) => {
      this.gl.activeTexture(this.gl.TEXTURE0 + unit);
      this.gl.bindTexture(texture.target, texture.handle);
      this.gl.uniform1i(this.place(name), unit);
    });
  }
}

// Formats of textures: internal format, format, type, whether values between texels are interpolated.
const formats = {
  byte: (gl) => [gl.R8, gl.RED, gl.UNSIGNED_BYTE, true],
  byteAndMask: (gl) => [gl.RG8, gl.RG, gl.UNSIGNED_BYTE, true],
  distance: (gl) => [gl.R8UI, gl.RED_INTEGER, gl.UNSIGNED_BYTE, false],
  float4: (gl) => [gl.RGBA32F, gl.RGBA, gl.FLOAT, false],
  picture: (gl) => [gl.RGB8, gl.RGB, gl.UNSIGNED_BYTE, true],
  colour: (gl) => [gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, true],
};

function prepare(gl, target, smooth) {
  const filter = smooth ? gl.LINEAR : gl.NEAREST;
  const handle = gl.createTexture();
  gl.bindTexture(target, handle);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) {
    gl.texParameteri(target, name, filter);
  }
  for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R]) {
    gl.texParameteri(target, name, gl.CLAMP_TO_EDGE);
  }
  return handle;
}

// A texture of a fixed size (two or three numbers) whose texels can be replaced.
export class Texture {
  constructor(gl, kind, size) {
    const [stored, format, type, smooth] = formats[kind](gl);
    Object.assign(this, { gl, size, format, type });
    this.target = size.length === 3 ? gl.TEXTURE_3D : gl.TEXTURE_2D;
    this.handle = prepare(gl, this.target, smooth);
    const most = gl.getParameter(size.length === 3 ? gl.MAX_3D_TEXTURE_SIZE : gl.MAX_TEXTURE_SIZE);
    if (Math.max(...size) > most) {
      throw new Error(`This browser draws at most ${most} voxels along an axis, and the volume has ${size.join('x')}.`);
    }
    if (size.length === 3) {
      gl.texStorage3D(this.target, 1, stored, ...size);
    } else {
      gl.texStorage2D(this.target, 1, stored, ...size);
    }
  }
  fill(texels) {
    const { gl, size } = this;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(this.target, this.handle);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    if (size.length === 3) {
      gl.texSubImage3D(this.target, 0, 0, 0, 0, ...size, this.format, this.type, texels);
    } else {
      gl.texSubImage2D(this.target, 0, 0, 0, ...size, this.format, this.type, texels);
    }
  }
  free() {
    this.gl.deleteTexture(this.handle);
  }
}

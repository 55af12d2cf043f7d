// SPDX-License-Identifier: BSD-3-Clause
// Draws lines of the scene that are a few pixels wide, and the ground under them.
import { Program } from './graphics.js';

// Segments with one colour and width, kept in the memory of the graphics card.
export class LineGroup {
  // `lines`: lists of points.
  constructor(gl, lines, colour, width) {
    this.gl = gl;
    this.colour = colour;
    this.width = width;
    const segments = lines.flatMap((line) => line.slice(1).map((point, i) => [line[i], point]));
    this.count = segments.length;
    this.buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(segments.flat(2)), gl.STATIC_DRAW);
  }
  free() {
    this.gl.deleteBuffer(this.buffer);
  }
}

export class LinePicture {
  constructor(gl, shaders) {
    this.gl = gl;
    this.program = new Program(gl, shaders.linesVertex, shaders.linesFragment);
    this.groundProgram = new Program(gl, shaders.groundVertex, shaders.groundFragment);
    this.skyProgram = new Program(gl, shaders.volumeVertex, shaders.skyFragment);
    this.corners = gl.createBuffer();
  }

  drawSky(lower, upper) {
    this.gl.disable(this.gl.BLEND);
    this.skyProgram.use();
    this.skyProgram.set({ lower, upper });
    this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
  }

  // `picture`: a texture, from its south-western corner on.
  drawGround(toClip, corners, picture) {
    const { gl, groundProgram } = this;
    gl.disable(gl.BLEND);
    groundProgram.use();
    groundProgram.set({ toClip });
    groundProgram.bind({ picture });
    gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(corners.flat()), gl.STREAM_DRAW);
    const place = groundProgram.attribute('corner');
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.disableVertexAttribArray(place);
  }

  // `scale`: pixels of the picture for a pixel of the width.
  draw(groups, toClip, pictureSize, scale) {
    const { gl, program } = this;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    program.use();
    program.set({ toClip, pictureSize });
    const places = [program.attribute('begin'), program.attribute('end')];
    for (const group of groups.filter(({ count }) => count > 0)) {
      program.set({ lineColour: group.colour, lineWidth: group.width * scale });
      gl.bindBuffer(gl.ARRAY_BUFFER, group.buffer);
      places.forEach((place, end) => {
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 24, 12 * end);
        gl.vertexAttribDivisor(place, 1);
      });
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, group.count);
    }
    places.forEach((place) => {
      gl.vertexAttribDivisor(place, 0);
      gl.disableVertexAttribArray(place);
    });
  }
}

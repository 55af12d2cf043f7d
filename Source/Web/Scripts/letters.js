// SPDX-License-Identifier: BSD-3-Clause
// Letters over the picture, on a canvas of their own. Places count in pixels from the lower left corner, as in the program.
import { boxBeside } from './framing.js';

const family = 'Inter, "Helvetica Neue", Arial, sans-serif';
const lineSpacing = 1.25;
const wider = 0.5; // pixels by which hinting makes a short word of the program wider, on average over its sizes

// From one line to the next, in pixels. The letters of the program are one pixel less high than their size.
const lineHeight = (style) => Math.floor(lineSpacing * (style.size - 1));

const css = (colour) => `rgb(${colour.map((part) => Math.round(255 * part)).join(' ')})`;

export class Letters {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
    this.sizes = new Map();
  }

  clear(width, height) {
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    } else {
      this.context.clearRect(0, 0, width, height);
    }
    this.height = height;
  }

  forgetSizes() {
    this.sizes.clear();
  }

  // Width and height of a text of one or more lines in pixels. `style`: size, bold.
  sizeOf(text, style) {
    const key = `${style.bold ? 'b' : ''}${style.size} ${text}`;
    if (!this.sizes.has(key)) {
      this.context.font = this.font(style);
      const lines = text.split('\n');
      const width = Math.max(...lines.map((line) => this.context.measureText(line).width));
      this.sizes.set(key, [Math.ceil(width + wider), style.size - 1 + (lines.length - 1) * lineHeight(style)]);
    }
    return this.sizes.get(key);
  }

  font(style) {
    return `${style.bold ? 'bold ' : ''}${style.size}px ${family}`;
  }

  // Draws a text beside a point and returns the rectangle that it takes. `style` has size, bold, colour, rim.
  draw(text, style, point, side, gap = 0) {
    const size = this.sizeOf(text, style);
    const box = boxBeside(point, side, gap, size);
    const { context } = this;
    context.font = this.font(style);
    context.textBaseline = 'alphabetic';
    context.lineJoin = 'round';
    context.lineWidth = 2 * Math.max(1, style.size / 11);
    context.strokeStyle = css(style.rim);
    context.fillStyle = css(style.colour);
    text.split('\n').forEach((line, i) => {
      const x = Math.round(box.left);
      const baseline = Math.round(this.height - box.top + 0.74 * style.size + i * lineHeight(style));
      context.strokeText(line, x, baseline);
      context.fillText(line, x, baseline);
    });
    return box;
  }

  disc([x, y], radius, colour, rim) {
    const { context } = this;
    for (const [reach, fill] of [[radius + 1.5, rim], [radius, colour]]) {
      context.fillStyle = css(fill);
      context.beginPath();
      context.arc(x, this.height - y, reach, 0, 2 * Math.PI);
      context.fill();
    }
  }

  // `upper`: the colour at the top of a ramp.
  rectangle(box, colour, upper) {
    this.context.fillStyle = css(colour);
    if (upper) {
      const ramp = this.context.createLinearGradient(0, this.height - box.bottom, 0, this.height - box.top);
      ramp.addColorStop(0, css(colour));
      ramp.addColorStop(1, css(upper));
      this.context.fillStyle = ramp;
    }
    // Whole pixels: between rectangles that meet nothing shows through.
    const [top, bottom] = [Math.round(this.height - box.top), Math.round(this.height - box.bottom)];
    this.context.fillRect(box.left, top, box.right - box.left, bottom - top);
  }

  frame(box, colour) {
    this.context.strokeStyle = css(colour);
    this.context.lineWidth = 1;
    this.context.strokeRect(Math.round(box.left) + 0.5, Math.round(this.height - box.top) - 0.5,
      Math.round(box.right - box.left), Math.round(box.top - box.bottom));
  }
}

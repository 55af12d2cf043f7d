// SPDX-License-Identifier: BSD-3-Clause
// The whole picture: sky, ground, map, scales, volume, letters.
import { Camera } from './camera.js';
import { Captions, ColourBar, heightNote, timeText } from './captions.js';
import { frameScene } from './framing.js';
import { Texture } from './graphics.js';
import { drawLabels } from './labels.js';
import { Letters } from './letters.js';
import { LineGroup, LinePicture } from './linePicture.js';
import { makeScales, cornerOf } from './scales.js';
import { findSeen } from './seen.js';
import { add, subtract } from './vectors.js';
import { VolumePicture } from './volumePicture.js';

const lineWidths = { country: 1.3, state: 1.3, county: 1 }; // pixels
const lineLevels = { ground: -2, county: 0, state: 1, country: 2, marker: 4 };
const levelHeight = 8e-4; // from one level to the next, of the width of the domain
const leastLetters = 11; // height in pixels of the screen
const lettersApart = 8; // times the height of letters, from one radar that is named to the next

// A matrix of the camera from the scene to clip coordinates, column by column. Depth is not used.
function toClipOf(camera) {
  const { right, up, back, position, half, aspect, parallel } = camera;
  const row = (axis, scale) => [...axis.map((part) => part * scale), -scale * axis.reduce((sum, part, i) => sum + part * position[i], 0)];
  const x = row(right, 1 / (half * aspect));
  const y = row(up, 1 / half);
  const w = parallel ? [0, 0, 0, 1] : row(back, -1);
  return [0, 1, 2, 3].flatMap((column) => [x[column], y[column], 0, w[column]]);
}

export class ScenePicture {
  constructor(scene, pictureCanvas, lettersCanvas, shaders) {
    this.scene = scene;
    this.canvas = pictureCanvas;
    this.gl = pictureCanvas.getContext('webgl2', { antialias: false, alpha: false, preserveDrawingBuffer: true });
    if (this.gl === null) {
      throw new Error('WebGL2, which draws the volume, is switched off in this browser or not supported by its graphics card.');
    }
    this.letters = new Letters(lettersCanvas);
    this.lines = new LinePicture(this.gl, shaders);
    this.ground = new Texture(this.gl, 'picture', scene.ground);
    this.ground.fill(scene.groundTexels);
    this.volume = new VolumePicture(this.gl, shaders, scene);
    this.groups = [];
    this.scaleGroups = [];
    this.placed = null;
  }

  resize(width, height, pixelRatio) {
    this.width = Math.max(1, Math.round(width * pixelRatio));
    this.height = Math.max(1, Math.round(height * pixelRatio));
    this.pixelRatio = pixelRatio;
    this.textSize = Math.max(Math.round(leastLetters * Math.min(pixelRatio, 2)),
      Math.floor(Math.min(this.height / 45, this.width / 50)));
    this.canvas.width = this.width;
    this.canvas.height = this.height;
  }

  // A box in scene coordinates: west, east, south, north, bottom, top.
  boxFor(box, stretch) {
    return [...box.slice(0, 4), box[4] * stretch, box[5] * stretch];
  }

  style(colour) {
    return { size: this.textSize, colour, rim: this.scene.theme.rim, bold: false };
  }

  // Heights of what lies on the ground, a little above each other.
  levelOf(name, box) {
    return box[4] + levelHeight * lineLevels[name] * (box[1] - box[0]);
  }

  setStretch(stretch) {
    const { gl, scene } = this;
    this.stretch = stretch;
    this.box = this.boxFor(scene.box, stretch); // the domain
    this.framed = this.boxFor(scene.framed, stretch);
    this.groups.forEach((group) => group.free());
    this.groups = ['county', 'state', 'country'].map((kind) => {
      const z = this.levelOf(kind, this.framed);
      return new LineGroup(gl, scene.map[kind].map((line) => pairs(line, z)), scene.theme[kind], lineWidths[kind]);
    });
  }

  setScales(view) {
    const { gl, scene } = this;
    const scales = makeScales(this.framed, this.stretch, view, this.textSize);
    this.scaleGroups.forEach((group) => group.free());
    this.scaleGroups = [
      new LineGroup(gl, scales.edges, scene.theme.frame, 1), new LineGroup(gl, scales.walls, scene.theme.wall, 1),
      new LineGroup(gl, scales.ticks, scene.theme.scale, 1.5)];
    this.labels = scales.labels.map((label) => this.withStyle(label, scene.theme.scale));
    this.outline = scales.outline;
  }

  withStyle(label, colour) {
    const style = this.style(colour);
    return { ...label, style, size: this.letters.sizeOf(label.text, style) };
  }

  // `time`: milliseconds; `siteTexts`: words about the radars; `preset`: with bins and labels.
  makeCaptions({ time, siteTexts, preset }) {
    const { scene, width, height } = this;
    this.bar = new ColourBar(preset, width, height, this.style(scene.theme.scale), this.letters);
    this.captions = new Captions({
      time: timeText(time), title: scene.title, method: scene.method, sites: siteTexts, synthetic: scene.synthetic,
      note: heightNote(this.stretch),
    }, width, height, this.bar.left, this.textSize, scene.theme, this.letters);
  }

  // Places the camera so that the frame fills the picture.
  frame(view) {
    this.setScales(view);
    this.placed = frameScene(view, { outline: this.outline, labels: this.labels },
      { width: this.width, height: this.height, right: this.bar.left, taken: this.captions.taken() });
  }

  cameraOf({ view, moved }) {
    const placed = { ...this.placed, focus: add(this.placed.focus, moved) };
    return new Camera(view, placed, this.width, this.height);
  }

  // What the picture shows of the domain.
  findSeen(state) {
    return findSeen(this.cameraOf(state), this.box);
  }

  // `state`: view, moved (how far the camera was moved sideways, in the scene), time, siteTexts, preset, strength, cut,
  // cutLines, quality (share of the pixels along an edge, step in voxels).
  draw(state) {
    const { gl, scene } = this;
    const camera = this.cameraOf(state);
    const toClip = toClipOf(camera);
    this.setScales(state.view);
    const pixels = [this.width, this.height].map((extent) => Math.max(1, Math.round(extent * state.quality.pixels)));
    this.volume.march(camera.rays(), this.box, pixels, {
      stepVoxels: state.quality.step, strength: state.strength, cut: state.cut,
    });
    gl.viewport(0, 0, this.width, this.height);
    this.lines.drawSky(scene.theme.skyBottom, scene.theme.skyTop);
    const size = [this.width, this.height];
    const scale = Math.max(1, this.pixelRatio);
    this.lines.draw(this.scaleGroups.slice(0, 2), toClip, size, scale);
    const ground = [0, 1, 2, 3].map((corner) => [...cornerOf(this.box, corner).slice(0, 2), this.levelOf('ground', this.framed)]);
    this.lines.drawGround(toClip, ground, this.ground);
    this.lines.draw([...this.scaleGroups, ...this.groups], toClip, size, scale);
    const cutGroup = new LineGroup(gl, state.cutLines, scene.theme.scale, 1);
    this.lines.draw([cutGroup], toClip, size, scale);
    cutGroup.free();
    this.volume.compose();
    this.drawLetters(camera, state);
  }

  // Of many radars those are named that are far enough apart at this zoom, as DrawLabels of Source/Scene/RadarScene.cxx does.
  isNamed({ spread }, { zoom }) {
    const [west, east] = this.framed;
    return spread === undefined || (zoom * spread * this.width) / (east - west) >= lettersApart * this.textSize;
  }

  drawLetters(camera, state) {
    const { scene, letters } = this;
    letters.clear(this.width, this.height);
    this.makeCaptions(state);
    const radius = Math.max(2, 0.19 * this.textSize);
    const z = this.levelOf('marker', this.framed);
    const radars = scene.radars.map(({ name, place }) => this.withStyle({
      text: name, point: [...place, z], gap: radius + 0.35 * this.textSize,
      sides: ['right', 'above right', 'below right', 'left', 'above left', 'below left', 'above', 'below'],
    }, scene.theme.marker));
    for (const { point } of radars) {
      const place = camera.project(point);
      if (place[2] > 0) {
        letters.disc(place, radius, scene.theme.marker, scene.theme.rim);
      }
    }
    const bar = { left: this.bar.left, right: this.width, bottom: 0, top: this.height };
    const named = radars.filter((_, i) => this.isNamed(scene.radars[i], state.view));
    drawLabels([...this.labels, ...named], camera, [...this.captions.taken(), bar], letters);
    this.captions.draw();
    this.bar.draw(scene.theme.frame);
  }
}

// [x, y, x, y, ...] as points at a height.
function pairs(line, z) {
  const points = [];
  for (let i = 0; i + 1 < line.length; i += 2) {
    points.push([line[i], line[i + 1], z]);
  }
  return points;
}

// A vertical plane through the domain: what lies on the side of `azimuth` of it is drawn. `offset`: -1 to 1, from one end of
// the domain to the other along that direction.
export function makeCut(box, azimuth, offset) {
  const angle = (azimuth * Math.PI) / 180;
  const normal = [Math.sin(angle), Math.cos(angle), 0];
  const middle = [(box[0] + box[1]) / 2, (box[2] + box[3]) / 2];
  const reach = (Math.abs(normal[0]) * (box[1] - box[0]) + Math.abs(normal[1]) * (box[3] - box[2])) / 2;
  const along = normal[0] * middle[0] + normal[1] * middle[1] + offset * reach;
  return { normal, distance: -along };
}

// The line in which a cut meets the ground, and the edges of the plane above it.
export function cutLinesOf(box, { normal, distance }) {
  const ends = [];
  for (const [from, to] of [[0, 1], [1, 3], [3, 2], [2, 0]]) {
    const [a, b] = [cornerOf(box, from), cornerOf(box, to)];
    const [one, two] = [a, b].map((point) => normal[0] * point[0] + normal[1] * point[1] + distance);
    if (one < 0 !== two < 0) {
      const way = subtract(b, a);
      const share = one / (one - two);
      ends.push([a[0] + share * way[0], a[1] + share * way[1]]);
    }
  }
  if (ends.length < 2) {
    return [];
  }
  const at = ([x, y], z) => [x, y, z];
  return [[at(ends[0], box[4]), at(ends[1], box[4]), at(ends[1], box[5]), at(ends[0], box[5]), at(ends[0], box[4])]];
}

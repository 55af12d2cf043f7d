// SPDX-License-Identifier: BSD-3-Clause
// What is shown and when it is drawn: the state of the page, playing, and how fine the picture is.
import { axesOf } from './camera.js';
import { namesOf } from './captions.js';
import { Detail } from './detail.js';
import { cutLinesOf, makeCut } from './scenePicture.js';
import { add, clamp, dot, subtract, times } from './vectors.js';

const fine = { pixels: 1, step: 0.8 };
const slowest = 0.06; // seconds a frame while something moves; if it takes longer, the picture becomes coarser
const fastest = 0.025;
const restDelay = 200; // milliseconds without a movement until the fine picture is drawn

export class Viewer {
  constructor(scene, series, picture, report) {
    Object.assign(this, { scene, series, picture, report });
    this.view = { ...scene.camera };
    this.moved = [0, 0, 0];
    this.settings = {
      preset: scene.preset, strength: 1, surface: null, cut: null, stretch: scene.stretch, speed: 4, blend: true, turning: false,
    };
    this.position = 0; // of the time, in frames from the first on; between two of them when they are blended
    this.playing = false;
    this.moving = 0.5; // share of the pixels along an edge while something moves
    this.listeners = [];
    this.shown = null; // the position whose frames are in the graphics card
    this.framesDrawn = 0;
    this.detail = scene.bricks ? new Detail(scene, series, (detail) => this.showDetail(detail), report) : null;
  }

  whenChanged(listener) {
    this.listeners.push(listener);
  }

  get preset() {
    return this.scene.presets[this.settings.preset];
  }

  get time() {
    return this.series.times[Math.floor(this.position)];
  }

  // Words of the caption about the radars.
  get siteTexts() {
    return this.scene.siteTexts[Math.floor(this.position)] ?? namesOf(this.scene.sites);
  }

  start() {
    this.applyLook();
    this.picture.setStretch(this.settings.stretch);
    this.reset();
    this.showPosition(this.position);
  }

  resize(width, height, pixelRatio) {
    this.picture.resize(width, height, pixelRatio);
    if (this.picture.placed !== null) {
      this.frame();
    }
  }

  frame() {
    this.picture.makeCaptions(this);
    this.picture.frame(this.view);
    this.touch();
  }

  reset() {
    this.view = { ...this.scene.camera };
    this.moved = [0, 0, 0];
    this.frame();
    if (this.scene.camera.lookAt !== null) {
      this.lookAt(this.scene.camera.lookAt);
    }
  }

  // Moves the camera sideways until a place (km east, north and up, not stretched) is in the middle of the picture.
  lookAt([x, y, height]) {
    const { back } = axesOf(this.view);
    const way = subtract([x, y, height * this.settings.stretch], this.picture.placed.focus);
    this.moved = subtract(way, times(back, dot(way, back)));
    this.touch();
  }

  // Changes settings by name.
  set(values) {
    Object.assign(this.settings, values);
    if ('stretch' in values) {
      this.picture.setStretch(values.stretch);
    }
    if ('preset' in values || 'surface' in values) {
      this.applyLook();
      this.shown = null;
      this.showPosition(this.position);
    }
    this.touch();
  }

  byteOf(value) {
    const { first, step } = this.scene.scale;
    return (value - first) / step;
  }

  applyLook() {
    const surfaces = this.settings.surface !== null ? [[this.settings.surface, 0.95]] : this.preset.surfaces;
    this.picture.volume.setLook(this.preset.samples, surfaces.map(([value, opacity]) => [this.byteOf(value), opacity]));
  }

  turn(azimuth, tilt) {
    this.view.azimuth = (((this.view.azimuth + azimuth) % 360) + 360) % 360;
    this.view.tilt = clamp(this.view.tilt + tilt, 0, 90);
    this.touch();
  }

  zoom(factor) {
    this.view.zoom = clamp(this.view.zoom * factor, 0.3, 60);
    this.touch();
  }

  // Moves the scene by so many heights of the picture.
  move(right, up) {
    const axes = axesOf(this.view);
    const height = (this.view.parallel ? 2 : 2 * Math.tan(Math.PI / 12)) * (this.picture.placed.distance / this.view.zoom);
    this.moved = add(this.moved, add(times(axes.right, -right * height), times(axes.up, -up * height)));
    this.touch();
  }

  play(playing) {
    this.playing = playing && this.series.times.length > 1;
    this.last = null;
    this.touch();
  }

  async step(count) {
    this.play(false);
    const whole = count > 0 ? Math.floor(this.position) : Math.ceil(this.position);
    const number = this.series.times.length;
    await this.showPosition((whole + count + number) % number);
  }

  // Loads what a position needs and shows it. The latest call counts.
  async showPosition(position) {
    this.wanted = position;
    const index = Math.floor(position);
    const share = position - index;
    try {
      const [frame, next] = await Promise.all(
        [this.series.load(index), share > 0 ? this.series.load(index + 1) : null]);
      if (this.wanted !== position) {
        return;
      }
      this.position = position;
      this.shown = { frame, next, share };
      this.shownTime = this.series.times[index];
      this.picture.volume.setFrames(frame, next, share);
      this.report('');
    } catch (problem) {
      this.play(false);
      this.report(problem.message);
    }
    this.touch();
  }

  // The series has other times than before. The newest one is followed; any other stays, or the one before it when it is gone.
  async grow(wasNewest) {
    const { times } = this.series;
    const kept = times.findLastIndex((time) => time <= this.shownTime);
    await this.showPosition(wasNewest && !this.playing ? times.length - 1 : Math.max(kept, 0));
  }

  isNewest() {
    return Math.floor(this.position) === this.series.times.length - 1;
  }

  // Something changed: draws a picture soon, and a fine one when nothing moves any more.
  touch() {
    this.lastTouch = performance.now();
    this.schedule();
    this.listeners.forEach((listener) => listener());
  }

  schedule() {
    if (!this.scheduled) {
      this.scheduled = true;
      requestAnimationFrame((now) => this.tick(now));
    }
  }

  showDetail(detail) {
    if (this.picture.volume.setDetail(detail)) {
      this.schedule();
    }
  }

  followDetail() {
    if (this.detail !== null && this.shown !== null && !(this.shown.share > 0)) {
      const { picture } = this;
      this.detail.follow(Math.floor(this.position), this.shown.frame, picture.findSeen(this), picture.box);
    }
  }

  isMoving(now) {
    return this.playing || this.settings.turning || now - this.lastTouch < restDelay;
  }

  tick(now) {
    this.scheduled = false;
    const seconds = this.last ? Math.min((now - this.last) / 1000, 0.5) : 0;
    this.last = now;
    if (this.settings.turning) {
      this.view.azimuth = (this.view.azimuth + 12 * seconds) % 360;
    }
    if (this.playing) {
      this.advance(seconds);
    }
    const moving = this.isMoving(now) && this.drewOnce;
    if (this.shown !== null) {
      this.adapt(seconds);
      this.draw(moving ? { pixels: this.moving, step: this.moving < 0.5 ? 1.6 : 1.1 } : fine);
      this.drewOnce = true;
    }
    if (moving) {
      this.schedule();
    } else {
      this.last = null;
      this.followDetail();
    }
  }

  // While it plays, the time goes on by whole frames or, blended, by parts of them. A frame that is not loaded yet is waited
  // for; the next ones are loaded in advance.
  advance(seconds) {
    const number = this.series.times.length;
    this.pace = Math.min((this.pace ?? 0) + seconds * this.settings.speed, 1);
    const target = this.position + this.pace;
    const next = this.settings.blend ? target : Math.floor(target);
    if (next <= this.position || this.busy) {
      return;
    }
    this.pace = this.settings.blend ? 0 : this.pace - 1;
    this.busy = true;
    const position = next > number - 1 ? (this.settings.blend && next < number - 0.5 ? number - 1 : 0) : next;
    this.series.load((Math.floor(position) + 2) % number).catch(() => {});
    this.showPosition(position).finally(() => {
      this.busy = false;
    });
  }

  // Finds how many pixels the graphics can draw in time.
  adapt(seconds) {
    if (seconds > slowest) {
      this.moving = Math.max(this.moving * 0.85, 0.2);
    } else if (seconds > 0 && seconds < fastest) {
      this.moving = Math.min(this.moving * 1.05, 1);
    }
  }

  draw(quality) {
    const { settings } = this;
    const cut = settings.cut === null ? null : makeCut(this.picture.box, settings.cut.azimuth, settings.cut.offset);
    this.picture.draw({
      view: this.view, moved: this.moved, time: this.time, siteTexts: this.siteTexts, preset: this.preset, strength: settings.strength, quality, cut,
      cutLines: cut === null ? [] : cutLinesOf(this.picture.box, cut),
    });
    this.framesDrawn++;
  }
}

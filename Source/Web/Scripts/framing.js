// SPDX-License-Identifier: BSD-3-Clause
// Places the camera so that the scene is as large as it can be without covering the captions, as
// Source/Scene/Frame/Framing.cxx does for pictures of the program. Pixels count from the lower left corner.
import { Camera, fitCamera } from './camera.js';

const margin = 0.03; // between the scene and the edges of the picture, of its height
const pad = 4; // pixels between words and the edges of the picture
export const steepTilt = 70; // degrees; from here on the scene is seen as a map, and heights have no length

export function sharedArea(a, b) {
  const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
  const height = Math.min(a.top, b.top) - Math.max(a.bottom, b.bottom);
  return width > 0 && height > 0 ? width * height : 0;
}

// Where a word stands beside its point; `size` is the word's width and height.
export function boxBeside([x, y], side, gap, [width, height]) {
  const across = side.includes('left') ? -1 : side.includes('right') ? 1 : 0;
  const upward = side.includes('above') ? 1 : side.includes('below') ? -1 : 0;
  const distance = across !== 0 && upward !== 0 ? 0.5 * gap : gap;
  const corner = (direction, extent) =>
    direction > 0 ? distance : direction < 0 ? -distance - extent : -0.5 * extent;
  const left = x + corner(across, width);
  const bottom = y + corner(upward, height);
  return { left, bottom, right: left + width, top: bottom + height };
}

// Whether the line between two points enters a rectangle (Liang and Barsky 1984).
function crossesRectangle(from, to, box) {
  let enters = 0;
  let leaves = 1;
  const edges = [
    [from[0] - to[0], from[0] - box.left], [to[0] - from[0], box.right - from[0]],
    [from[1] - to[1], from[1] - box.bottom], [to[1] - from[1], box.top - from[1]],
  ];
  for (const [outward, room] of edges) {
    if (outward === 0) {
      if (room < 0) {
        return false;
      }
    } else if (outward < 0) {
      enters = Math.max(enters, room / outward);
    } else {
      leaves = Math.min(leaves, room / outward);
    }
  }
  return enters < leaves;
}

class Framing {
  // `scene`: outline (points) and labels (text, point, side, gap, size); `space`: width, height, right (where the colour
  // bar begins) and taken (boxes of captions).
  constructor(view, scene, space) {
    Object.assign(this, { view, scene, space });
    this.gap = margin * space.height;
  }

  whole() {
    const { width, height, right } = this.space;
    return { left: this.gap, bottom: this.gap, right: Math.min(right, width) - this.gap, top: height - this.gap };
  }

  isUpper(caption) {
    return caption.bottom + caption.top > this.space.height;
  }

  betweenCaptions() {
    const box = this.whole();
    for (const caption of this.space.taken) {
      if (this.isUpper(caption)) {
        box.top = Math.min(box.top, caption.bottom - this.gap);
      } else {
        box.bottom = Math.max(box.bottom, caption.top + this.gap);
      }
    }
    return box;
  }

  besideCaptions() {
    const box = { ...this.betweenCaptions(), top: this.whole().top };
    for (const caption of this.space.taken.filter((taken) => this.isUpper(taken))) {
      box.left = Math.max(box.left, caption.right + this.gap);
    }
    return box;
  }

  leaveRoomForWords(box) {
    const most = (side, axis) => Math.max(0,
      ...this.scene.labels.filter((label) => label.sides[0] === side).map((label) => label.size[axis]));
    return { ...box, left: box.left + most('left', 0), bottom: box.bottom + most('below', 1) };
  }

  // Moves one edge outwards as far as the picture allows.
  grow(box, edge, outermost) {
    const at = (share) => ({ ...box, [edge]: box[edge] + share * (outermost - box[edge]) });
    if (this.isFree(at(1))) {
      return at(1);
    }
    let good = 0;
    let bad = 1;
    for (let i = 1; i < 10; i++) {
      const share = (good + bad) / 2;
      if (this.isFree(at(share))) {
        good = share;
      } else {
        bad = share;
      }
    }
    return at(good);
  }

  largest(start) {
    const whole = this.whole();
    let box = this.leaveRoomForWords(start);
    for (const edge of ['top', 'bottom', 'left']) {
      box = this.grow(box, edge, whole[edge]);
    }
    return box;
  }

  place(box) {
    const { width, height } = this.space;
    const area = {
      left: (2 * box.left) / width - 1, right: (2 * box.right) / width - 1,
      bottom: (2 * box.bottom) / height - 1, top: (2 * box.top) / height - 1,
    };
    return fitCamera(this.view, this.scene.outline, width / height, area);
  }

  camera(box) {
    return new Camera({ ...this.view, zoom: 1 }, this.place(box), this.space.width, this.space.height);
  }

  // Whether a scene that fills the box covers no caption, and its words neither cover one nor leave the picture.
  isFree(box) {
    const camera = this.camera(box);
    const places = this.scene.outline.map((point) => camera.project(point));
    return !this.space.taken.some((caption) => this.crosses(places, caption)) &&
      this.scene.labels.every((label) => this.isLabelFree(label, camera));
  }

  isLabelFree(label, camera) {
    const box = boxBeside(camera.project(label.point), label.sides[0], label.gap, label.size);
    const { right, height, taken } = this.space;
    return box.left >= pad && box.bottom >= pad && box.right <= right && box.top <= height - pad &&
      !taken.some((caption) => sharedArea(caption, box) > 0);
  }

  // The points are the corners of a body, so nothing of it lies beyond the lines between them.
  crosses(places, caption) {
    const wider = {
      left: caption.left - this.gap, right: caption.right + this.gap,
      bottom: caption.bottom - this.gap, top: caption.top + this.gap,
    };
    return places.some((from, i) => places.slice(i + 1).some((to) => crossesRectangle(from, to, wider)));
  }

  isUsable(box) {
    return box.left < box.right && box.bottom < box.top && this.isFree(box);
  }
}

export function frameScene(view, scene, space) {
  const framing = new Framing(view, scene, space);
  let box = framing.largest(framing.betweenCaptions());
  if (Math.abs(view.tilt) >= steepTilt) {
    const other = framing.largest(framing.besideCaptions());
    const distance = (candidate) => (framing.isUsable(candidate) ? framing.place(candidate).distance : Infinity);
    box = distance(other) < distance(box) ? other : box;
  }
  return framing.place(box);
}

// SPDX-License-Identifier: BSD-3-Clause
// From where the scene is looked at. Scene coordinates are km east and north of the middle of the map, and km above mean
// sea level times the stretch of heights. The formulas are those of Source/Scene/Frame/CameraView.cxx.
import { add, dot, radians, subtract, times } from './vectors.js';

const viewAngle = 30; // degrees, vertical, at zoom 1

// Unit vectors of the picture: to the right, up, and from the scene to the camera. `azimuth` is the direction of the
// camera as seen from the scene, degrees clockwise from north; `tilt` its angle above the horizon.
export function axesOf({ azimuth, tilt }) {
  const [sinA, cosA] = [Math.sin(azimuth * radians), Math.cos(azimuth * radians)];
  const [sinT, cosT] = [Math.sin(tilt * radians), Math.cos(tilt * radians)];
  return {
    right: [-cosA, sinA, 0],
    up: [-sinA * sinT, -cosA * sinT, cosT],
    back: [sinA * cosT, cosA * cosT, sinT],
  };
}

// What one direction of the picture (across or up) asks of the camera. A point at the offset o along that direction, z
// nearer to the camera than the middle, is inside the picture's edge e when o - offset <= e * t * (distance - z), with t
// the tangent of the half angle of view. Every point bounds offset + e * t * distance.
class Extent {
  constructor(lowEdge, highEdge) {
    this.lowEdge = lowEdge;
    this.highEdge = highEdge;
    this.low = Infinity;
    this.high = -Infinity;
  }
  add(along, nearer) {
    this.high = Math.max(this.high, along + this.highEdge * nearer);
    this.low = Math.min(this.low, along + this.lowEdge * nearer);
  }
  distance() {
    return (this.high - this.low) / (this.highEdge - this.lowEdge);
  }
  offset(distance) {
    return (this.high - this.highEdge * distance + this.low - this.lowEdge * distance) / 2;
  }
}

function middleOf(points) {
  return [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  });
}

// Where the camera stands so that the points just fill an area of the picture (left, right, bottom, top, each -1 to 1):
// the place that it looks at and its distance. In parallel projection the distance is half the height of the view.
export function fitCamera(view, points, aspect, area) {
  const axes = axesOf(view);
  const centre = middleOf(points);
  const half = view.parallel ? 1 : Math.tan((viewAngle / 2) * radians);
  const across = new Extent(area.left * half * aspect, area.right * half * aspect);
  const upward = new Extent(area.bottom * half, area.top * half);
  for (const point of points) {
    const way = subtract(point, centre);
    const nearer = view.parallel ? 0 : dot(way, axes.back);
    across.add(dot(way, axes.right), nearer);
    upward.add(dot(way, axes.up), nearer);
  }
  const distance = Math.max(across.distance(), upward.distance());
  const sideways = add(times(axes.right, across.offset(distance)), times(axes.up, upward.offset(distance)));
  return { focus: add(centre, sideways), distance };
}

// A camera that stands at `placed` (what fitCamera returned) and looks in the direction of `view`, for a picture of
// `width` and `height` in pixels.
export class Camera {
  constructor(view, placed, width, height) {
    const axes = axesOf(view);
    Object.assign(this, axes);
    this.width = width;
    this.height = height;
    this.parallel = view.parallel;
    this.aspect = width / height;
    // Half the height of the picture: of a picture at distance 1, or of the picture itself in parallel projection.
    this.half = view.parallel ? placed.distance / view.zoom : Math.tan((viewAngle / 2 / view.zoom) * radians);
    this.position = add(placed.focus, times(axes.back, view.parallel ? 4 * placed.distance : placed.distance));
  }

  // Pixels from the lower left corner, and the depth: the distance along the direction of view. A point behind the camera
  // has a depth below 0.
  project(point) {
    const way = subtract(point, this.position);
    const depth = -dot(way, this.back);
    const scale = (this.parallel ? 1 : 1 / Math.max(depth, 1e-9)) / this.half;
    return [
      (1 + (dot(way, this.right) * scale) / this.aspect) * 0.5 * this.width,
      (1 + dot(way, this.up) * scale) * 0.5 * this.height,
      depth,
    ];
  }

  // The rays of the picture: a ray at (x, y), each -1 to 1, begins at origin + x * originX + y * originY and runs along
  // direction + x * directionX + y * directionY.
  rays() {
    const x = times(this.right, this.half * this.aspect);
    const y = times(this.up, this.half);
    const none = [0, 0, 0];
    const moves = this.parallel
      ? { originX: x, originY: y, directionX: none, directionY: none }
      : { originX: none, originY: none, directionX: x, directionY: y };
    return { origin: this.position, direction: times(this.back, -1), ...moves };
  }
}

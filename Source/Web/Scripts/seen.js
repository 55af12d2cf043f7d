// SPDX-License-Identifier: BSD-3-Clause
// What a picture shows of a box, as FindSeen of Source/Scene/Frame/CameraView.cxx finds it.
import { add, dot, subtract, times } from './vectors.js';

const nearest = 1; // km from the camera to what it sees

// The edges of the picture as planes of the scene: dot(normal, place - position) + distance is 0 or more within them.
function planesOf({ right, up, back, half, aspect, parallel }) {
  const forward = times(back, -1);
  const edge = (axis, reach) => (parallel
    ? { normal: axis, distance: reach }
    : { normal: add(axis, times(forward, reach)), distance: 0 });
  return [
    edge(right, half * aspect), edge(times(right, -1), half * aspect), edge(up, half), edge(times(up, -1), half),
    { normal: forward, distance: -nearest },
  ];
}

// The part of a convex polygon on one side of a plane (Sutherland and Hodgman 1974).
function clipPolygon(points, sideOf) {
  return points.flatMap((point, i) => {
    const before = points.at(i - 1);
    const [here, there] = [sideOf(point), sideOf(before)];
    const crossing = here < 0 !== there < 0 ? [add(before, times(subtract(point, before), there / (there - here)))] : [];
    return here < 0 ? crossing : [...crossing, point];
  });
}

// The six faces of a box, each with its corners in turn.
function facesOf(box) {
  return [0, 1, 2].flatMap((axis) => [0, 1].map((side) => [[0, 0], [1, 0], [1, 1], [0, 1]].map(([a, b]) => {
    const corner = [];
    corner[axis] = box[2 * axis + side];
    corner[(axis + 1) % 3] = box[2 * ((axis + 1) % 3) + a];
    corner[(axis + 2) % 3] = box[2 * ((axis + 2) % 3) + b];
    return corner;
  })));
}

// The corners of the picture just before the camera.
function cornersBefore({ position, right, up, back, half, aspect, parallel }) {
  const reach = half * (parallel ? 1 : nearest);
  const middle = subtract(position, times(back, nearest));
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) =>
    add(middle, add(times(right, x * reach * aspect), times(up, y * reach))));
}

// `faces`: west, east, south and north ends of the part of a box that a camera shows; `pixel`: the side of a pixel where that
// part is nearest to the camera. Scene units. Null where it shows none.
export function findSeen(camera, box) {
  const sides = planesOf(camera).map(({ normal, distance }) =>
    (point) => dot(normal, subtract(point, camera.position)) + distance);
  const onFaces = facesOf(box).flatMap((face) => sides.reduce(clipPolygon, face));
  const isWithin = (point) => point.every((part, axis) => part >= box[2 * axis] && part <= box[2 * axis + 1]);
  const points = [...onFaces, ...cornersBefore(camera).filter(isWithin)];
  if (points.length === 0) {
    return null;
  }
  const along = (axis) => points.map((point) => point[axis]);
  const depths = points.map((point) => dot(subtract(camera.position, point), camera.back));
  const depth = camera.parallel ? 1 : Math.min(...depths);
  return {
    faces: [Math.min(...along(0)), Math.max(...along(0)), Math.min(...along(1)), Math.max(...along(1))],
    pixel: (2 * camera.half * depth) / camera.height,
  };
}

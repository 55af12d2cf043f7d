// SPDX-License-Identifier: BSD-3-Clause
// The lines that tell sizes: edges of the domain, lines of equal height on the two walls behind it, a scale of heights, a
// bar of a round length and an arrow to the north. They follow Source/Scene/Scales. A line is a list of points.
import { axesOf } from './camera.js';
import { steepTilt } from './framing.js';


// Corner of the domain: bit 0 of the index is east, bit 1 north, bit 2 top.
export function cornerOf(box, index) {
  return [box[index & 1], box[2 + ((index >> 1) & 1)], box[4 + (index >> 2)]];
}

function farthestCorner(box, [east, north]) {
  const along = [0, 1, 2, 3].map((corner) => {
    const [x, y] = cornerOf(box, corner);
    return x * east + y * north;
  });
  return along.indexOf(Math.max(...along));
}

// The largest of 1, 2, 5, 10, 20, 50, ... that is at most the limit.
export function roundLength(limit) {
  const decade = 10 ** Math.floor(Math.log10(limit));
  const factor = [5, 2].find((candidate) => candidate * decade <= limit * (1 + 1e-9)) ?? 1;
  return factor * decade;
}

// Round heights in the domain, in km above mean sea level.
export function roundHeights(box, stretch) {
  const [bottom, top] = [box[4] / stretch, box[5] / stretch];
  const step = roundLength((top - bottom) / 3);
  const heights = [];
  for (let count = Math.ceil(bottom / step); count * step <= top + 1e-6; count++) {
    heights.push(count * step);
  }
  return heights;
}

function edgesOf(box, nearest, open) {
  const lines = [];
  for (let corner = 0; corner < 8; corner++) {
    for (const axis of [1, 2, 4]) {
      const other = corner | axis;
      // Above the ground, the edges that end at the nearest corner lie before the echo.
      const before = other >= 4 && ((corner & 3) === nearest || (other & 3) === nearest);
      if (other !== corner && !(open && before)) {
        lines.push([cornerOf(box, corner), cornerOf(box, other)]);
      }
    }
  }
  return lines;
}

function heightLines(box, stretch, nearest) {
  return roundHeights(box, stretch)
    .map((height) => height * stretch)
    .filter((z) => z > box[4] && z < box[5])
    .map((z) => [nearest ^ 1, nearest ^ 3, nearest ^ 2].map((corner) => [...cornerOf(box, corner).slice(0, 2), z]));
}

// The edge of the ground that faces the camera most, and places before it.
class NearEdge {
  constructor(box, right) {
    const toCamera = [right[1], -right[0]];
    this.box = box;
    this.axis = Math.abs(toCamera[1]) >= Math.abs(toCamera[0]) ? 0 : 1;
    this.across = 1 - this.axis;
    this.outward = toCamera[this.across] > 0 ? 1 : -1;
    this.sign = right[this.axis] > 0 ? 1 : -1;
  }
  width() {
    return this.box[2 * this.axis + 1] - this.box[2 * this.axis];
  }
  // So far along the edge from its end on the right of the picture, and so far before it.
  at(along, before) {
    const point = [0, 0, this.box[4]];
    point[this.axis] = this.box[2 * this.axis + (this.sign > 0 ? 1 : 0)] - this.sign * along;
    point[this.across] = this.box[2 * this.across + (this.outward > 0 ? 1 : 0)] + this.outward * before;
    return point;
  }
}

function lengthBar(edge, letters) {
  const length = roundLength(edge.width() / 4);
  const tick = 0.015 * edge.width();
  const before = 2 * tick;
  const across = (along) => [edge.at(along, before - 0.5 * tick), edge.at(along, before + 0.5 * tick)];
  return {
    lines: [across(0), across(length), [edge.at(0, before), edge.at(length, before)]],
    outline: [edge.at(0, before + tick), edge.at(length, before + tick)],
    label: { text: `${length} km`, point: edge.at(length / 2, before + 0.5 * tick), sides: ['below'], gap: 0.25 * letters },
  };
}

function northArrow(edge, letters) {
  const length = 0.055 * edge.width();
  const runsNorth = edge.axis === 1;
  const before = (runsNorth ? 0.5 : 0.3) * length;
  const one = edge.at(edge.width() - 0.4 * length, before);
  const two = runsNorth
    ? edge.at(edge.width() - 1.4 * length, before)
    : edge.at(edge.width() - 0.4 * length, before + length);
  const tail = one[1] < two[1] ? one : two;
  const at = (east, north) => [tail[0] + east * length, tail[1] + north * length, tail[2]];
  return {
    lines: [[at(0, 0), at(0, 1)], [at(-0.25, 0.6), at(0, 1), at(0.25, 0.6)]],
    outline: [at(0, 0), at(0, 1)],
    label: { text: 'N', point: at(0, 0.5), sides: ['right', 'left'], gap: 0.6 * letters },
  };
}

function heightScale(box, stretch, right, letters) {
  const foot = cornerOf(box, farthestCorner(box, [-right[0], -right[1]]));
  const tick = 0.012 * (box[1] - box[0]);
  const heights = roundHeights(box, stretch);
  const ends = heights.map((height) => [foot[0] - tick * right[0], foot[1] - tick * right[1], height * stretch]);
  return {
    lines: ends.map((end) => [[foot[0], foot[1], end[2]], end]),
    labels: ends.map((end, i) => ({
      text: `${heights[i]}${i + 1 === heights.length ? ' km' : ''}`, point: end, sides: ['left'], gap: 0.3 * letters,
    })),
  };
}

// `letters`: height of the letters in pixels. Edges, walls and ticks are lines of their own colours.
export function makeScales(box, stretch, view, letters) {
  const { right } = axesOf(view);
  const nearest = farthestCorner(box, [right[1], -right[0]]);
  const steep = Math.abs(view.tilt) >= steepTilt;
  const edge = new NearEdge(box, right);
  const bar = lengthBar(edge, letters);
  const arrow = northArrow(edge, letters);
  const heights = steep ? { lines: [], labels: [] } : heightScale(box, stretch, right, letters);
  return {
    edges: edgesOf(box, nearest, !steep),
    walls: steep ? [] : heightLines(box, stretch, nearest),
    ticks: [...heights.lines, ...bar.lines, ...arrow.lines],
    labels: [...heights.labels, bar.label, arrow.label],
    outline: [...Array(8).keys()].map((corner) => cornerOf(box, corner)).concat(bar.outline, arrow.outline),
  };
}

// SPDX-License-Identifier: BSD-3-Clause
// Words at points of the scene: on which side of its point each one stands, as Source/Scene/Frame/LabelLayout.cxx has it.
import { boxBeside, sharedArea } from './framing.js';

function areaOutside(box, width, height) {
  const whole = { left: 0, bottom: 0, right: width, top: height };
  return (box.right - box.left) * (box.top - box.bottom) - sharedArea(box, whole);
}

// Draws the labels (text, point, sides, gap, size, style), each on the first side on which it covers nothing: neither
// `taken`, nor a label before it, nor the point of another label; where there is none, on the side where it covers least.
export function drawLabels(labels, camera, taken, letters) {
  const boxes = [...taken];
  const places = labels.map((label) => camera.project(label.point));
  labels.forEach((label, i) => {
    const radius = 0.5 * label.gap;
    const [x, y] = places[i];
    boxes.push({ left: x - radius, right: x + radius, bottom: y - radius, top: y + radius });
  });
  labels.forEach((label, i) => {
    if (places[i][2] <= 0) {
      return; // behind the camera
    }
    const candidates = label.sides.map((side) => {
      const box = boxBeside(places[i], side, label.gap, label.size);
      const covered = boxes.reduce((sum, other) => sum + sharedArea(box, other),
        areaOutside(box, camera.width, camera.height));
      return { side, box, covered };
    });
    const best = candidates.reduce((a, b) => (b.covered < a.covered ? b : a));
    letters.draw(label.text, label.style, places[i], best.side, label.gap);
    boxes.push(best.box);
  });
}

// SPDX-License-Identifier: BSD-3-Clause
// Mouse, pen, fingers and keys on the picture.

const degreesPerHeight = 180; // of the camera for a way as long as the picture is high

function middleOfPointers(points) {
  const sum = points.reduce((total, point) => [total[0] + point.x, total[1] + point.y], [0, 0]);
  return { x: sum[0] / points.length, y: sum[1] / points.length };
}

function spreadOf([a, b]) {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

// One pointer turns the scene; with Shift or another button it moves it; two fingers move and zoom.
export function watchPointers(element, viewer) {
  const pointers = new Map();
  const moveScene = (event, dx, dy) => {
    const height = element.clientHeight;
    if (event.shiftKey || event.buttons > 1) {
      viewer.move(dx / height, -dy / height);
    } else {
      viewer.turn((dx / height) * degreesPerHeight, (dy / height) * degreesPerHeight);
    }
  };
  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  element.addEventListener('pointermove', (event) => {
    if (!pointers.has(event.pointerId)) {
      return;
    }
    const before = [...pointers.values()];
    const here = { x: event.clientX, y: event.clientY };
    const last = pointers.get(event.pointerId);
    pointers.set(event.pointerId, here);
    const after = [...pointers.values()];
    if (after.length === 1) {
      moveScene(event, here.x - last.x, here.y - last.y);
    } else if (after.length === 2) {
      const [from, to] = [middleOfPointers(before), middleOfPointers(after)];
      viewer.move((to.x - from.x) / element.clientHeight, -(to.y - from.y) / element.clientHeight);
      viewer.zoom(spreadOf(after) / Math.max(spreadOf(before), 1));
    }
  });
  for (const name of ['pointerup', 'pointercancel']) {
    element.addEventListener(name, (event) => pointers.delete(event.pointerId));
  }
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    viewer.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)));
  }, { passive: false });
}

// Keys work wherever the focus is, except in fields that take them themselves.
export function watchKeys(document, viewer, showPanel) {
  const actions = {
    ' ': () => viewer.play(!viewer.playing),
    ArrowLeft: () => viewer.step(-1),
    ArrowRight: () => viewer.step(1),
    a: () => viewer.turn(-5, 0),
    d: () => viewer.turn(5, 0),
    w: () => viewer.turn(0, 5),
    x: () => viewer.turn(0, -5),
    '+': () => viewer.zoom(1.15),
    '-': () => viewer.zoom(1 / 1.15),
    r: () => viewer.reset(),
    t: () => viewer.set({ turning: !viewer.settings.turning }),
    h: showPanel,
  };
  document.addEventListener('keydown', (event) => {
    const taken = event.target.closest?.('input, select, button, a');
    const isArrow = event.key.startsWith('Arrow') || event.key === ' ';
    if (event.ctrlKey || event.altKey || event.metaKey || (taken && isArrow)) {
      return;
    }
    const number = Number(event.key);
    if (number >= 1 && number <= viewer.scene.presets.length) {
      viewer.set({ preset: number - 1, surface: null });
      event.preventDefault();
    } else if (actions[event.key]) {
      actions[event.key]();
      event.preventDefault();
    }
  });
}

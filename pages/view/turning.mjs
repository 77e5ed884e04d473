// SPDX-License-Identifier: GPL-3.0-or-later
// How pointers, the wheel and keys turn, zoom and move what is drawn on a canvas.

// Distance of the first two pointers.
function spread(pointers) {
  const [a, b] = [...pointers.values()];
  return Math.hypot(a.x - b.x, a.y - b.y);
}

// One pointer turns, or moves with Shift or the right button; two pinch. Lengths are parts of the canvas' height.
function listenToPointers(canvas, { turn, move, zoom, hover, leave }) {
  const pointers = new Map();
  const at = (event) => ({ x: event.clientX, y: event.clientY });
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, at(event));
    leave();
  });
  for (const end of ['pointerup', 'pointercancel']) {
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  canvas.addEventListener('pointermove', (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) {
      hover(event);
      return;
    }
    const before = pointers.size > 1 ? spread(pointers) : 0;
    pointers.set(event.pointerId, at(event));
    const [x, y] = [event.clientX - last.x, event.clientY - last.y].map((way) => way / canvas.clientHeight);
    if (pointers.size > 1) zoom(spread(pointers) / Math.max(1, before));
    else if (event.shiftKey || event.buttons === 2) move(x, y);
    else turn(Math.PI * x, Math.PI * y);
  });
  canvas.addEventListener('pointerleave', leave);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
}

// Calls turn(x, y), move(x, y), zoom(factor), reset(), hover(event) and leave().
export function listenToTurning(canvas, handlers) {
  const { turn, move, zoom, reset } = handlers;
  listenToPointers(canvas, handlers);
  canvas.addEventListener('dblclick', reset);
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoom(Math.exp(-0.0015 * event.deltaY * (event.deltaMode === 1 ? 33 : 1)));
  }, { passive: false });
  canvas.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
    const factor = { '+': 1.1, '=': 1.1, '-': 1 / 1.1 }[event.key];
    if (!step && !factor) return;
    event.preventDefault();
    if (factor) zoom(factor);
    else if (event.shiftKey) move(...step);
    else turn(...step);
  });
}

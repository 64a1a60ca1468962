// SPDX-License-Identifier: MIT
// Path and curves by keys, for who has no pointer.

const TURN = Math.PI / 24; // [rad]
const MOVE = 40; // [px]
const GROW = 1.3;
const STEP = 0.01; // of what the curves show
const FAR = 0.1;

// Calls the action of a key; what another part of the browser is asked by stays its own.
function bind(box, actions) {
  box.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action(event.shiftKey);
  });
}

export function pathKeys(box, scene, ask) {
  const arrow = (right, up) => (isMove) => {
    if (isMove) scene.move(MOVE * right, -MOVE * up);
    else scene.swing(TURN * right, TURN * up);
  };
  bind(box, {
    ArrowLeft: arrow(-1, 0), ArrowRight: arrow(1, 0), ArrowUp: arrow(0, 1), ArrowDown: arrow(0, -1),
    "+": () => scene.zoom(GROW), "=": () => scene.zoom(GROW), "-": () => scene.zoom(1 / GROW),
    Home: () => ask.whole(), 0: () => ask.whole(),
    ".": () => ask.point(1), ",": () => ask.point(-1),
  });
}

export function curveKeys(box, curves) {
  const step = (share) => (isFar) => curves.step(share * (isFar ? FAR / STEP : 1));
  bind(box, {
    ArrowLeft: step(-STEP), ArrowRight: step(STEP),
    ArrowUp: () => curves.grow(1 / GROW), ArrowDown: () => curves.grow(GROW),
    "+": () => curves.grow(1 / GROW), "=": () => curves.grow(1 / GROW),
    "-": () => curves.grow(GROW),
    Home: () => curves.end(false), End: () => curves.end(true), 0: () => curves.whole(),
  });
}

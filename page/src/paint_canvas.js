// SPDX-License-Identifier: MIT
// Draws pieces of path on a 2-D canvas: the first picture, and all where there is no WebGL.

const STEPS = 24; // levels of each colour: pieces of one colour are one stroke
const KEYS = 32 ** 3;
const BROAD_MOST = 10_000; // pieces: broad strokes of more take ten times as long as thin ones

export function makeCanvas(holder) {
  const canvas = document.createElement("canvas");
  canvas.className = "paint";
  holder.prepend(canvas);
  const pen = canvas.getContext("2d");
  let pieces = null;
  let background = "";
  let order = new Uint32Array(0);
  let keys = new Uint16Array(0);

  // The colour of a piece, in few enough levels.
  function keyOf(k) {
    const { colours } = pieces;
    let key = 0;
    for (let c = 0; c < 3; c++) {
      const mean = (colours[6 * k + c] + colours[6 * k + 3 + c]) / 2;
      key = key * 32 + Math.round((mean / 255) * STEPS);
    }
    return key;
  }

  const part = (key, shift) => Math.round((255 * ((key >> shift) & 31)) / STEPS);

  return {
    kind: "canvas",
    remove: () => canvas.remove(),
    ground(colour) { background = colour; },
    resize(width, height) {
      const ratio = window.devicePixelRatio;
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
    },
    take(taken) {
      pieces = taken;
      const { count } = pieces;
      keys = new Uint16Array(count);
      const begins = new Uint32Array(KEYS + 1);
      for (let k = 0; k < count; k++) {
        keys[k] = keyOf(k);
        begins[keys[k] + 1]++;
      }
      for (let key = 0; key < KEYS; key++) begins[key + 1] += begins[key];
      order = new Uint32Array(count);
      for (let k = 0; k < count; k++) order[begins[keys[k]]++] = k;
    },
    // m: the matrix of the camera, column by column.
    draw(camera, m) {
      const { width, height } = canvas;
      pen.fillStyle = background;
      pen.fillRect(0, 0, width, height);
      pen.lineWidth = (pieces.count > BROAD_MOST ? 1 : 1.8) * window.devicePixelRatio;
      pen.lineCap = "round";
      const p = pieces.positions;
      const across = (at) => (0.5 + 0.5 * (m[0] * p[at] + m[4] * p[at + 1] + m[8] * p[at + 2]
        + m[12])) * width;
      const down = (at) => (0.5 - 0.5 * (m[1] * p[at] + m[5] * p[at + 1] + m[9] * p[at + 2]
        + m[13])) * height;
      let key = -1;
      for (const k of order) {
        if (keys[k] !== key) {
          if (key >= 0) pen.stroke();
          key = keys[k];
          pen.strokeStyle = `rgb(${part(key, 10)},${part(key, 5)},${part(key, 0)})`;
          pen.beginPath();
        }
        pen.moveTo(across(6 * k), down(6 * k));
        pen.lineTo(across(6 * k + 3), down(6 * k + 3));
      }
      if (key >= 0) pen.stroke();
    },
  };
}

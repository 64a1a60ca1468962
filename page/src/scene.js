// SPDX-License-Identifier: MIT
// The path in space: the camera, which pieces are drawn, what lies under the pointer.
import { Matrix4, OrthographicCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { painter } from "./colours.js";
import { momentOf } from "./data.js";
import { makeLevels } from "./levels.js";
import { makeCanvas } from "./paint_canvas.js";
import { makeGl } from "./paint_gl.js";

const GROUND = { screen: "#10161f", paper: "#ffffff" };
const FLAT = 0.12; // a part whose height is less of its width is looked at from above
const REACH = 14; // what is further from the pointer is not meant [px]
const SHARP = 0.7; // what is left out is nearer to what is drawn [px]

// Where the views look from.
const VIEWS = { Iso: [-1, -1.2, 0.9], Top: [0, -1e-4, 1], Front: [0, -1, 0], Right: [1, 0, 0] };
const LATHE = { "Z X": [0, 1, 0], Iso: [0.6, 1, -0.5] };

function boundsOf(model) {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  const take = (i) => [model.x[i], model.y[i], model.z[i]].forEach((value, d) => {
    least[d] = Math.min(least[d], value);
    most[d] = Math.max(most[d], value);
  });
  for (let i = 1; i < model.n; i++) {
    if (model.isRapid(i) || model.rests(i)) continue;
    take(i - 1);
    take(i);
  }
  if (!(most[0] >= least[0])) for (let i = 0; i < model.n; i++) take(i);
  return { least, most };
}

export function makeScene(holder, facts, model) {
  const bounds = boundsOf(model);
  const size = bounds.most.map((high, d) => high - bounds.least[d]);
  const extent = Math.max(Math.hypot(...size), 1e-3);
  const centre = bounds.most.map((high, d) => 0.5 * (high + bounds.least[d]));
  const levels = makeLevels(model, extent);
  const views = facts.lathe ? LATHE : VIEWS;
  const camera = new OrthographicCamera(-1, 1, 1, -1, -20 * extent, 20 * extent);
  camera.up.set(...(facts.lathe ? [1, 0, 0] : [0, 0, 1]));
  const matrix = new Matrix4();
  let paint = makeCanvas(holder);
  const over = holder.querySelector("canvas#over");
  const controls = new OrbitControls(camera, over);
  controls.zoomToCursor = true;
  controls.enableDamping = false;
  let wide = 1;
  let high = 1;
  let look = { mode: null, rapids: true, chosen: null, within: null };
  const most = model.n;
  const pieces = {
    count: 0, positions: new Float32Array(6 * most), colours: new Uint8Array(6 * most),
    from: new Uint32Array(most), to: new Uint32Array(most),
  };
  const listeners = [];
  let stale = true;
  let due = 0;

  // The first picture is the canvas's, which needs nobody, of few points. All of them come behind
  // it, and WebGL takes over once it has drawn: it may be absent, or slow to begin.
  function quicken() {
    levels.refine();
    later(true);
    if (location.hash === "#canvas") return;
    const first = paint;
    try {
      paint = makeGl(holder);
      paint.ground(GROUND.screen);
      resize();
      paint.finish();
    } catch { // there is no WebGL here
      paint = first;
      return;
    }
    first.remove();
  }

  const pixel = () => (camera.top - camera.bottom) / camera.zoom / high; // [mm]

  function update() {
    camera.updateMatrixWorld();
    matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  }

  // Place of a point on the page, within the view [px].
  function project(x, y, z) {
    const m = matrix.elements;
    const [a, b, c] = [x - centre[0], y - centre[1], z - centre[2]];
    return [
      (0.5 + 0.5 * (m[0] * a + m[4] * b + m[8] * c + m[12])) * wide,
      (0.5 - 0.5 * (m[1] * a + m[5] * b + m[9] * c + m[13])) * high,
    ];
  }

  const screenOf = (i) => project(model.x[i], model.y[i], model.z[i]);

  function isSeen(boxes, c) {
    const [x, y] = project(boxes[4 * c], boxes[4 * c + 1], boxes[4 * c + 2]);
    const r = boxes[4 * c + 3] / pixel() + 8;
    return x > -r && y > -r && x < wide + r && y < high + r;
  }

  // The pieces that are to be seen, as fine as the eye can tell.
  function gather() {
    const { x, y, z } = model;
    const { points, boxes } = levels.at(SHARP * pixel());
    const colour = painter(look.mode, model, look.chosen);
    let count = 0;
    for (let c = 0; c * levels.CHUNK < points.length; c++) {
      if (!isSeen(boxes, c)) continue;
      const end = Math.min(points.length, (c + 1) * levels.CHUNK);
      for (let k = Math.max(1, c * levels.CHUNK); k < end; k++) {
        const i = points[k];
        const from = points[k - 1];
        if (!look.rapids && model.isRapid(i)) continue;
        if (look.within && !look.within(i, from)) continue;
        const at = 6 * count;
        const p = pieces.positions;
        p[at] = x[from] - centre[0];
        p[at + 1] = y[from] - centre[1];
        p[at + 2] = z[from] - centre[2];
        p[at + 3] = x[i] - centre[0];
        p[at + 4] = y[i] - centre[1];
        p[at + 5] = z[i] - centre[2];
        colour(i, model.isRapid(from) ? i : from, pieces.colours, at);
        pieces.from[count] = from;
        pieces.to[count] = i;
        count++;
      }
    }
    pieces.count = count;
    paint.take(pieces);
  }

  function draw() {
    cancelAnimationFrame(due);
    due = 0;
    if (!look.mode) return;
    update();
    if (stale) gather();
    stale = false;
    paint.draw(camera, matrix.elements);
    for (const listener of listeners) listener();
  }

  function later(isStale) {
    stale ||= isStale;
    due ||= requestAnimationFrame(draw);
  }

  function fit() {
    const half = 0.5 * (camera.top - camera.bottom);
    camera.left = (-half * wide) / high;
    camera.right = (half * wide) / high;
    camera.updateProjectionMatrix();
    later(true);
  }

  // A canvas that is resized is empty till it is drawn again: at once.
  function resize() {
    wide = Math.max(1, holder.clientWidth);
    high = Math.max(1, holder.clientHeight);
    paint.resize(wide, high);
    fit();
    draw();
  }

  function isResized() {
    return wide !== Math.max(1, holder.clientWidth) || high !== Math.max(1, holder.clientHeight);
  }

  // Look at all of the part from one side.
  function turn(name) {
    camera.position.set(...views[name]).normalize().multiplyScalar(extent);
    camera.lookAt(0, 0, 0);
    camera.zoom = 1;
    controls.target.set(0, 0, 0);
    const side = new Vector3().crossVectors(camera.up, camera.position).normalize();
    const above = new Vector3().crossVectors(camera.position, side).normalize();
    const along = (axis) => Math.abs(axis.x) * size[0] + Math.abs(axis.y) * size[1]
      + Math.abs(axis.z) * size[2];
    const half = 0.55 * Math.max(along(above), (along(side) * high) / wide, extent / 50);
    camera.top = half;
    camera.bottom = -half;
    fit();
    controls.update();
  }

  // Turn the part by so much to the right and up [rad].
  function swing(right, up) {
    const away = camera.position.clone().sub(controls.target);
    const side = new Vector3().crossVectors(camera.up, away).normalize();
    const high = away.angleTo(camera.up);
    away.applyAxisAngle(side, Math.max(1e-3, Math.min(Math.PI - 1e-3, high - up)) - high);
    camera.position.copy(controls.target).add(away.applyAxisAngle(camera.up, -right));
    controls.update();
    later(true);
  }

  // Move the picture by so many pixels.
  function move(right, down) {
    const way = new Vector3(-right, down, 0).multiplyScalar(pixel()).applyQuaternion(
      camera.quaternion);
    camera.position.add(way);
    controls.target.add(way);
    controls.update();
    later(true);
  }

  function zoom(factor) {
    camera.zoom = Math.max(0.2, Math.min(1e5, camera.zoom * factor));
    camera.updateProjectionMatrix();
    later(true);
  }

  // Look at a place, so much about it as is asked for in height and width [mm].
  function frame(place, tall, broad) {
    const middle = new Vector3(...place.map((value, d) => value - centre[d]));
    camera.position.add(middle).sub(controls.target);
    controls.target.copy(middle);
    camera.zoom = (camera.top - camera.bottom) / Math.max(tall, (broad * high) / wide);
    camera.updateProjectionMatrix();
    controls.update();
    later(true);
  }

  // On paper the ground is white.
  function onPaper(isPaper) {
    paint.ground(isPaper ? GROUND.paper : GROUND.screen);
    resize();
  }

  // Look at a point, and so much about it as the stretches first … last of the path take.
  function show(first, last, centred) {
    let [least, most] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (let i = first; i <= last; i++) {
      const at = [model.x[i], model.y[i], model.z[i]];
      least = least.map((value, d) => Math.min(value, at[d]));
      most = most.map((value, d) => Math.max(value, at[d]));
    }
    const middle = new Vector3(model.x[centred] - centre[0], model.y[centred] - centre[1],
      model.z[centred] - centre[2]);
    camera.position.add(middle).sub(controls.target);
    controls.target.copy(middle);
    const about = Math.hypot(...least.map((value, d) => most[d] - value));
    const wanted = Math.max(extent / 8, Math.min(2.2 * about, extent / 2));
    camera.zoom = Math.max(1, (camera.top - camera.bottom) / wanted);
    camera.updateProjectionMatrix();
    controls.update();
    later(true);
  }

  // How far a place of the page is from a piece between two points of it, and where on it [0…1].
  function apart(px, py, from, to) {
    const [ax, ay] = screenOf(from);
    const [bx, by] = screenOf(to);
    const [dx, dy] = [bx - ax, by - ay];
    const square = dx * dx + dy * dy;
    const f = square > 0 ? Math.max(0, Math.min(1, ((px - ax) * dx + (py - ay) * dy) / square)) : 0;
    return [Math.hypot(px - ax - f * dx, py - ay - f * dy), f];
  }

  function depth(i) {
    const m = matrix.elements;
    return m[2] * (model.x[i] - centre[0]) + m[6] * (model.y[i] - centre[1])
      + m[10] * (model.z[i] - centre[2]);
  }

  // The moment whose place is under a place of the view; of two that are as near the front one.
  // null: none.
  function pick(px, py) {
    let best = REACH;
    let found = -1;
    for (let k = 0; k < pieces.count; k++) {
      const [far] = apart(px, py, pieces.from[k], pieces.to[k]);
      if (far > best + 0.5) continue;
      if (found < 0 || far < best - 0.5 || depth(pieces.to[k]) < depth(pieces.to[found])) {
        best = Math.min(best, far);
        found = k;
      }
    }
    if (found < 0) return null;
    let nearest = { i: pieces.to[found], share: 0, far: Infinity };
    for (let i = pieces.from[found] + 1; i <= pieces.to[found]; i++) {
      const [far, share] = apart(px, py, i - 1, i);
      if (far < nearest.far) nearest = { i, share, far };
    }
    return momentOf(model, nearest.i, nearest.share);
  }

  controls.addEventListener("change", () => later(true));
  paint.ground(GROUND.screen);
  resize();
  new ResizeObserver(() => { if (isResized()) resize(); }).observe(holder);
  const flat = !facts.lathe && size[2] <= FLAT * Math.max(size[0], size[1]);
  return {
    bounds, size, levels, matrix, views: Object.keys(views), pieces, camera,
    start: facts.lathe ? "Z X" : flat ? "Top" : "Iso",
    kind: () => paint.kind,
    turn, show, frame, swing, move, zoom, onPaper, pick, screenOf, project, pixel, later, draw,
    quicken, resize,
    onDraw: (listener) => listeners.push(listener),
    look(changes) {
      look = { ...look, ...changes };
      later(true);
    },
  };
}

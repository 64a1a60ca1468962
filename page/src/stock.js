// SPDX-License-Identifier: MIT
// What is left of the stock at a moment: heights of cells that a mill has passed over, radii of
// slices that a lathe's tool has passed by.

const CELLS = 240; // along the longer side
const SLICES = 900;
const KEPT = 16; // states that are kept, to go back to
const INSERT = 3; // how wide a turning tool is behind its tip [mm]
const CUT = 1e-4; // [mm]

// What cuts: the least and the most of it.
function cutBounds(model) {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (let i = 1; i < model.n; i++) {
    if (model.isRapid(i) || model.rests(i)) continue;
    for (const k of [i - 1, i]) {
      [model.x[k], model.y[k], model.z[k]].forEach((value, d) => {
        least[d] = Math.min(least[d], value);
        most[d] = Math.max(most[d], value);
      });
    }
  }
  return { least, most };
}

// Goes to a moment: on from where it is, or from the last state that was kept before it.
function travel(state, cut, model) {
  const kept = new Map([[1, state.slice()]]);
  const every = Math.max(1, Math.ceil(model.n / KEPT));
  let at = 1; // stretches before it are cut
  return ({ i, f }) => {
    if (i < at) {
      at = Math.max(...[...kept.keys()].filter((each) => each <= i));
      state.set(kept.get(at));
    }
    for (; at < i; at++) {
      if (at % every === 0 && !kept.has(at)) kept.set(at, state.slice());
      cut(at, 1);
    }
    cut(i, f);
  };
}

// Heights of cells over X and Y. cutterOf(tool): its diameter and length [mm].
function mill(model, cutterOf, workZ) {
  const { least, most } = cutBounds(model);
  let widest = 0;
  for (const tool of new Set(model.tool)) widest = Math.max(widest, cutterOf(tool).diameter);
  const tipOf = (i) => model.z[i] - cutterOf(model.tool[i]).length;
  let [deepest, highest] = [Infinity, -Infinity];
  for (let i = 1; i < model.n; i++) {
    if (model.isRapid(i) || model.rests(i)) continue;
    deepest = Math.min(deepest, tipOf(i));
    if (model.z[i] === model.z[i - 1]) highest = Math.max(highest, tipOf(i));
  }
  const top = workZ > deepest + CUT ? workZ : highest;
  const rim = 0.5 * widest + 0.04 * Math.max(most[0] - least[0], most[1] - least[1]);
  const low = [least[0] - rim, least[1] - rim];
  const size = Math.max(most[0] + rim - low[0], most[1] + rim - low[1]) / CELLS;
  const across = Math.max(1, Math.ceil((most[0] + rim - low[0]) / size));
  const up = Math.max(1, Math.ceil((most[1] + rim - low[1]) / size));
  const bottom = deepest - 0.15 * (top - deepest) - 1;
  const heights = new Float32Array(across * up).fill(top);

  // A flat cutter goes a share of a stretch.
  function cut(i, share) {
    if (model.rests(i)) return;
    const { diameter, length } = cutterOf(model.tool[i]);
    const r = 0.5 * diameter;
    const [x, y, z] = [model.x[i - 1], model.y[i - 1], model.z[i - 1] - length];
    const [dx, dy, dz] = [model.x[i] - x, model.y[i] - y, model.z[i] - length - z]
      .map((way) => share * way);
    if (Math.min(z, z + dz) >= top) return;
    const cell = (value, d, most_) => Math.max(0, Math.min(most_ - 1,
      Math.floor((value - low[d]) / size)));
    const square = dx * dx + dy * dy;
    const last = cell(Math.max(y, y + dy) + r, 1, up);
    for (let v = cell(Math.min(y, y + dy) - r, 1, up); v <= last; v++) {
      const b = low[1] + (v + 0.5) * size - y;
      const end = cell(Math.max(x, x + dx) + r, 0, across);
      for (let u = cell(Math.min(x, x + dx) - r, 0, across); u <= end; u++) {
        const a = low[0] + (u + 0.5) * size - x;
        const f = square > 0 ? Math.max(0, Math.min(1, (a * dx + b * dy) / square)) : 1;
        if ((a - f * dx) ** 2 + (b - f * dy) ** 2 > r * r) continue;
        const height = square > 0 ? z + f * dz : Math.min(z, z + dz);
        if (height < heights[v * across + u]) heights[v * across + u] = height;
      }
    }
  }
  return { kind: "mill", heights, across, up, size, low, top, bottom, deepest,
    to: travel(heights, cut, model) };
}

// Radii of slices along Z, of the outside: what a tool does within a bore is not told.
function lathe(model) {
  const { least, most } = cutBounds(model);
  const side = Math.abs(least[0]) > most[0] ? -1 : 1; // of the axis where the tool is
  const stock = Math.max(side * least[0], side * most[0]);
  const size = Math.max(1e-6, (most[2] - least[2]) / SLICES);
  const radii = new Float32Array(SLICES).fill(stock);

  // The tip goes a share of a stretch; its insert stands behind it.
  function cut(i, share) {
    if (model.rests(i) || model.isRapid(i)) return;
    const [x, z] = [model.x[i - 1], model.z[i - 1]];
    const [dx, dz] = [share * (model.x[i] - x), share * (model.z[i] - z)];
    const behind = dz > 0 ? -INSERT : INSERT;
    const slice = (value) => Math.max(0, Math.min(SLICES - 1,
      Math.floor((value - least[2]) / size)));
    const ends = [z, z + dz, z + dz + behind, z + behind];
    const last = slice(Math.max(...ends));
    for (let k = slice(Math.min(...ends)); k <= last; k++) {
      const at = least[2] + (k + 0.5) * size;
      // Of all places of the tip from which its insert reaches this slice the deepest one.
      const [near, far] = [at - behind, at].map((place) => (dz !== 0
        ? Math.max(0, Math.min(1, (place - z) / dz)) : 1));
      const radius = Math.max(0, Math.min(side * (x + near * dx), side * (x + far * dx)));
      if (radius < radii[k]) radii[k] = radius;
    }
  }
  return { kind: "lathe", radii, size, low: least[2], stock, to: travel(radii, cut, model) };
}

export function makeStock(facts, model, cutterOf) {
  return facts.lathe ? lathe(model) : mill(model, cutterOf, facts.stock.work_z);
}

// SPDX-License-Identifier: MIT
// What of the path is shown: a range of Z or of layers, one tool of several.
import { grouped } from "./words.js";

const STEPS = 200; // of Z where there are no layers
const LAYERS_MOST = 5000;
const FLAT = 0.5; // of the path that cuts lies in layers
const SLACK = 6e-4; // [mm]
const LEAST = 5; // of path makes a layer [mm]

// The heights at which most of what cuts lies, from below; [] where it has no layers.
export function layersOf({ n, x, y, z, isRapid }) {
  const way = new Map();
  let all = 0;
  let flat = 0;
  for (let i = 1; i < n; i++) {
    if (isRapid(i)) continue;
    const long = Math.hypot(x[i] - x[i - 1], y[i] - y[i - 1], z[i] - z[i - 1]);
    all += long;
    if (Math.abs(z[i] - z[i - 1]) > SLACK) continue;
    flat += long;
    const key = Math.round(1000 * z[i]);
    way.set(key, (way.get(key) ?? 0) + long);
  }
  const found = [...way].filter(([, long]) => long > LEAST).map(([key]) => key / 1000);
  return flat > FLAT * all && found.length > 1 && found.length <= LAYERS_MOST
    ? found.sort((a, b) => a - b) : [];
}

function heights(model, { least, most }) {
  const layers = layersOf(model);
  if (layers.length) return { layers: true, at: layers };
  const step = (most[2] - least[2]) / STEPS;
  return { layers: false, at: Array.from({ length: STEPS + 1 }, (_, k) => least[2] + k * step) };
}

// parts: {box, low, high, tool, told}, elements of the page; tell(within) is called with a function
// of a stretch, null: all of it.
export function makeFilter({ box, low, high, tool, told }, model, bounds, tell) {
  const { layers, at } = heights(model, bounds);
  const last = at.length - 1;
  const hasZ = bounds.most[2] - bounds.least[2] > SLACK;
  const tools = [...new Set(model.tool)].sort((one, other) => one - other);
  for (const range of [low, high]) {
    range.max = last;
    range.closest("label").hidden = !hasZ;
  }
  [low.value, high.value] = [0, last];
  tool.append(new Option("all tools", ""));
  for (const each of tools) tool.append(new Option(each ? `T${each}` : "no tool", each));
  tool.hidden = tools.length < 2;
  box.hidden = !hasZ && tools.length < 2;

  function words(from, to) {
    if (!hasZ || (from === 0 && to === last)) return layers ? `${grouped(at.length)} layers` : "";
    const span = `Z ${at[from].toFixed(3)} … ${at[to].toFixed(3)}`;
    if (!layers) return span;
    return from === to ? `layer ${grouped(to + 1)} of ${grouped(at.length)}, Z ${at[to].toFixed(3)}`
      : `layers ${grouped(from + 1)}–${grouped(to + 1)} of ${grouped(at.length)}`;
  }

  function take(moved) {
    let [from, to] = [Number(low.value), Number(high.value)];
    if (from > to) {
      if (moved === low) high.value = to = from;
      else low.value = from = to;
    }
    told.textContent = words(from, to);
    low.setAttribute("aria-valuetext", at[from].toFixed(3));
    high.setAttribute("aria-valuetext", at[to].toFixed(3));
    const isAll = !hasZ || (from === 0 && to === last);
    const [bottom, top] = [at[from] - SLACK, at[to] + SLACK];
    const own = tool.value === "" ? null : Number(tool.value);
    if (isAll && own === null) {
      tell(null);
      return;
    }
    const { z } = model;
    tell((i, before) => (own === null || model.tool[i] === own)
      && (isAll || (z[i] >= bottom && z[i] <= top && z[before] >= bottom && z[before] <= top)));
  }

  for (const range of [low, high]) range.addEventListener("input", () => take(range));
  tool.addEventListener("change", () => take(null));
  take(null);
}

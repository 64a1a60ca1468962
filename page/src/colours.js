// SPDX-License-Identifier: MIT
// What colours mean: of limits, of numbers on a scale to what occurs, of tools.
import palette from "../../pycnc/report/palette.json";
import { speedWords } from "./words.js";

// Slow is red, fast is blue: of a share of the feed and of a speed. Told apart by whoever sees
// no green (tests/report/test_palette.py).
const SPEED = palette.speed;
// Nothing is felt, or as much as an axis can do.
const NEAR = palette.near;
export const RAPID = palette.limits.rapid;

export function limitColour(name) {
  const [kind, axis] = name.split(":");
  return axis ? palette.axes[axis] : palette.limits[kind] ?? "#cccccc";
}

const rgb = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));

function ramp(stops) {
  const table = new Uint8Array(3 * 256);
  const colours = stops.map(rgb);
  for (let k = 0; k < 256; k++) {
    const at = (k / 255) * (stops.length - 1);
    const low = Math.min(stops.length - 2, Math.floor(at));
    for (let c = 0; c < 3; c++) {
      const from = colours[low][c];
      table[3 * k + c] = Math.round(from + (at - low) * (colours[low + 1][c] - from));
    }
  }
  return table;
}

const gradient = (stops) => `linear-gradient(to right, ${stops.join(",")})`;

// The largest and the least number of what cuts.
function spread(model, value) {
  let least = Infinity;
  let most = -Infinity;
  for (let i = 1; i < model.n; i++) {
    if (model.isRapid(i) || model.rests(i)) continue;
    const now = value(i);
    if (now < least) least = now;
    if (now > most) most = now;
  }
  return most >= least ? [least, most] : [0, 1];
}

// A mode that colours a number: ends of a stretch may differ.
function scale(words, stops, value, [least, most], ends) {
  const table = ramp(stops);
  const factor = most > least ? 255 / (most - least) : 0;
  return {
    words, gradient: gradient(stops), ends,
    paint(i, out, at) {
      const k = 3 * Math.max(0, Math.min(255, Math.round((value(i) - least) * factor)));
      out[at] = table[k];
      out[at + 1] = table[k + 1];
      out[at + 2] = table[k + 2];
    },
  };
}

// A mode that colours a kind: a stretch has one colour.
function kinds(words, colourOf, names, hasRapids) {
  const cache = new Map();
  const of = (i) => {
    const [key, hex] = colourOf(i);
    if (!cache.has(key)) cache.set(key, rgb(hex));
    return cache.get(key);
  };
  return {
    words, names, hasRapids, flat: true,
    paint(i, out, at) {
      const colour = of(i);
      out[at] = colour[0];
      out[at + 1] = colour[1];
      out[at + 2] = colour[2];
    },
  };
}

function limitsThatOccur(facts, model) {
  const time = new Map();
  for (let i = 1; i < model.n; i++) {
    time.set(model.limit[i], (time.get(model.limit[i]) ?? 0) + model.t[i] - model.t[i - 1]);
  }
  return [...time].sort((a, b) => b[1] - a[1]).slice(0, 8)
    .map(([code]) => [limitColour(facts.limits[code].name), facts.limits[code].words]);
}

// Ink that is read on a colour.
export function inkOn(hex) {
  const [r, g, b] = rgb(hex).map((level) => (level / 255) ** 2.2);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b > 0.18 ? "#10161f" : "#ffffff";
}

export const toolColour = (tool) => palette.tools[tool % palette.tools.length];

// Colour modes by their name, in the order of the buttons.
export function modes(facts, model) {
  const share = (i) => (model.feed[i] > 0 ? model.v[i] / model.feed[i] : 0);
  const speed = spread(model, (i) => model.v[i]);
  const tools = [...new Set(model.tool)].sort((one, other) => one - other);
  const found = {
    slowness: scale("Share of the programmed feed", SPEED, share, [0, 1],
      () => ["standing", "as programmed"]),
    speed: scale("Speed reached", SPEED, (i) => model.v[i], [0, speed[1]],
      () => ["0", speedWords(speed[1])]),
    acceleration: scale("Acceleration of the axis nearest to its limit", NEAR,
      (i) => model.near[i], [0, 1], () => ["0", "at its limit"]),
    limit: kinds("What holds the speed", (i) => {
      const { name } = facts.limits[model.limit[i]];
      return [name, limitColour(name)];
    }, limitsThatOccur(facts, model), true),
  };
  if (tools.length > 1) {
    found.tool = kinds("Tool", (i) => [model.tool[i], toolColour(model.tool[i])],
      tools.slice(0, 10).map((tool) => [toolColour(tool), tool ? `T${tool}` : "no tool"]), false);
  }
  return found;
}

const GREY = rgb(RAPID);
const DIM = [58, 66, 78];

function fill(colour, out, at) {
  for (let c = 0; c < 3; c++) out[at + c] = out[at + 3 + c] = colour[c];
}

// How a stretch is coloured: what is chosen in its colour, all else dim; rapids are grey but where
// the limits are told.
export function painter(mode, model, chosen) {
  if (chosen) {
    const colour = rgb(chosen.colour);
    return (i, from, out, at) => fill(chosen.has(i) ? colour : DIM, out, at);
  }
  return (i, from, out, at) => {
    if (model.isRapid(i) && !mode.hasRapids) {
      fill(GREY, out, at);
      return;
    }
    mode.paint(mode.flat ? i : from, out, at);
    mode.paint(i, out, at + 3);
  };
}

// SPDX-License-Identifier: MIT
// What colours mean: of limits, of numbers on a scale to what occurs, of tools.
import { grouped } from "./words.js";

const LIMITS = {
  feed: "#5d7fa3", rapid: "#56606e", corner: "#ff5a36", curvature: "#ffb000", chord: "#d9c400",
  accel: "#e0453a", jerk: "#b06cff", exact_stop: "#ff3d8b", dwell: "#8f86a8", wait: "#6f6a80",
  lookahead: "#22c7c7", starved: "#ffffff", feed_max: "#2fbf9f", spindle: "#79c23a",
  thread: "#4f9d3f", ends: "#c07bd8",
};
const AXIS_V = ["#38a3ff", "#4f7bff", "#7fd0ff", "#00c2ff", "#8aa8ff", "#58e0e0", "#2f8fd0",
  "#6fb6ff", "#9ad0ff"];
const TOOLS = ["#5ab4f0", "#ffb000", "#7bd66b", "#ff6f91", "#b48cff", "#35d0c0", "#ffd84d",
  "#ff8552", "#9bb7d4", "#d88cff"];
export const RAPID = "#4a5361";

// Slow is hot, the programmed feed is calm.
const HOT = ["#ff2d3f", "#ff5a36", "#ff8a2b", "#ffc02e", "#d6d06a", "#86b6a8", "#5d8fc0"];
// Slow is blue, fast is red.
const SPEED = ["#3b5bdb", "#2f9bf0", "#27cfc0", "#6fe06a", "#d9e04a", "#ffb03a", "#ff5a3c"];
// Nothing is felt, or as much as an axis can do.
const NEAR = ["#3f4a5a", "#3f7f93", "#36b39a", "#b5cf5a", "#ffd23f"];

export function limitColour(name) {
  const [kind, axis] = name.split(":");
  return axis ? AXIS_V["xyzabcuvw".indexOf(axis)] : LIMITS[kind] ?? "#cccccc";
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

export const toolColour = (tool) => TOOLS[tool % TOOLS.length];

// Colour modes by their name, in the order of the buttons.
export function modes(facts, model) {
  const share = (i) => (model.feed[i] > 0 ? model.v[i] / model.feed[i] : 0);
  const speed = spread(model, (i) => model.v[i]);
  const tools = [...new Set(model.tool)].sort((one, other) => one - other);
  const found = {
    slowness: scale("Share of the programmed feed", HOT, share, [0, 1],
      ["standing", "as programmed"]),
    speed: scale("Speed reached", SPEED, (i) => model.v[i], [0, speed[1]],
      ["0", `${grouped(speed[1] * 60)} mm/min`]),
    acceleration: scale("Acceleration of the axis nearest to its limit", NEAR,
      (i) => model.near[i], [0, 1], ["0", "at its limit"]),
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

// SPDX-License-Identifier: MIT
// What the page knows: facts and columns of numbers, unpacked from the page itself.
import { makeFelt, nearest } from "./felt.js";

const RAPID = 32;
const RESTS = 64;
const ESCAPE = -32768;

function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

async function unpack(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Columns of the page by name: the ways in which they were made small, backwards.
class Columns {
  constructor(told, bytes) {
    this.told = told;
    this.all = bytes;
  }

  bytes(name) {
    const { at, size } = this.told[name];
    return this.all.subarray(at, at + size);
  }

  // Numbers as they are.
  plain(name, Type) {
    return new Type(this.bytes(name).slice().buffer);
  }

  // Numbers of 16 bits from their low and high bytes.
  words(name) {
    const bytes = this.bytes(name);
    const n = bytes.length / 2;
    const words = new Uint16Array(n);
    for (let i = 0; i < n; i++) words[i] = bytes[i] | (bytes[n + i] << 8);
    return words;
  }

  levels(name) {
    const words = this.words(name);
    const values = new Float32Array(words.length);
    const { quantum } = this.told[name];
    for (let i = 0, level = 0; i < words.length; i++) {
      level = (level + words[i]) & 0xffff;
      values[i] = level * quantum;
    }
    return values;
  }

  steps(name, Type) {
    const steps = new Int16Array(this.words(name).buffer);
    const large = this.plain(`${name}+`, Float64Array);
    const values = new Type(steps.length);
    const { quantum } = this.told[name];
    for (let i = 0, value = 0, k = 0; i < steps.length; i++) {
      value += steps[i] === ESCAPE ? large[k++] : steps[i];
      values[i] = value * quantum;
    }
    return values;
  }
}

// Every point knows the low point whose ramp it is on.
function owners(n, first) {
  const owner = new Int32Array(n);
  for (let k = 0; k < first.length; k++) {
    owner.fill(k, Math.min(n, first[k]), k + 1 < first.length ? Math.min(n, first[k + 1]) : n);
  }
  return owner;
}

// The path that lies behind each point, from speeds and times.
function way({ n, t, v }, length) {
  const s = new Float64Array(n);
  for (let i = 1; i < n; i++) s[i] = s[i - 1] + 0.5 * (v[i] + v[i - 1]) * (t[i] - t[i - 1]);
  const scale = s[n - 1] > 0 ? length / s[n - 1] : 1;
  for (let i = 0; i < n; i++) s[i] *= scale;
  return s;
}

// Which limit holds each stretch: of a ramp that of its low point.
function limits(model, ramps) {
  const { n, code, owner, feet } = model;
  const is_ramp = new Set(ramps);
  const limit = new Uint8Array(n);
  for (let i = 0; i < n; i++) {
    const own = code[i] & 31;
    limit[i] = is_ramp.has(own) && feet.count ? feet.limit[owner[i]] : own;
  }
  return limit;
}

// Lines of the program: where each begins in the text.
function linesOf(text) {
  const starts = [0];
  for (let at = text.indexOf("\n"); at >= 0; at = text.indexOf("\n", at + 1)) starts.push(at + 1);
  if (starts.at(-1) === text.length && starts.length > 1) starts.pop();
  return starts;
}

// The text of lines by their number. Where the page has not all of them, `spans` tells which: pairs
// of the first one and how many stand in a row. null: the line is left out.
export function makeText(text, { spans, lines }) {
  const starts = linesOf(text);
  const runs = spans ?? [[1, starts.length]];
  const before = [0];
  for (const [, count] of runs) before.push(before.at(-1) + count);
  return {
    count: lines ?? starts.length,
    shown: before.at(-1),
    of(line) {
      const k = runs.findLastIndex(([first]) => first <= line);
      if (k < 0 || line >= runs[k][0] + runs[k][1]) return spans ? null : "";
      const place = before[k] + line - runs[k][0];
      const end = place + 1 < starts.length ? starts[place + 1] - 1 : text.length;
      return text.slice(starts[place], end).replace(/\r$/, "");
    },
  };
}

export async function load() {
  const facts = JSON.parse(document.getElementById("facts").textContent);
  const bytes = await unpack(bytesOf(document.getElementById("data").textContent));
  const columns = new Columns(facts.columns, bytes);
  const model = {
    n: facts.points,
    x: columns.steps("x", Float32Array), y: columns.steps("y", Float32Array),
    z: columns.steps("z", Float32Array), t: columns.steps("t", Float64Array),
    v: columns.levels("v"), feed: columns.levels("feed"),
    line: columns.steps("line", Uint32Array), tool: columns.steps("tool", Uint16Array),
    code: columns.bytes("code"),
    feet: {
      count: facts.feet,
      first: columns.steps("foot_first", Uint32Array), at: columns.steps("foot_at", Uint32Array),
      line: columns.steps("foot_line", Uint32Array), limit: columns.bytes("foot_limit"),
      ends: columns.bytes("foot_ends"), axis: columns.bytes("foot_axis"),
      angle: columns.plain("foot_angle", Float32Array),
      lost: columns.plain("foot_lost", Float32Array),
    },
  };
  // Where the axes are: what is drawn, but where rotary axes turn the part.
  model.axis = { x: model.x, y: model.y, z: model.z };
  for (const axis of facts.turned.length ? ["x", "y", "z", ...facts.turned] : []) {
    model.axis[axis] = columns.steps(`axis_${axis}`, Float32Array);
  }
  model.owner = owners(model.n, model.feet.first);
  model.limit = limits(model, facts.ramps);
  model.s = way(model, facts.length_mm);
  model.felt = makeFelt(facts, columns);
  model.near = nearest(model.felt, model);
  model.isRapid = (i) => (model.code[i] & RAPID) > 0;
  model.rests = (i) => (model.code[i] & RESTS) > 0;
  model.isLow = new Uint8Array(model.n);
  for (let k = 0; k < facts.feet; k++) model.isLow[model.feet.at[k]] = 1;
  const text = makeText(new TextDecoder().decode(columns.bytes("text")), facts);
  return { facts, model, text };
}

// The first stretch of a line, else of the nearest one behind it (step < 0: before it).
export function nearestLine(model, line, step = 1) {
  let best = -1;
  for (let i = 1; i < model.n; i++) {
    const own = model.line[i];
    if (own === line) return i;
    const isThere = step > 0 ? own > line : own < line && own > 0;
    const far = best < 0 ? Infinity : Math.abs(model.line[best] - line);
    if (isThere && Math.abs(own - line) < far) best = i;
  }
  return best;
}

// The lines of a stretch: of a path that is thinned it may stand for several.
export function linesAt(model, { all }, i) {
  const [before, own] = [model.line[i - 1], model.line[i]];
  return all && own > before + 1 ? [before + 1, own] : [own, own];
}

// The last place of a rising array that is not behind a value.
export function place(array, value) {
  let low = 0;
  let high = array.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (array[middle] <= value) low = middle;
    else high = middle - 1;
  }
  return low;
}

// A moment is a stretch and the share of its time that has passed. Between two points the speed is
// straight, so the way that has passed is v0·f + (v1 − v0)·f²/2, of (v0 + v1)/2.
export function wayShare({ v }, { i, f }) {
  const [begin, end] = [v[i - 1], v[i]];
  const both = begin + end;
  return both > 0 ? (f * (2 * begin + (end - begin) * f)) / both : f;
}

// The moment when a share of the way of a stretch has passed.
export function momentOf({ v }, i, share) {
  const [begin, end] = [v[i - 1], v[i]];
  const both = begin + end;
  if (!(both > 0)) return { i, f: share };
  const root = Math.sqrt(Math.max(0, begin * begin + (end - begin) * both * share));
  return { i, f: begin + root > 0 ? Math.min(1, (share * both) / (begin + root)) : 0 };
}

// The stretch, by the point at its end, that a moment or a place of the path falls into.
export function stretchAt(array, value) {
  return Math.min(array.length - 1, place(array, value) + 1);
}

// SPDX-License-Identifier: MIT
// Speed, acceleration and jerk over time or path. However long the program: of each pixel the least
// and the largest value are drawn, so no low point is lost.
import uPlot from "uplot";
import { limitColour } from "./colours.js";
import { momentOf, place, stretchAt, wayShare } from "./data.js";
import { edges, limitsOf } from "./felt.js";
import { clock, element, grouped, inUnit, speedUnit } from "./words.js";

const dark = matchMedia("(prefers-color-scheme: dark)");
const paper = matchMedia("print");
const isDark = () => dark.matches && !paper.matches;
const ink = () => (isDark() ? "#9aa7b8" : "#55606e");
const GRID = { stroke: () => (isDark() ? "#26303d" : "#e6e9ee"), width: 1 };
const LIMIT = "#d9480f";
const BAND = 9; // height of the band that tells the limits [px]
const HEIGHTS = { v: 128, a: 84, j: 84 };
const TIMES = 26; // of the times below the last one [px]
const RIGHT = 66; // width of the axis on the right [px]
const SYNC = "pycnc";
const DIGITS = 9; // behind the point, at most
const SHARE = "% of limit";

// Places, and rows of values there, of the stretches first … last: as they are, or of those that
// lie within one pixel the least and the largest. Behind them their mean over time, and the
// programmed feed; a rest has none.
function sample(model, xs, [first, last], pixel, { value, feed }) {
  const out = [[], [], [], [], []];
  const put = (x, least, most, mean, i) => {
    const wanted = model.rests(i) ? null : feed(i);
    [x, least, most, mean, wanted].forEach((one, k) => out[k].push(one));
  };
  for (let from = first, to = first; from <= last; from = ++to) {
    while (to < last && xs[to + 1] - xs[from - 1] < pixel) to++;
    if (from === to) {
      for (const end of [0, 1]) {
        const now = value(from, end);
        put(xs[from - 1 + end], now, now, now, from);
      }
      continue;
    }
    let [least, most, sum] = [Infinity, -Infinity, 0];
    for (let i = from; i <= to; i++) {
      const [begin, now] = [value(i, 0), value(i, 1)];
      least = Math.min(least, begin, now);
      most = Math.max(most, begin, now);
      sum += 0.5 * (begin + now) * (model.t[i] - model.t[i - 1]);
    }
    const time = model.t[to] - model.t[from - 1];
    const mean = time > 0 ? sum / time : most;
    put(xs[from - 1], least, most, mean, from);
    put(xs[to], least, most, mean, to);
  }
  return out;
}

// The least and the largest felt in each pixel, of bins between their edges.
function sampleFelt(at, [low, high], width, { least, largest }, factor) {
  const out = [[], [], [], [], []];
  const first = place(at, low);
  const last = Math.min(least.length - 1, stretchAt(at, high) - 1);
  const step = Math.max(1, (last - first + 1) / width);
  for (let from = first; from <= last;) {
    const to = Math.min(last, Math.floor(first + (out[0].length / 2 + 1) * step) - 1);
    let [down, up] = [Infinity, -Infinity];
    for (let k = from; k <= to; k++) {
      down = Math.min(down, least[k]);
      up = Math.max(up, largest[k]);
    }
    const values = [down * factor, up * factor, 0.5 * (down + up) * factor, null];
    for (const x of [at[from], at[to + 1]]) [x, ...values].forEach((one, k) => out[k].push(one));
    from = to + 1;
  }
  return out;
}

const keysOf = (facts) => (facts.j_max !== null ? ["v", "a", "j"] : ["v", "a"]);

// How high all of them are [px].
export const tallness = (facts) => keysOf(facts).reduce((sum, key) => sum + HEIGHTS[key], TIMES);

// Numbers of an axis, with as many digits as tell them apart.
function numbers(splits) {
  const step = Math.abs(splits[1] - splits[0]);
  const isExact = (digits) => {
    const shifted = step * 10 ** digits;
    return Math.round(shifted) > 0 && Math.abs(shifted - Math.round(shifted)) < 1e-6 * shifted;
  };
  let digits = 0;
  while (step > 0 && digits < DIGITS && !isExact(digits)) digits++;
  return splits.map((value) => grouped(value, digits));
}

export function makeCurves(holder, facts, model, ask) {
  const last = model.n - 1;
  const state = {
    xs: model.t, range: [0, model.t[last]], isTime: true, now: { i: 1, f: 0 }, rapids: true,
  };
  const none = () => null;
  const { felt } = model;
  state.track = felt.of.get("axes");
  let bins = edges(felt, model, true);
  const isShare = () => state.track.name === "axes";
  // Of a share 100 are the limit; of an axis its own number.
  const full = (key) => (isShare() ? 100 : state.track.limits[key]);
  const unitOf = (key) => {
    if (key === "v") return `speed ${speedUnit()}`;
    const what = { a: "accel.", j: "jerk" }[key];
    return `${what} ${isShare() ? SHARE : absolute(key)}`;
  };
  const absolute = (key) => {
    const length = "abc".includes(state.track.name) ? "°" : "mm";
    return `${length}/s${{ a: "²", j: "³" }[key]}`;
  };
  // The second number: of a share what the limits are, of an axis its share of the limit.
  const otherUnit = (key) => (isShare() ? absolute(key) : SHARE);
  const others = (key, splits) => splits.map((value) => {
    if (!isShare()) return `${grouped((100 * value) / full(key))} %`;
    return value > 0 ? limitsOf(felt, key) : "";
  });
  const curves = [
    { key: "v", colour: "28,100,216",
      value: (i, end) => inUnit(model.v[i - 1 + end]), feed: (i) => inUnit(model.feed[i]) },
    { key: "a", colour: "13,155,108" },
    { key: "j", colour: "145,70,214" },
  ].filter(({ key }) => keysOf(facts).includes(key));

  // The limits of acceleration or jerk, to both sides.
  function bounds(u, key) {
    const pen = u.ctx;
    const { left, width } = u.bbox;
    pen.save();
    pen.strokeStyle = LIMIT;
    pen.lineWidth = devicePixelRatio;
    pen.setLineDash([5 * devicePixelRatio, 4 * devicePixelRatio]);
    for (const value of [-full(key), full(key)]) {
      const y = Math.round(u.valToPos(value, "y", true)) + 0.5;
      pen.beginPath();
      pen.moveTo(left, y);
      pen.lineTo(left + width, y);
      pen.stroke();
    }
    pen.restore();
  }

  // The room belongs to the cuts: what is much faster is not in the picture.
  function top(first, end) {
    let cut = 0;
    let all = 0;
    for (let i = first; i <= end; i++) {
      const v = Math.max(model.v[i], model.v[i - 1]);
      all = Math.max(all, v);
      if (!model.isRapid(i)) cut = Math.max(cut, v);
    }
    return 1.12 * inUnit(Math.max((cut > 0 && all > 2 * cut) || !state.rapids ? cut : all, 1e-6));
  }

  function visible() {
    const { xs, range } = state;
    return [Math.max(1, place(xs, range[0])), Math.min(last, stretchAt(xs, range[1]))];
  }

  // What holds the path: of each pixel the limit that holds it longest.
  function band(u) {
    const { left, width, top: above } = u.bbox;
    const pen = u.ctx;
    const ratio = devicePixelRatio;
    const names = facts.limits;
    const time = new Float64Array(32);
    let [i] = visible();
    for (let px = 0; px < width; px++) {
      const x = u.posToVal((px + 1) / ratio, "x");
      time.fill(0);
      let best = model.limit[i];
      for (;;) {
        const code = model.limit[i];
        time[code] += model.t[i] - model.t[i - 1];
        if (time[code] > time[best]) best = code;
        if (i >= last || state.xs[i] > x) break;
        i++;
      }
      pen.fillStyle = limitColour(names[best].name);
      pen.fillRect(left + px, above - (BAND + 3) * ratio, 1, BAND * ratio);
    }
  }

  const axis = (label) => ({
    stroke: ink, grid: GRID, ticks: { show: false }, size: 74, gap: 4,
    label, labelSize: 0, font: "11px system-ui, sans-serif",
    values: (u, splits) => numbers(splits), space: 20,
  });

  const second = (key) => ({
    side: 1, scale: "y", stroke: ink, grid: { show: false }, ticks: { show: false }, size: RIGHT,
    gap: 4, font: "11px system-ui, sans-serif", space: 20,
    splits: () => (key === "v" ? []
      : [-1, -0.5, 0, 0.5, 1].map((share) => share * full(key))
        .filter((value) => !isShare() || Math.abs(value) === full(key))),
    values: (u, splits) => (key === "v" ? [] : others(key, splits)),
  });

  function across(isLast) {
    return {
      stroke: ink, grid: GRID, ticks: { show: false }, size: isLast ? TIMES : 0, show: isLast,
      font: "11px system-ui, sans-serif",
      values: (u, splits) => (state.isTime && state.range[1] - state.range[0] > 90
        ? splits.map((value) => clock(value, 0))
        : numbers(splits).map((value) => `${value} ${state.isTime ? "s" : "mm"}`)),
    };
  }

  function make(curve, k) {
    const { key, colour } = curve;
    const isLast = k === curves.length - 1;
    const box = element("div", "curve");
    const height = HEIGHTS[key] + (isLast ? TIMES : 0);
    box.style.height = `${height}px`;
    box.append(element("span", "unit", unitOf(key)));
    if (key !== "v") box.append(element("span", "unit right", otherUnit(key)));
    holder.append(box);
    const line = (width, alpha) => ({
      stroke: `rgba(${colour},${alpha})`, width, points: { show: false },
    });
    const options = {
      width: holder.clientWidth, height,
      padding: [key === "v" ? BAND + 8 : 6, 0, isLast ? 0 : 4, 0],
      legend: { show: false },
      cursor: {
        sync: { key: SYNC }, y: false, points: { show: false },
        drag: { x: true, y: false, setScale: false },
        bind: { dblclick: () => () => zoom(null) },
      },
      scales: {
        x: { time: false, range: () => state.range },
        y: { range: (u, least, most) => range(key, least, most) },
      },
      axes: [across(isLast), axis(null), second(key)],
      series: [{}, line(0.6, 0.5), line(0.6, 0.5), line(1.5, key === "v" ? 1 : 0.6),
        { stroke: "#8a97a8", width: 1.2, points: { show: false } }],
      bands: [{ series: [2, 1], fill: `rgba(${colour},0.22)` }],
      hooks: {
        drawClear: key === "v" ? [band] : [],
        draw: key === "v" ? [] : [(u) => bounds(u, key)],
        setSelect: [(u) => select(u)],
        setCursor: [(u) => hover(u)],
      },
    };
    const plot = new uPlot(options, [[], [], [], [], []], box);
    bind(plot);
    return { curve, plot, box };
  }

  function range(key, least, most) {
    if (key === "v") return [0, top(...visible())];
    const far = Math.max(Math.abs(least ?? 0), Math.abs(most ?? 0), full(key)) * 1.12;
    return [-far, far];
  }

  function select(u) {
    if (u.select.width < 4) return;
    const ends = [u.select.left, u.select.left + u.select.width].map((px) => u.posToVal(px, "x"));
    u.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
    zoom(ends);
  }

  function hover(u) {
    if (!u.over.matches(":hover")) return;
    const { left } = u.cursor;
    ask.hover(left >= 0 ? at(u.posToVal(left, "x")) : null);
  }

  // The stretch at a place of the axis, and how far along.
  function at(x) {
    const { xs } = state;
    const i = stretchAt(xs, x);
    const length = xs[i] - xs[i - 1];
    const share = length > 0 ? Math.max(0, Math.min(1, (x - xs[i - 1]) / length)) : 0;
    return state.isTime ? { i, f: share } : momentOf(model, i, share);
  }

  function bind(u) {
    const line = element("div", "now");
    u.over.append(line);
    let down = 0;
    u.over.addEventListener("mousedown", (event) => { down = event.clientX; });
    u.over.addEventListener("mouseup", (event) => {
      if (Math.abs(event.clientX - down) < 4) ask.now(at(u.posToVal(u.cursor.left, "x")));
    });
    u.over.addEventListener("mouseleave", () => ask.hover(null));
    u.over.addEventListener("wheel", (event) => {
      event.preventDefault();
      const middle = u.posToVal(u.cursor.left, "x");
      const factor = event.deltaY > 0 ? 1.3 : 1 / 1.3;
      zoom(state.range.map((end) => middle + (end - middle) * factor));
    }, { passive: false });
  }

  function fill() {
    const ends = visible();
    for (const { plot, curve } of plots) {
      const width = Math.max(50, Math.round(plot.bbox.width / devicePixelRatio));
      const isMany = ends[1] - ends[0] > 2 * width;
      const pixel = isMany ? (state.range[1] - state.range[0]) / width : 0;
      const data = curve.key === "v" ? sample(model, state.xs, ends, pixel, curve)
        : sampleFelt(bins, state.range, width, state.track[curve.key], full(curve.key));
      plot.setData(data, true);
    }
    mark();
  }

  function label() {
    for (const { curve: { key }, box } of plots) {
      box.querySelector(".unit").textContent = unitOf(key);
      const right = box.querySelector(".unit.right");
      if (right) right.textContent = otherUnit(key);
    }
    fill();
  }

  // Where a moment is on the axis.
  function xOf(moment) {
    const { i, f } = moment;
    const share = state.isTime ? f : wayShare(model, moment);
    return state.xs[i - 1] + share * (state.xs[i] - state.xs[i - 1]);
  }

  function mark() {
    const x = xOf(state.now);
    for (const { plot } of plots) {
      const px = plot.valToPos(x, "x");
      const line = plot.over.querySelector(".now");
      line.hidden = !(px >= 0 && px <= plot.over.clientWidth);
      line.style.left = `${px}px`;
    }
  }

  function zoom(ends) {
    const [least, most] = [0, state.xs[last]];
    let [low, high] = ends ?? [least, most];
    const shortest = (most - least) * 1e-6 + 1e-6;
    if (high - low < shortest) high = low + shortest;
    state.range = [Math.max(least, low), Math.min(most, high)];
    fill();
  }

  const plots = curves.map(make);
  function resize() {
    for (const { plot } of plots) {
      plot.setSize({ width: holder.clientWidth, height: plot.height });
    }
    fill();
  }
  new ResizeObserver(resize).observe(holder);
  dark.addEventListener("change", fill);
  fill();

  return {
    plots,
    now(moment) {
      state.now = moment;
      const x = state.xs[moment.i];
      const [low, high] = state.range;
      if (x < low || x > high) zoom([x - (high - low) / 2, x + (high - low) / 2]);
      else mark();
    },
    // Show the stretches first … last with some room.
    show(first, end) {
      const [low, high] = [state.xs[Math.max(0, first - 1)], state.xs[end]];
      const room = Math.max(0.6 * (high - low), state.xs[last] / 400);
      zoom([low - room, high + room]);
    },
    over(isTime) {
      const ends = state.range.map((x) => at(x).i);
      const whole = state.range[0] <= 0 && state.range[1] >= state.xs[last];
      state.isTime = isTime;
      state.xs = isTime ? model.t : model.s;
      bins = edges(felt, model, isTime);
      zoom(whole ? null : ends.map((i) => state.xs[i]));
    },
    rapids(isShown) {
      state.rapids = isShown;
      fill();
    },
    // Whose acceleration and jerk are shown.
    track(name) {
      state.track = felt.of.get(name);
      label();
    },
    label,
    resize,
    // By keys: the moment goes on by a share of what is shown, or what is shown grows about it.
    step(share) {
      const [low, high] = state.range;
      const x = xOf(state.now) + share * (high - low);
      ask.now(at(Math.max(0, Math.min(state.xs[last], x))));
    },
    grow(factor) {
      const middle = xOf(state.now);
      zoom(state.range.map((end) => middle + (end - middle) * factor));
    },
    end: (isLast) => ask.now(at(isLast ? state.xs[last] : 0)),
    whole: () => zoom(null),
  };
}

// SPDX-License-Identifier: MIT
// The page: what is asked for in one part is shown in all the others.
import "uplot/dist/uPlot.min.css";
import "./page.css";
import {
  drawCauses, drawCures, drawHead, lowsOf, causeColour, marksOf, pointOf,
} from "./causes.js";
import { modes } from "./colours.js";
import { makeCurves, tallness } from "./curves.js";
import { linesAt, load, nearestLine, stretchAt } from "./data.js";
import { makeFilter } from "./filter.js";
import { makeFind } from "./find.js";
import { curveKeys, pathKeys } from "./keys.js";
import { makeListing } from "./listing.js";
import { makeOver } from "./over.js";
import { makePart } from "./part.js";
import { makeScene } from "./scene.js";
import {
  clock, duration, element, grouped, lowWords, setUnit, speedNumber, speedUnit, UNITS,
} from "./words.js";

const RATES = [0.1, 1, 5, 20, 100];
const by = (id) => document.getElementById(id);

// Buttons of which one is pressed.
function choice(box, names, words, take) {
  const buttons = names.map((name) => {
    const made = element("button", "", words(name));
    made.type = "button";
    made.dataset.name = name;
    made.addEventListener("click", () => press(name));
    box.append(made);
    return made;
  });
  function press(name) {
    for (const each of buttons) {
      each.classList.toggle("on", each.dataset.name === name);
      each.setAttribute("aria-pressed", each.dataset.name === name);
    }
    take(name);
  }
  return press;
}

function drawLegend(box, mode) {
  box.replaceChildren(element("strong", "", mode.words));
  if (mode.gradient) {
    const bar = element("i", "gradient");
    bar.style.background = mode.gradient;
    const ends = element("span", "ends");
    ends.append(...mode.ends().map((end) => element("span", "", end)));
    box.append(bar, ends);
    return;
  }
  for (const [colour, name] of mode.names) {
    const item = element("span", "item");
    const chip = element("i", "chip");
    chip.style.background = colour;
    item.append(chip, name);
    box.append(item);
  }
}

// How far the path goes along the axes.
function tellSize(facts, scene) {
  const sides = linearOf(facts).map((axis) => [axis.toUpperCase(),
    scene.size["xyz".indexOf(axis)]]);
  by("size").textContent = `${sides.map(([axis, side]) => `${axis} ${side.toFixed(1)}`)
    .join(" × ")} mm${facts.turned.length ? " on the part" : ""}`;
  if (facts.turned.length) {
    by("size").title = `The path as the part sees it: ${facts.turned.join(" and ").toUpperCase()} `
      + "turned about the zero of the work system.";
  }
}

const linearOf = (facts) => ["x", "y", "z"].filter((axis) => facts.axes.includes(axis));

// The path, and what it is shown by: the first picture needs no more.
function makeStage({ facts, model, text }) {
  const state = { moment: { i: 1, f: 0 }, play: 0, last: 0 };
  const found = modes(facts, model);
  drawHead(facts, text);
  by("curves").style.minHeight = `${tallness(facts)}px`; // the view has its size at once
  const scene = makeScene(by("view"), facts, model);
  const part = makePart({ cutter: by("cutter"), view: by("view"), over: by("over") }, facts, model,
    scene);
  const over = makeOver(by("over"), scene, model, by("legend"));
  const placed = marksOf(facts).map(({ cause, place }, k) => ({
    i: pointOf(facts, model, cause, place), label: String(k + 1), colour: causeColour(cause),
  }));
  over({ marks: placed });
  choice(by("modes"), Object.keys(found),
    (name) => name[0].toUpperCase() + name.slice(1), (name) => {
      state.mode = name;
      scene.look({ mode: found[name] });
      drawLegend(by("legend"), found[name]);
    })("slowness");
  const view = choice(by("views"), scene.views, (name) => name, (name) => {
    state.view = name;
    scene.turn(name);
  });
  view(scene.start);
  by("shows").hidden = !part;
  if (part) {
    choice(by("shows"), ["path", "part"], (name) => name, (name) => {
      const isPart = name === "part";
      over({ marks: isPart ? [] : placed });
      by("legend").hidden = isPart;
      part.show(isPart);
      if (isPart && facts.lathe) view("Z X");
      else if (isPart && state.view === "Top") view("Iso");
      if (isPart) part.frame();
    })("path");
  }
  makeFilter({ box: by("filter"), low: by("low"), high: by("high"), tool: by("tool-only"),
    told: by("filtered") }, model, scene.bounds, (within) => scene.look({ within }));
  tellSize(facts, scene);
  scene.resize();
  return { state, found, scene, part, over };
}

// All the rest, and what connects it.
function connect({ facts, model, text }, { state, found, scene, part, over }) {
  const linear = linearOf(facts);
  const timeOf = ({ i, f }) => model.t[i - 1] + f * (model.t[i] - model.t[i - 1]);
  const speedOf = ({ i, f }) => model.v[i - 1] + f * (model.v[i] - model.v[i - 1]);

  // What is told of a moment.
  function wordsOf(moment) {
    const { i } = moment;
    const limit = facts.limits[model.limit[i]];
    const is_ramp = facts.ramps.includes(model.code[i] & 31);
    const owner = model.owner[i];
    const [v, feed] = [speedOf(moment), model.feed[i]];
    const share = feed > 0 ? ` of ${speedNumber(feed)} (${grouped((100 * v) / feed)} %)` : "";
    const ramp = is_ramp && facts.feet ? lowWords(facts, model.feet, owner) : limit.words;
    const costs = is_ramp && model.feet.lost[owner] >= 5e-4
      ? ` – costs ${duration(model.feet.lost[owner])}` : "";
    const [first, last] = linesAt(model, facts, i);
    return {
      line: model.line[i],
      lines: first < last ? `lines ${grouped(first)}–${grouped(last)}` : `line ${grouped(last)}`,
      speed: model.rests(i) ? "at rest" : `${speedNumber(v)}${share} ${speedUnit()}`,
      held: `${is_ramp ? "ramp for" : "held by"} ${ramp}${costs}`,
      place: `${clock(timeOf(moment))} · ${[...linear, ...facts.turned]
        .map((axis) => `${axis.toUpperCase()} ${model.axis[axis][i].toFixed(3)}`).join("  ")}`,
    };
  }

  function tip(moment, px, py) {
    const box = by("tip");
    box.hidden = !moment;
    if (!moment) return;
    const words = wordsOf(moment);
    box.replaceChildren(element("strong", "", words.speed), element("span", "", words.held),
      element("code", "", `${words.line}  ${listing.lineText(words.line)}`.slice(0, 70)),
      element("span", "dim", words.place));
    const view = by("view");
    box.style.left = `${Math.min(px + 16, view.clientWidth - box.offsetWidth - 8)}px`;
    box.style.top = `${Math.min(py + 16, view.clientHeight - box.offsetHeight - 8)}px`;
  }

  function setNow(moment) {
    state.moment = moment;
    over({ now: moment });
    part?.now(moment);
    listing.now(model.line[moment.i]);
    curves.now(moment);
    by("scrub").value = Math.round((10000 * timeOf(moment)) / model.t[model.n - 1]);
    const words = wordsOf(moment);
    by("moment").textContent = `${clock(timeOf(moment))} of ${clock(model.t[model.n - 1])}`;
    by("here").textContent = `${words.lines} · ${words.speed} · ${words.held}`;
  }

  const ask = {
    now: (moment) => setNow(moment),
    here: () => listing.line(),
    // The next point, or the one before.
    point(step) {
      const { i, f } = state.moment;
      const next = step > 0 ? (f < 1 ? i : i + 1) : i - 1;
      setNow({ i: Math.max(1, Math.min(model.n - 1, next)), f: next < 1 ? 0 : 1 });
    },
    whole: () => scene.turn(state.view),
    hover(moment) {
      over({ ghost: moment });
      if (moment) tip(moment, ...scene.screenOf(moment.i));
      else by("tip").hidden = true;
    },
    line(line, step) {
      const i = nearestLine(model, line, step);
      if (i < 0) return;
      const [first, last] = linesAt(model, facts, i);
      const isOwn = line >= first && line <= last;
      setNow({ i, f: isOwn ? (line - first) / (last - first + 1) : 0 });
      if (isOwn) listing.now(line);
    },
    cause(cause) {
      if (!cause) {
        scene.look({ chosen: null });
        return;
      }
      const lows = new Set(lowsOf(facts, model, cause));
      const is_pace = cause.cause === "feed" || cause.cause === "rapid";
      const code = is_pace ? -1 : Number(Object.keys(facts.limits)
        .find((key) => facts.limits[key].name === cause.cause) ?? -1);
      scene.look({
        chosen: {
          colour: causeColour(cause),
          has: (i) => (facts.ramps.includes(model.code[i] & 31)
            ? lows.has(model.owner[i]) : (model.code[i] & 31) === code),
        },
      });
    },
    place(cause, place) {
      const at = pointOf(facts, model, cause, place);
      const [first, last] = around(at);
      scene.show(first, last, at);
      curves.show(first, last);
      setNow({ i: Math.max(1, at), f: 1 });
      listing.now(place.line_worst);
    },
  };

  // The ramps on both sides of a point.
  function around(at) {
    const { feet } = model;
    const k = model.owner[Math.max(0, at)];
    const end = k + 1 < feet.count ? feet.first[k + 1] : model.n - 1;
    return [Math.max(0, feet.first[k] - 1), Math.min(model.n - 1, Math.max(end, at))];
  }

  const listing = makeListing(by("listing"), by("rows"), { text, model, facts }, ask);
  const curves = makeCurves(by("curves"), facts, model, ask);
  drawCauses(by("causes"), facts, marksOf(facts), listing.lineText, ask);
  drawCures(by("causes"), facts);
  choice(by("units"), Object.keys(UNITS), (name) => name, (name) => {
    setUnit(name);
    curves.label();
    drawLegend(by("legend"), found[state.mode]);
    setNow(state.moment);
  })("mm/min");
  const find = makeFind({ input: by("find"), back: by("find-back"), on: by("find-on"),
    told: by("found") }, text, ask);
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || /INPUT|SELECT/.test(event.target.tagName)) return;
    event.preventDefault();
    find();
  });
  pathKeys(by("over"), scene, ask);
  curveKeys(by("curves"), curves);
  const paper = matchMedia("print");
  paper.addEventListener("change", () => {
    scene.onPaper(paper.matches);
    curves.resize();
  });
  choice(by("across"), ["time", "path"], (name) => name, (name) => curves.over(name === "time"))(
    "time");
  choice(by("tracks"), model.felt.names, (name) => (name.length > 1 ? name : name.toUpperCase()),
    (name) => curves.track(name))("axes");
  by("rapids").addEventListener("change", (event) => {
    scene.look({ rapids: event.target.checked });
    curves.rapids(event.target.checked);
  });
  by("whole").addEventListener("click", () => curves.whole());
  pointer(by("over"), scene, (moment, px, py, isClick) => {
    if (isClick && moment) {
      setNow(moment);
      return;
    }
    over({ ghost: moment });
    tip(moment, px, py);
  });
  player(state, model, setNow, timeOf);
  setNow({ i: 1, f: 0 });
  scene.draw();
  return {
    facts, model, scene, found, ask, state, timeOf, speedOf, wordsOf, listing, curves, part,
  };
}

// A pointer that rests shows what is there; a click that is no drag chooses it.
function pointer(canvas, scene, tell) {
  let due = null;
  let down = null;
  canvas.addEventListener("pointermove", (event) => {
    const at = [event.offsetX, event.offsetY];
    const is_first = !due;
    due = event.buttons ? null : at;
    if (is_first && due) {
      requestAnimationFrame(() => {
        if (!due) return;
        const [px, py] = due;
        const moment = scene.pick(px, py);
        due = null;
        tell(moment, px, py, false);
      });
    }
  });
  canvas.addEventListener("pointerleave", () => tell(null, 0, 0, false));
  canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
  canvas.addEventListener("pointerup", (event) => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
    const moment = scene.pick(event.offsetX, event.offsetY);
    if (moment) tell(moment, event.offsetX, event.offsetY, true);
  });
}

// Play: the moment runs on by itself, so many times as fast as the machine.
function player(state, model, setNow, timeOf) {
  const end = model.t[model.n - 1];
  const momentAt = (t) => {
    const i = stretchAt(model.t, t);
    const time = model.t[i] - model.t[i - 1];
    return { i, f: time > 0 ? Math.max(0, Math.min(1, (t - model.t[i - 1]) / time)) : 0 };
  };
  const rate = by("rate");
  for (const factor of RATES) rate.append(new Option(`× ${factor}`, factor));
  const playable = RATES.findLast((factor) => end / factor >= 8) ?? RATES[0];
  rate.value = String(playable);
  function run(now) {
    if (!state.play) return;
    const t = timeOf(state.moment) + ((now - state.last) / 1000) * Number(rate.value);
    state.last = now;
    setNow(momentAt(Math.min(t, end)));
    if (t >= end) press();
    else state.play = requestAnimationFrame(run);
  }
  function press() {
    cancelAnimationFrame(state.play);
    if (state.play) {
      state.play = 0;
    } else {
      if (timeOf(state.moment) >= end) setNow({ i: 1, f: 0 });
      state.last = performance.now();
      state.play = requestAnimationFrame(run);
    }
    by("play").textContent = state.play ? "❚❚" : "▶";
  }
  by("play").addEventListener("click", press);
  by("scrub").addEventListener("input", (event) => {
    setNow(momentAt((end * Number(event.target.value)) / 10000));
  });
  document.addEventListener("keydown", (event) => {
    if (event.code !== "Space" || /BUTTON|INPUT|SELECT|SUMMARY/.test(event.target.tagName)) return;
    event.preventDefault();
    press();
  });
}

async function main() {
  if (typeof DecompressionStream === "undefined") {
    by("note").hidden = false;
    by("note").textContent = "This browser is too old for this page: it needs DecompressionStream.";
    return;
  }
  const data = await load();
  const stage = makeStage(data);
  await shown();
  performance.mark("drawn"); // the first picture is there
  window.report = connect(data, stage);
  await shown();
  stage.scene.quicken();
  document.body.dataset.ready = stage.scene.kind();
}

// What is drawn is on the screen.
const shown = () => new Promise((done) => { requestAnimationFrame(() => setTimeout(done)); });

main();

// SPDX-License-Identifier: MIT
// What time is lost to: the head of the page, and the table of causes with their worst places.
import palette from "../../pycnc/report/palette.json";
import { inkOn, limitColour } from "./colours.js";
import { nearestLine } from "./data.js";
import { duration, element, grouped } from "./words.js";

const SHOWN = 10; // causes
const PLACES = 4; // of a cause
const MARKS = 7; // worst places that are marked in the picture
const LEAST_S = 5e-4;

// What holds by itself is calm; what makes the path lose time is not.
const { changes: LOSES, kept: KEPT } = palette;

export const causeColour = (cause) => LOSES[cause.cause] ?? limitColour(cause.cause);

// Low points of a cause.
export function lowsOf(facts, model, cause) {
  const { feet } = model;
  const found = [];
  const angle = cause.angle_deg;
  for (let k = 0; k < feet.count; k++) {
    const name = feet.ends[k] ? "ends" : facts.limits[feet.limit[k]].name;
    if (name !== cause.cause) continue;
    const is_own = !angle
      || (feet.angle[k] >= angle[0] - 1e-3 && feet.angle[k] <= angle[1] + 1e-3);
    if (is_own) found.push(k);
  }
  return found;
}

// The point where a place is worst: its low point, else the end of its line.
export function pointOf(facts, model, cause, place) {
  const { feet } = model;
  let worst = -1;
  for (const k of lowsOf(facts, model, cause)) {
    const is_here = feet.line[k] === place.line_worst;
    if (is_here && (worst < 0 || feet.lost[k] > feet.lost[worst])) worst = k;
  }
  if (worst >= 0) return feet.at[worst];
  const at = model.line.lastIndexOf(place.line_worst);
  return at >= 0 ? at : Math.max(0, nearestLine(model, place.line_worst));
}

// The worst places of all causes, numbered.
export function marksOf(facts) {
  const found = facts.causes.flatMap((cause) => cause.places.map((place) => ({ cause, place })));
  return found.filter(({ place }) => place.lost_s >= LEAST_S)
    .sort((a, b) => b.place.lost_s - a.place.lost_s).slice(0, MARKS);
}

function piece(share, colour, words, time) {
  const told = `${words} ${duration(time)}`;
  const made = element("span", "", share > 0.16 ? told : share > 0.06 ? words : "");
  made.style.flexGrow = share;
  made.style.background = colour;
  made.style.color = inkOn(colour);
  made.title = told;
  return made;
}

// What is left out where a program is too large for a page.
function partWords(facts, text) {
  const part = (shown, all, words) => (shown < all
    ? [`${grouped(shown)} of ${grouped(all)} ${words}`] : []);
  const parts = [
    ...part(text.shown, text.count, "lines"),
    ...part(facts.points, facts.all?.points ?? facts.points, "points"),
    ...part(facts.feet, facts.all?.feet ?? facts.feet, "low points of speed"),
  ];
  return parts.length ? ` · shown: ${parts.join(", ")}` : "";
}

const feedWords = ({ feed_mm_min }) => `a feed of ${grouped(feed_mm_min)} mm/min`;

const linesWords = ({ line_first, line_last }) => (line_first === line_last
  ? `line ${grouped(line_first)}` : `lines ${grouped(line_first)}–${grouped(line_last)}`);

export function drawHead(facts, text) {
  const set = (id, text) => { document.getElementById(id).textContent = text; };
  const name = facts.file.split(/[\\/]/).at(-1);
  set("name", name);
  set("machine", `${facts.machine} · slope ${facts.slope} · ${grouped(facts.blocks)} blocks`
    + ` · ${grouped(facts.length_mm / 1000, 2)} m of path${partWords(facts, text)}`);
  set("total", duration(facts.total_s));
  const extra = facts.total_s - facts.time_s;
  set("total-words", extra > 0
    ? `with ${duration(extra)} for tool changes and spindle starts` : "machining time");
  const lost = facts.time_s - facts.ideal_s;
  const worst = facts.causes[0];
  const slow = facts.slow_feeds.map((feed) => `, ${duration(feed.time_s)} of it at ${
    feedWords(feed)}`).join("");
  set("verdict", lost < LEAST_S || !worst
    ? `Nothing holds it back but the programmed feeds, rapids and dwells${slow}.`
    : `ideal time ${duration(facts.ideal_s)}${slow} · `
      + `${duration(lost)} (${grouped((100 * lost) / facts.time_s)} %) lost, `
      + `most of it to ${worst.words} (${duration(worst.lost_s)})`);
  const parts = [["cut_s", "at feed"], ["rapid_s", "rapids"], ["dwell_s", "dwells and waits"]];
  const split = document.getElementById("split");
  for (const [key, words] of parts) {
    const time = facts.ideal[key];
    if (time > 0) split.append(piece(time / facts.time_s, KEPT[key], words, time));
  }
  for (const cause of facts.causes) {
    if (cause.lost_s < LEAST_S) continue;
    split.append(piece(cause.lost_s / facts.time_s, causeColour(cause), cause.words,
      cause.lost_s));
  }
}

function placeRow({ cause, place, number }, lineText, ask) {
  const row = element("button", "place");
  row.type = "button";
  const badge = element("span", number ? "badge" : "badge none", number ?? "");
  if (number) {
    badge.style.background = causeColour(cause);
    badge.style.color = inkOn(causeColour(cause));
  }
  const times = place.count > 1 ? ` · ${grouped(place.count)} ×` : "";
  const axis = place.axis ? ` · ${place.axis.toUpperCase()}` : "";
  row.append(badge, element("span", "span", linesWords(place) + times + axis),
    element("span", "lost", duration(place.lost_s)),
    element("code", "", place.text || lineText(place.line_worst)));
  row.addEventListener("click", () => ask.place(cause, place));
  return row;
}

// Feeds far below the rest: nothing is lost at them, all of their time is ideal.
function drawFeeds(box, facts, lineText, ask) {
  if (!facts.slow_feeds.length) return;
  box.append(element("h3", "", "Programmed slowly"));
  for (const feed of facts.slow_feeds) {
    const row = element("button", "place");
    row.type = "button";
    row.append(element("span", "badge none"),
      element("span", "span", `${feedWords(feed)} · ${linesWords(feed)}`),
      element("span", "lost", duration(feed.time_s)),
      element("code", "", lineText(feed.line_first)));
    row.addEventListener("click", () => ask.line(feed.line_first));
    box.append(row);
  }
  box.append(element("h3", "", "Lost"));
}

// What a plan with each cure gains over this one; nothing if nobody asked.
export function drawCures(box, facts) {
  if (!facts.what_if.length) return;
  box.append(element("h3", "", "What if – planned again with each cure"));
  const most = Math.max(...facts.what_if.map((cure) => Math.abs(cure.gain_s)), 1e-9);
  const tells = (cure) => Math.abs(cure.gain_s) >= LEAST_S;
  for (const cure of facts.what_if.filter(tells)) {
    const loses = cure.gain_s < 0;
    const row = element("div", loses ? "cure loses" : "cure");
    const bar = element("i", "lost-bar");
    bar.style.width = `${(100 * Math.abs(cure.gain_s)) / most}%`;
    const track = element("span", "track");
    track.append(bar);
    const gain = `${loses ? "loses" : "gains"} ${duration(Math.abs(cure.gain_s))}`;
    row.append(element("span", "words", cure.cure), element("span", "lost", gain), track,
      element("span", "many", duration(cure.time_s)));
    box.append(row);
  }
  const vain = facts.what_if.filter((cure) => !tells(cure)).map(({ cure }) => cure);
  if (vain.length) box.append(element("p", "none", `Nothing from: ${vain.join(", ")}`));
}

export function drawCauses(box, facts, marks, lineText, ask) {
  const numbers = new Map(marks.map(({ place }, k) => [place, String(k + 1)]));
  const most = Math.max(...facts.causes.map((cause) => cause.lost_s), 1e-9);
  const told = facts.causes.filter((cause) => cause.lost_s >= LEAST_S);
  drawFeeds(box, facts, lineText, ask);
  if (!told.length) box.append(element("p", "none", "Nothing: feeds and rapids are reached."));
  for (const cause of told.slice(0, SHOWN)) {
    const group = element("details", "cause");
    group.name = "cause"; // one is open at a time
    const head = element("summary");
    const chip = element("i", "chip");
    chip.style.background = causeColour(cause);
    const bar = element("i", "lost-bar");
    bar.style.width = `${(100 * cause.lost_s) / most}%`;
    bar.style.background = causeColour(cause);
    const track = element("span", "track");
    track.append(bar);
    const words = element("span", "words", cause.words);
    const axis = cause.axis ? ` · mostly ${cause.axis.toUpperCase()}` : "";
    const many = cause.count === 1 ? "1 place" : `${grouped(cause.count)} places`;
    head.append(chip, words, element("span", "lost", duration(cause.lost_s)),
      element("span", "share", `${(100 * cause.share).toFixed(1)} %`), track,
      element("span", "many", many + axis));
    group.append(head);
    for (const place of cause.places.slice(0, PLACES)) {
      group.append(placeRow({ cause, place, number: numbers.get(place) }, lineText, ask));
    }
    group.addEventListener("toggle", () => {
      const open = [...box.querySelectorAll("details")].findIndex((each) => each.open);
      ask.cause(open >= 0 ? told[open] : null);
    });
    box.append(group);
  }
  const rest = told.slice(SHOWN);
  if (rest.length) {
    const lost = rest.reduce((sum, cause) => sum + cause.lost_s, 0);
    box.append(element("p", "none", `${duration(lost)} to ${rest.length} more causes`));
  }
}

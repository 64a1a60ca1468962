// SPDX-License-Identifier: MIT
// The program: only the rows that are to be seen are there, so a million lines are no burden.
import { element } from "./words.js";

const ROW = 19; // [px]
const TALLEST = 8e6; // what every browser can scroll [px]
const TOLD_S = 5e-4; // a loss that is told
const ABSENT = "(not in this page)";

export function makeListing(box, rows, { text, model, facts }, ask) {
  const { count } = text;
  const lost = new Float64Array(count + 1);
  const { feet } = model;
  for (let k = 0; k < feet.count; k++) {
    if (feet.line[k] <= count) lost[feet.line[k]] += feet.lost[k];
  }
  for (const cause of facts.causes) {
    // Caps of pieces are no low points: their worst places are told by the table.
    for (const place of cause.places) {
      if (place.line_worst <= count && lost[place.line_worst] < place.worst_s) {
        lost[place.line_worst] = place.worst_s;
      }
    }
  }
  const most = lost.reduce((a, b) => Math.max(a, b), 1e-9);
  const tall = Math.min(TALLEST, count * ROW);
  const state = { line: 0, drawn: [] };
  rows.style.height = `${tall}px`;

  const lineText = (line) => text.of(line) ?? ABSENT;

  // A program that is taller than a browser can scroll is scrolled in larger steps.
  function firstRow() {
    const shown = Math.floor(box.clientHeight / ROW);
    const free = Math.max(1, tall - box.clientHeight);
    const most_first = Math.max(0, count - shown);
    return tall < count * ROW
      ? Math.round((box.scrollTop / free) * most_first)
      : Math.floor(box.scrollTop / ROW);
  }

  function row(line) {
    const made = element("div", line === state.line ? "row here" : "row");
    made.dataset.line = line;
    const heat = element("i", "heat");
    const share = lost[line] / most;
    if (lost[line] >= TOLD_S) heat.style.width = `${3 + 25 * Math.sqrt(share)}px`;
    const words = text.of(line);
    made.append(heat, element("b", "", String(line)),
      element("code", words === null ? "absent" : "", words ?? ABSENT));
    if (lost[line] >= TOLD_S) made.append(element("em", "", `${lost[line].toFixed(3)} s lost`));
    return made;
  }

  function draw() {
    const first = firstRow();
    const shown = Math.ceil(box.clientHeight / ROW) + 2;
    const top = tall < count * ROW ? box.scrollTop : first * ROW;
    const made = [];
    for (let k = 0; k < shown && first + k < count; k++) {
      const each = row(first + k + 1);
      each.style.top = `${top + k * ROW}px`;
      made.push(each);
    }
    rows.replaceChildren(...made);
  }

  function scrollTo(line) {
    const shown = Math.floor(box.clientHeight / ROW);
    const first = firstRow();
    if (line > first + 1 && line < first + shown) return;
    const wanted = Math.max(0, line - 1 - shown / 3);
    const free = Math.max(1, tall - box.clientHeight);
    box.scrollTop = tall < count * ROW
      ? (wanted / Math.max(1, count - shown)) * free
      : wanted * ROW;
  }

  box.addEventListener("scroll", () => requestAnimationFrame(draw));
  box.addEventListener("click", (event) => {
    const line = Number(event.target.closest(".row")?.dataset.line);
    if (line) ask.line(line);
  });
  box.addEventListener("keydown", (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    ask.line(Math.max(1, Math.min(count, state.line + step)), step);
  });
  new ResizeObserver(draw).observe(box);
  draw();
  return {
    count, lineText,
    line: () => state.line,
    now(line) {
      if (line === state.line) return;
      state.line = line;
      if (line > 0 && line <= count) scrollTo(line);
      draw();
    },
  };
}

// SPDX-License-Identifier: MIT
// Find: a text in the program, or a line by its number.
import { grouped } from "./words.js";

// The lines that have a text in them, as they stand; no line of what the page leaves out.
export function linesWith(text, words) {
  const wanted = words.toLowerCase();
  const found = [];
  for (let line = 1; line <= text.count; line++) {
    if (text.of(line)?.toLowerCase().includes(wanted)) found.push(line);
  }
  return found;
}

// parts: {input, back, on, told}, elements of the page. Returns focus().
export function makeFind({ input, back, on, told }, text, ask) {
  const state = { words: "", lines: [], k: -1 };

  function tell(words) {
    told.textContent = words;
  }

  function go(step) {
    const words = input.value.trim();
    if (!words) {
      tell("");
      return;
    }
    if (/^\d+$/.test(words)) {
      const line = Math.max(1, Math.min(text.count, Number(words)));
      tell(`of ${grouped(text.count)}`);
      ask.line(line);
      return;
    }
    if (words !== state.words) {
      Object.assign(state, { words, lines: linesWith(text, words) });
      const here = ask.here();
      state.k = step > 0 ? state.lines.findLastIndex((line) => line < here)
        : state.lines.findIndex((line) => line > here);
      if (step < 0 && state.k < 0) state.k = state.lines.length;
    }
    const { length } = state.lines;
    if (!length) {
      tell("not found");
      return;
    }
    state.k = (state.k + step + length) % length;
    tell(`${grouped(state.k + 1)} of ${grouped(length)}`);
    ask.line(state.lines[state.k]);
  }

  input.addEventListener("keydown", (event) => {
    if (event.key !== "Enter") return;
    event.preventDefault();
    go(event.shiftKey ? -1 : 1);
  });
  back.addEventListener("click", () => go(-1));
  on.addEventListener("click", () => go(1));
  return () => {
    input.focus();
    input.select();
  };
}

// SPDX-License-Identifier: MIT
// Numbers and names for people.

export function duration(seconds) {
  if (seconds < 60) return `${seconds.toFixed(seconds < 10 ? 3 : 2)} s`;
  const tenths = Math.round(seconds * 10);
  if (tenths < 36000) {
    return `${Math.floor(tenths / 600)} min ${((tenths % 600) / 10).toFixed(1)} s`;
  }
  const minutes = Math.round(seconds / 60);
  return `${Math.floor(minutes / 60)} h ${String(minutes % 60).padStart(2, "0")} min`;
}

export function clock(seconds, digits = 2) {
  const whole = Math.floor(seconds / 60);
  const rest = (seconds - 60 * whole).toFixed(digits);
  return `${whole}:${rest.padStart(digits ? digits + 3 : 2, "0")}`;
}

export const grouped = (value, digits = 0) => value.toLocaleString("en", {
  minimumFractionDigits: digits, maximumFractionDigits: digits,
});

// The unit that speeds are told in.
export const UNITS = { "mm/min": 60, "mm/s": 1 };
let unit = "mm/min";
export const setUnit = (name) => { unit = name; };
export const speedUnit = () => unit;
export const inUnit = (speed) => UNITS[unit] * speed; // speed [mm/s]
const digits = () => (unit === "mm/s" ? 1 : 0);
export const speedNumber = (speed) => grouped(inUnit(speed), digits());
export const speedWords = (speed) => `${speedNumber(speed)} ${unit}`;

// An element with a class and text: text, as it is.
export function element(tag, name, text) {
  const made = document.createElement(tag);
  if (name) made.className = name;
  if (text !== undefined) made.textContent = text;
  return made;
}

export const AXES = "xyzabcuvw";

// A low point in words.
export function lowWords(facts, feet, k) {
  if (feet.ends[k]) return "the start or the end of the program";
  const limit = facts.limits[feet.limit[k]];
  if (limit.name !== "corner") return limit.words;
  const axis = AXES[feet.axis[k]];
  const angle = feet.angle[k];
  const told = `a corner of ${angle.toPrecision(angle < 10 ? 2 : 3)}°`;
  return axis ? `${told} (${axis.toUpperCase()})` : told;
}

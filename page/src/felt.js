// SPDX-License-Identifier: MIT
// What the axes feel: acceleration and jerk of every tick, as shares of the limits. A bin has the
// least and the largest of its ticks.
import { stretchAt, wayShare } from "./data.js";

// Tracks by their name: {name, limits: {a, j}, a: {least, largest}, j: {…}}; j where it is limited.
export function makeFelt({ felt }, columns) {
  const tracks = felt.tracks.map(({ name, a, j }) => {
    const track = { name, limits: { a, j } };
    for (const kind of felt.kinds) {
      const least = columns.steps(`felt_${name}_${kind}`, Float32Array);
      const span = columns.steps(`felt_${name}_${kind}_span`, Float32Array);
      track[kind] = { least, largest: least.map((value, k) => value + span[k]) };
    }
    return track;
  });
  const axes = tracks.filter(({ name }) => name !== "path");
  // Of all axes together: what is nearest to its limit, to either side.
  const all = { name: "axes", limits: { a: 1, j: 1 } };
  for (const kind of felt.kinds) {
    const least = new Float32Array(felt.bins);
    const largest = new Float32Array(felt.bins);
    for (const track of axes) {
      for (let k = 0; k < felt.bins; k++) {
        least[k] = Math.min(least[k], track[kind].least[k]);
        largest[k] = Math.max(largest[k], track[kind].largest[k]);
      }
    }
    all[kind] = { least, largest };
  }
  const names = ["axes", ...tracks.map(({ name }) => name)];
  return { bins: felt.bins, bin: felt.bin_s, names, of: new Map([all, ...tracks].map(
    (track) => [track.name, track])) };
}

// Where on the path, or at which time, each bin ends: one place more than bins.
export function edges({ bins, bin }, model, isTime) {
  const found = new Float64Array(bins + 1);
  for (let k = 0; k <= bins; k++) {
    const t = Math.min(k * bin, model.t[model.n - 1]);
    if (isTime) {
      found[k] = t;
      continue;
    }
    const i = stretchAt(model.t, t);
    const time = model.t[i] - model.t[i - 1];
    const f = time > 0 ? Math.max(0, Math.min(1, (t - model.t[i - 1]) / time)) : 1;
    found[k] = model.s[i - 1] + wayShare(model, { i, f }) * (model.s[i] - model.s[i - 1]);
  }
  return found;
}

// How near to its limit of acceleration an axis is in each stretch, at most: 1 is at the limit.
export function nearest(felt, model) {
  const share = new Float32Array(model.n);
  const { least, largest } = felt.of.get("axes").a;
  const bin = (t) => Math.max(0, Math.min(felt.bins - 1, Math.floor(t / felt.bin)));
  for (let i = 1; i < model.n; i++) {
    const last = bin(model.t[i]);
    for (let k = bin(model.t[i - 1]); k <= last; k++) {
      share[i] = Math.max(share[i], -least[k], largest[k]);
    }
  }
  return share;
}

// The limits of the axes, those together that are the same: "XY 2,000", a line each.
export function limitsOf(felt, kind) {
  const letters = new Map();
  for (const name of felt.names.filter((each) => each.length === 1)) {
    const limit = felt.of.get(name).limits[kind];
    letters.set(limit, (letters.get(limit) ?? "") + name.toUpperCase());
  }
  return [...letters].map(([limit, names]) => `${names} ${compact(limit)}`).join("\n");
}

const compact = (value) => value.toLocaleString("en", {
  notation: "compact", maximumSignificantDigits: 4,
});

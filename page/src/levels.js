// SPDX-License-Identifier: MIT
// Levels of detail: fewer points where the eye sees no difference. No low point is ever left out.

const FINEST = 14; // the finest thinned level is 2^-14 of the part
const COARSEST = 9;
const CHANGE = 0.06; // of the largest speed: a larger change is kept
const CHUNK = 256; // points that are looked for together
const FIRST = 1 << 15; // points of the first picture, at most

// Points of a finer level that stay: bends further than `apart`, low points, and where what is
// told of the path changes.
function thin(model, finer, apart, change) {
  const { x, y, z, v, code, tool, isLow } = model;
  const kept = [finer[0]];
  let last = finer[0];
  for (let k = 1; k < finer.length; k++) {
    const i = finer[k];
    const next = finer[Math.min(k + 1, finer.length - 1)];
    const far = Math.hypot(x[i] - x[last], y[i] - y[last], z[i] - z[last]) >= apart
      || Math.hypot(x[next] - x[last], y[next] - y[last], z[next] - z[last]) >= apart;
    const told = isLow[i] || code[i] !== code[next] || tool[i] !== tool[next]
      || Math.abs(v[i] - v[last]) > change;
    if (far || told || k === finer.length - 1) {
      kept.push(i);
      last = i;
    }
  }
  return Uint32Array.from(kept);
}

// Boxes around the points of a level, piece by piece: centre and half diagonal.
function boxes(model, points) {
  const count = Math.ceil(points.length / CHUNK);
  const made = new Float32Array(4 * count);
  for (let c = 0; c < count; c++) {
    const least = [Infinity, Infinity, Infinity];
    const most = [-Infinity, -Infinity, -Infinity];
    const end = Math.min(points.length, (c + 1) * CHUNK);
    for (let k = Math.max(0, c * CHUNK - 1); k < end; k++) {
      const at = [model.x[points[k]], model.y[points[k]], model.z[points[k]]];
      for (let d = 0; d < 3; d++) {
        least[d] = Math.min(least[d], at[d]);
        most[d] = Math.max(most[d], at[d]);
      }
    }
    for (let d = 0; d < 3; d++) made[4 * c + d] = 0.5 * (least[d] + most[d]);
    made[4 * c + 3] = 0.5 * Math.hypot(...least.map((low, d) => most[d] - low));
  }
  return made;
}

// Levels of detail, from all points to the fewest.
function ladder(model, extent) {
  const all = new Uint32Array(model.n);
  let fastest = 0;
  for (let i = 0; i < model.n; i++) {
    all[i] = i;
    fastest = Math.max(fastest, model.v[i]);
  }
  const made = [{ apart: 0, points: all }];
  for (let power = FINEST; power >= COARSEST; power--) {
    const apart = extent / 2 ** power;
    const points = thin(model, made.at(-1).points, apart, CHANGE * fastest);
    made.push({ apart, points });
  }
  return made;
}

// One of every so many points, and the last one.
function sparse({ n }) {
  const every = Math.ceil(n / FIRST);
  const points = new Uint32Array(Math.ceil((n - 1) / every) + 1);
  for (let k = 0; k < points.length; k++) points[k] = Math.min(n - 1, k * every);
  return [{ apart: 0, points }];
}

// Till `refine` is called there are just the points of the first picture.
export function makeLevels(model, extent) {
  let made;
  function take(levels) {
    made = levels;
    for (const level of made) level.boxes = boxes(model, level.points);
  }
  take(sparse(model));
  return {
    CHUNK,
    made: () => made,
    refine: () => take(ladder(model, extent)),
    // The coarsest that is no further off than `apart` [mm].
    at: (apart) => made.findLast((level) => level.apart <= apart) ?? made[0],
  };
}

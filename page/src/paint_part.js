// SPDX-License-Identifier: MIT
// Draws what is left of the stock, point by point: columns of a mill's part from the back to the
// front, slices of a lathe's. It needs no WebGL.

const UNCUT = [150, 134, 112];
const FRESH = [196, 206, 218]; // where little is cut off
const DEEP = [96, 118, 146]; // where most is
const WALLS = [0.5, 0.68]; // light on the walls that look to the left and to the right
const STEP = 1.5; // of a cell: a steeper one is a wall
const TOOL = "rgba(255,214,90,0.55)";

// The shape of a cell on the page: of each column of pixels the rows of its top, and on which of
// its two front edges it ends.
function shapeOf([ux, uy], [vx, vy], isRightOfU) {
  const corners = [[0, 0], [ux, uy], [vx, vy], [ux + vx, uy + vy]];
  const left = Math.floor(Math.min(...corners.map(([x]) => x)));
  const right = Math.ceil(Math.max(...corners.map(([x]) => x)));
  const edges = [[0, 1], [0, 2], [1, 3], [2, 3]].map((ends) => ends.map((k) => corners[k]));
  const lowest = corners.reduce((a, b) => (b[1] > a[1] ? b : a));
  const columns = [];
  for (let dx = left; dx <= right; dx++) {
    let [first, last] = [Infinity, -Infinity];
    for (const [[ax, ay], [bx, by]] of edges) {
      for (const x of [dx, dx + 1]) {
        const f = bx !== ax ? Math.max(0, Math.min(1, (x - ax) / (bx - ax))) : 0;
        if (Math.abs(ax + f * (bx - ax) - x) > 1) continue;
        for (const y of bx !== ax ? [ay + f * (by - ay)] : [ay, by]) {
          first = Math.min(first, y);
          last = Math.max(last, y);
        }
      }
    }
    if (last < first) continue;
    const isLeft = dx + 0.5 < lowest[0];
    columns.push({ dx, first: Math.floor(first), last: Math.ceil(last),
      isU: isLeft !== isRightOfU, light: WALLS[isLeft ? 0 : 1] });
  }
  return columns;
}

function colourOf(stock, height, slope, out) {
  const { top, deepest } = stock;
  const share = Math.sqrt((top - height) / (top - deepest));
  const isCut = height < top - 1e-6;
  for (let c = 0; c < 3; c++) {
    const base = isCut ? FRESH[c] + share * (DEEP[c] - FRESH[c]) : UNCUT[c];
    out[c] = Math.max(20, Math.min(255, base * (1 + slope)));
  }
}

// pixels: Uint32Array of an image of so many pixels; place(x, y, z): where a point is.
function paintMill(stock, pixels, [wide, high], place, m) {
  const { heights, across, up, size, low, top, bottom } = stock;
  const zero = place(low[0], low[1], top);
  const basis = (x, y, z) => place(low[0] + x, low[1] + y, top + z)
    .map((value, d) => value - zero[d]);
  const [u, v, z] = [basis(size, 0, 0), basis(0, size, 0), basis(0, 0, 1)];
  if (m[10] > 0) return; // from below
  const down = -z[1];
  const [du, dv] = [m[2] > 0 ? -1 : 1, m[6] > 0 ? -1 : 1]; // to the front
  const frontU = [du * u[0], du * u[1]];
  const shape = shapeOf(u, v, frontU[0] > dv * v[0]);
  const colour = [0, 0, 0];
  const pack = (light) => (255 << 24) | ((colour[2] * light) << 16) | ((colour[1] * light) << 8)
    | (colour[0] * light);
  const heightAt = (a, b) => (a >= 0 && b >= 0 && a < across && b < up
    ? heights[b * across + a] : bottom);
  const slopeOf = (a, b, own) => {
    const far = (value) => (Math.abs(value - own) > STEP * size ? own : value); // no wall's
    const along = far(heightAt(a + 1, b)) - far(heightAt(a - 1, b));
    const over = far(heightAt(a, b + 1)) - far(heightAt(a, b - 1));
    return Math.max(-0.28, Math.min(0.28, (along - over) / (8 * size)));
  };
  for (let p = 0; p < up; p++) {
    const b = dv > 0 ? p : up - 1 - p;
    for (let q = 0; q < across; q++) {
      const a = du > 0 ? q : across - 1 - q;
      const own = heights[b * across + a];
      const x = Math.floor(zero[0] + a * u[0] + b * v[0] + (own - top) * z[0]);
      const y = Math.floor(zero[1] + a * u[1] + b * v[1] + (own - top) * z[1]);
      const walls = [own - heightAt(a + du, b), own - heightAt(a, b + dv)]
        .map((fall) => (fall > 0 ? Math.ceil(fall * down) : 0));
      colourOf(stock, own, slopeOf(a, b, own), colour);
      const lit = pack(1);
      for (const { dx, first, last, isU, light } of shape) {
        const column = x + dx;
        if (column < 0 || column >= wide) continue;
        const end = Math.min(high - 1, y + last);
        for (let row = Math.max(0, y + first); row <= end; row++) pixels[row * wide + column] = lit;
        const fall = Math.min(high - 1, end + walls[isU ? 0 : 1]);
        if (fall <= end) continue;
        const dark = pack(light);
        for (let row = Math.max(0, end + 1); row <= fall; row++) {
          pixels[row * wide + column] = dark;
        }
      }
    }
  }
}

// A round part from its side: light above its middle, dark at its edges.
function paintLathe(stock, pixels, [wide, high], place) {
  const { radii, size, low, stock: most } = stock;
  const pixel = (z) => place(0, 0, z)[0];
  const mm = size * radii.length / Math.max(1e-9, pixel(low + size * radii.length) - pixel(low));
  const middle = place(0, 0, low)[1];
  const toPixels = Math.abs(place(1, 0, low)[1] - middle);
  const [from, to] = [pixel(low), pixel(low + size * radii.length)].sort((a, b) => a - b);
  for (let x = Math.max(0, Math.floor(from)); x <= Math.min(wide - 1, to); x++) {
    const k = Math.floor(((x + 0.5 - pixel(low)) * mm) / size);
    const r = radii[Math.max(0, Math.min(radii.length - 1, k))] * toPixels;
    const base = radii[Math.max(0, Math.min(radii.length - 1, k))] < most - 1e-6 ? FRESH : UNCUT;
    const last = Math.min(high - 1, Math.floor(middle + r));
    for (let y = Math.max(0, Math.ceil(middle - r)); y <= last; y++) {
      const at = r > 0 ? (y - middle) / r : 0;
      const light = 0.3 + 0.7 * Math.sqrt(Math.max(0, 1 - (at + 0.35) ** 2 / 1.83));
      pixels[y * wide + x] = (255 << 24) | ((base[2] * light) << 16) | ((base[1] * light) << 8)
        | (base[0] * light);
    }
  }
}

export function makePartPaint(holder, before) {
  const canvas = document.createElement("canvas");
  canvas.className = "part";
  canvas.hidden = true;
  holder.insertBefore(canvas, before);
  const pen = canvas.getContext("2d");

  function drawTool([x, y, z], { diameter }, place) {
    const at = place(x, y, z);
    const r = 0.5 * diameter;
    const [east, north] = [place(x + r, y, z), place(x, y + r, z)];
    const long = Math.hypot(...[0, 1].map((d) => Math.hypot(east[d] - at[d], north[d] - at[d])));
    const above = place(x, y, z + 4 * diameter);
    const wide = Math.max(Math.abs(east[0] - at[0]), Math.abs(north[0] - at[0]), 1);
    const half = Math.max(wide, Math.hypot(east[0] - at[0], north[0] - at[0]));
    const tall = Math.sqrt(Math.max(0, long * long - half * half));
    pen.fillStyle = TOOL;
    pen.strokeStyle = "#ffe9a8";
    pen.beginPath();
    pen.ellipse(at[0], at[1], half, tall, 0, 0, Math.PI);
    pen.lineTo(at[0] - half, above[1]);
    pen.ellipse(at[0], above[1], half, tall, 0, Math.PI, 0);
    pen.closePath();
    pen.fill();
    pen.stroke();
  }

  return {
    canvas,
    // stock as it is; scene: the camera. tip: where the tool is, cutter: how wide.
    draw(stock, scene, tip, cutter) {
      const [wide, high] = [holder.clientWidth, holder.clientHeight];
      if (canvas.width !== wide || canvas.height !== high) {
        [canvas.width, canvas.height] = [wide, high];
      }
      const image = new ImageData(wide, high);
      const pixels = new Uint32Array(image.data.buffer);
      pixels.fill(0xff1f1610);
      (stock.kind === "mill" ? paintMill : paintLathe)(stock, pixels, [wide, high], scene.project,
        scene.matrix.elements);
      pen.putImageData(image, 0, 0);
      if (stock.kind === "mill") drawTool(tip, cutter, scene.project);
    },
  };
}

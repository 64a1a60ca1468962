// SPDX-License-Identifier: MIT
// The part in place of the path: what the tool has cut off up to the moment.
import { wayShare } from "./data.js";
import { makePartPaint } from "./paint_part.js";
import { makeStock } from "./stock.js";

const CUTTER = 6; // where no table tells a tool's diameter [mm]

// Whether there is something between the top of the stock and the lowest cut.
function cutsOff({ stock, lathe }, { least, most }) {
  return lathe || Math.max(stock.work_z, most[2]) > least[2] + 1e-4;
}

// parts: {cutter, view, over}, elements of the page. Returns show and now; null: nothing is
// cut off here.
export function makePart({ cutter, view, over }, facts, model, scene) {
  if (!facts.stock || !cutsOff(facts, scene.bounds)) return null;
  const { tools } = facts.stock;
  const cutterOf = (tool) => ({ length: 0, diameter: Number(cutter.value) || CUTTER,
    ...tools[tool] });
  const state = { stock: null, isShown: false, moment: { i: 1, f: 0 } };
  const paint = makePartPaint(view, over);
  const isTold = [...new Set(model.tool)].every((tool) => tools[tool]?.diameter);
  cutter.value = CUTTER;

  function draw() {
    if (!state.isShown) return;
    const { i } = state.moment;
    state.stock.to(state.moment);
    const share = wayShare(model, state.moment);
    const [x, y, z] = [model.x, model.y, model.z].map((column) => column[i - 1]
      + share * (column[i] - column[i - 1]));
    const tool = cutterOf(model.tool[i]);
    paint.draw(state.stock, scene, [x, y, z - tool.length], tool);
  }

  scene.onDraw(draw);
  cutter.addEventListener("change", () => {
    state.stock = makeStock(facts, model, cutterOf);
    scene.later(false);
  });
  return {
    state,
    show(isShown) {
      state.isShown = isShown;
      if (isShown) state.stock ??= makeStock(facts, model, cutterOf);
      paint.canvas.hidden = !isShown;
      cutter.closest("label").hidden = !isShown || isTold || facts.lathe;
      scene.later(false);
    },
    // There is stock around the path, of a lathe on the other side of its axis, too.
    frame() {
      const { stock, size, low, radii } = state.stock;
      if (state.stock.kind === "mill") scene.zoom(0.85);
      else {
        const long = size * radii.length;
        scene.frame([0, 0, low + 0.5 * long], 2.4 * stock, 1.15 * long);
      }
    },
    now(moment) {
      state.moment = moment;
      scene.later(false);
    },
  };
}

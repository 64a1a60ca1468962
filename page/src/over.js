// SPDX-License-Identifier: MIT
// What is written over the path: marks of the worst places, the moment, a scale, the axes.
import { Vector3 } from "three";
import { inkOn } from "./colours.js";
import { wayShare } from "./data.js";

const AXES = [
  ["X", [1, 0, 0], "#ff6b6b"], ["Y", [0, 1, 0], "#69db7c"], ["Z", [0, 0, 1], "#74a9ff"],
];

const ROOM = 12; // about the middle of a mark's number [px]
const BESIDE = [16, -16, 40, -40, 64, -64]; // columns where a number may stand, from its place [px]
const [ABOVE, STEP] = [20, 23]; // where it stands first; rows that do not cover each other [px]

export function makeOver(canvas, scene, model, legend) {
  const pen = canvas.getContext("2d");
  const state = { marks: [], now: null, ghost: null };

  function fit() {
    const ratio = window.devicePixelRatio;
    const [width, height] = [canvas.parentElement.clientWidth, canvas.parentElement.clientHeight];
    const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== across || canvas.height !== down) {
      canvas.width = across;
      canvas.height = down;
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
    }
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    return [width, height];
  }

  function dot(at, radius, fill, edge) {
    pen.beginPath();
    pen.arc(at[0], at[1], radius, 0, 2 * Math.PI);
    pen.fillStyle = fill;
    pen.fill();
    pen.lineWidth = 2;
    pen.strokeStyle = edge;
    pen.stroke();
  }

  // The middle of a mark's number: the first place beside its point, above it or else below, that
  // is in the picture and covers no other number and not the legend.
  function beside([u, v], taken, [width, height]) {
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = legend;
    const isFree = ([x, y]) => x >= ROOM && x <= width - ROOM
      && !(x > offsetLeft - ROOM && x < offsetLeft + offsetWidth + ROOM
        && y > offsetTop - ROOM && y < offsetTop + offsetHeight + ROOM)
      && !taken.some(([a, b]) => Math.abs(a - x) < 22 && Math.abs(b - y) < 22);
    const rows = [];
    for (let y = v - ABOVE; y >= ROOM; y -= STEP) rows.push(y);
    for (let y = v + ABOVE; y <= height - ROOM; y += STEP) rows.push(y);
    const places = BESIDE.flatMap((away) => rows.map((y) => [u + away, y]));
    return places.find(isFree) ?? [u + BESIDE[0], v - ABOVE];
  }

  // Marks that would cover each other stand side by side, each with a line to its place.
  function mark({ i, label, colour }, taken, size) {
    const at = scene.screenOf(i);
    if (at.some((one, k) => one < 0 || one > size[k])) return; // its place is not in the picture
    const [x, y] = beside(at, taken, size);
    taken.push([x, y]);
    pen.strokeStyle = colour;
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(...at);
    pen.lineTo(x, y);
    pen.stroke();
    dot(at, 3, colour, "#10161f");
    dot([x, y], 10, colour, "#10161f");
    pen.fillStyle = inkOn(colour);
    pen.font = "700 12px system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.fillText(label, x, y + 0.5);
  }

  // A round length of about a sixth of the width.
  function scale(width, height) {
    const most = (width / 6) * scene.pixel();
    const power = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].find((step) => step * power <= most) * power;
    const px = length / scene.pixel();
    const [x, y] = [width - 20 - px, height - 16];
    pen.strokeStyle = pen.fillStyle = "#93a1b3";
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(x, y - 5);
    pen.lineTo(x, y);
    pen.lineTo(x + px, y);
    pen.lineTo(x + px, y - 5);
    pen.stroke();
    pen.font = "12px system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "bottom";
    pen.fillText(`${+length.toPrecision(1)} mm`, x + px / 2, y - 3);
  }

  function axes(width) {
    const [x, y] = [width - 46, 46];
    const side = new Vector3();
    const drawn = AXES.map(([name, direction, colour]) => {
      side.set(...direction).transformDirection(scene.camera.matrixWorldInverse);
      return [side.z, name, x + 26 * side.x, y - 26 * side.y, colour];
    }).sort((a, b) => a[0] - b[0]);
    pen.font = "600 11px system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    for (const [, name, u, v, colour] of drawn) {
      if (Math.hypot(u - x, v - y) < 4) continue;
      pen.strokeStyle = pen.fillStyle = colour;
      pen.lineWidth = 2;
      pen.beginPath();
      pen.moveTo(x, y);
      pen.lineTo(u, v);
      pen.stroke();
      pen.fillText(name, u + (u - x) * 0.35, v + (v - y) * 0.35);
    }
  }

  const placeOf = (moment) => {
    const { i } = moment;
    const share = wayShare(model, moment);
    const mix = (column) => column[i - 1] + share * (column[i] - column[i - 1]);
    return scene.project(mix(model.x), mix(model.y), mix(model.z));
  };

  scene.onDraw(() => {
    const [width, height] = fit();
    scale(width, height);
    axes(width);
    const taken = [];
    for (const each of state.marks) mark(each, taken, [width, height]);
    if (state.ghost) dot(placeOf(state.ghost), 5, "rgba(255,255,255,0.25)", "#ffffff");
    if (state.now) dot(placeOf(state.now), 6, "#ffffff", "#10161f");
  });
  return (changes) => {
    Object.assign(state, changes);
    scene.later(false);
  };
}

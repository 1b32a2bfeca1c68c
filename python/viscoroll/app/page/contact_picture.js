/** Pictures of a contact: maps of pressure and stick, and charts of pressure and profile in the middle plane. */

import { chart } from "./chart.js";
import { el } from "./dom.js";
import { PRESSURE_GRADIENT, drawMap } from "./map.js";
import { quantityText, suitableUnit } from "./units.js";

/** Descriptions of the maps for screen readers. */
const MAPS = { pressure: "pressure in the contact", stick: "areas of stick and slip in the contact" };

/** Charts of the middle plane, by their captions. */
const PROFILES = {
  "Pressure in the middle plane": pressureChart,
  "Profile in the middle plane, above the counterbody": profileChart,
};

/** Half of the range of x in the charts, divided by half of the contact length. */
const REACH = 1.6;

const ALONG = "x [mm], rolling to the right";

/**
 * Draw all pictures of a result in the available width.
 * @param {HTMLElement} root element to fill
 * @param {object} result result with fields
 */
export function drawContact(root, { fields, scalars }) {
  const ofPoints = fields.z.length > 1; // a line contact needs no map
  const canvases = Object.entries(MAPS)
    .filter(([what]) => ofPoints && (what === "pressure" || fields.stick))
    .map(([what, label]) => [what, el("canvas", { role: "img", "aria-label": label })]);
  const maps = canvases.map(([what, canvas]) =>
    el("figure", {}, el("figcaption", {}, ...caption(what, scalars)), canvas),
  );
  const profiles = Object.entries(PROFILES).map(([name, draw]) => [draw, el("figure", {}, el("figcaption", {}, name))]);
  root.replaceChildren(...maps, el("div", { class: "profiles" }, ...profiles.map(([, figure]) => figure)));
  for (const [what, canvas] of canvases) drawMap(canvas, fields, what);
  for (const [draw, figure] of profiles) figure.append(draw(fields, scalars, Math.max(figure.clientWidth, 240)));
}

function caption(what, scalars) {
  if (what === "stick") return ["Areas of ", key("stick"), " and ", key("slip")];
  const ramp = el("span", { class: "ramp" });
  ramp.style.background = PRESSURE_GRADIENT; // the server's content security policy forbids style attributes
  return ["Pressure: 0 ", ramp, ` ${quantityText(scalars.max_pressure, "Pa")}`];
}

const key = (name) => el("span", { class: `key ${name}` }, name);

const millimeters = (values) => values.map((value) => 1e3 * value);

/** Pressures in the middle plane [Pa]. */
function pressed({ z, pressure }) {
  return pressure.map((row) => row[Math.floor(z.length / 2)]);
}

/** Range of x in the charts [mm]. */
function reach(fields) {
  const pressures = pressed(fields);
  const half = Math.max(...fields.x.filter((_, i) => pressures[i] > 0).map(Math.abs));
  return [-1e3 * REACH * half, 1e3 * REACH * half];
}

function pressureChart(fields, { max_pressure: largest }, width) {
  const [unit, one] = suitableUnit(largest, "Pa");
  const line = {
    x: millimeters(fields.x),
    y: pressed(fields).map((p) => p / one),
    name: "pressure",
    kind: "one",
    fill: true,
  };
  return chart({ width, lines: [line], xLabel: ALONG, yLabel: `pressure [${unit}]`, xRange: reach(fields) });
}

function profileChart(fields, _, width) {
  const { x, surface, rigid } = fields.profile;
  const xRange = reach(fields);
  const shown = [...surface, ...rigid].filter((_, i) => Math.abs(1e3 * x[i % x.length]) <= xRange[1]);
  const [low, high] = [1e3 * Math.min(0, ...shown), 1e3 * Math.max(0, ...shown)];
  const lines = [
    { x: millimeters(x), y: millimeters(surface), name: "surface", kind: "one" },
    { x: millimeters(x), y: millimeters(rigid), name: "undeformed", kind: "two" },
  ];
  const yRange = [low - 0.08 * (high - low), high + 0.35 * (high - low)]; // space for the legend above
  return chart({ width, lines, xLabel: ALONG, yLabel: "height [mm]", xRange, yRange });
}

/** Map of the contact on a canvas: pressure, or with friction the areas of stick and slip. */

import { ABOVE, BESIDE, roundTicks } from "./ticks.js";
import { numberText } from "./units.js";

/** Colors for pressures from 0 to the largest, interpolated linearly: six colors of matplotlib's "magma", reversed. */
const PRESSURE = [
  [252, 253, 191],
  [254, 159, 109],
  [222, 73, 104],
  [140, 41, 129],
  [59, 15, 112],
  [10, 5, 35],
];
const STICK = [60, 150, 80];
const SLIP = [235, 145, 50];

/** Largest aspect ratio of a contact with equal scales on both axes, and largest height over width of a map. */
const SLENDER = 4;
const TALLEST = 1.1;

const MARGIN = { left: 52, right: 14, top: 10, bottom: 40 };

/**
 * Draw a map of the fields of an answer.
 * @param {HTMLCanvasElement} canvas canvas to fill in its whole width
 * @param {object} fields fields of an answer [SI units]
 * @param {"pressure"|"stick"} what
 */
export function drawMap(canvas, fields, what) {
  const window = contactWindow(fields);
  const ratio = globalThis.devicePixelRatio || 1;
  const width = canvas.clientWidth;
  const frame = frameOf(width - MARGIN.left - MARGIN.right, window);
  const height = frame.height + MARGIN.top + MARGIN.bottom;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.style.height = `${height}px`;
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  context.imageSmoothingEnabled = false;
  context.drawImage(picture(fields, window, what), frame.left, frame.top, frame.width, frame.height);
  drawAxes(context, frame, window, getComputedStyle(canvas));
}

/** Rectangle of the map on the canvas [pixels]: both axes have the same scale, unless the contact is slender. */
function frameOf(width, window) {
  const shape = (window.z[1] - window.z[0]) / (window.x[1] - window.x[0]);
  const height = Math.round(width * Math.min(Math.max(shape, 1 / SLENDER), TALLEST));
  const narrowed = shape > TALLEST && shape < SLENDER ? Math.round(height / shape) : width;
  return { left: MARGIN.left + Math.round((width - narrowed) / 2), top: MARGIN.top, width: narrowed, height };
}

/** Window of the map, the contact and a margin: indices of nodes, and coordinates [m] with x to the right. */
function contactWindow({ x, z, pressure }) {
  const rows = x.map((_, i) => i).filter((i) => pressure[i].some((p) => p > 0));
  const columns = z.map((_, j) => j).filter((j) => pressure.some((row) => row[j] > 0));
  const ends = (indices, count) => {
    const margin = Math.ceil(0.15 * (indices.at(-1) - indices[0])) + 1;
    return [Math.max(indices[0] - margin, 0), Math.min(indices.at(-1) + margin, count - 1)];
  };
  const [i0, i1] = ends(rows, x.length);
  const [j0, j1] = ends(columns, z.length);
  const half = (values) => 0.5 * Math.abs(values[1] - values[0]); // nodes are the centers of their cells
  return {
    rows: [i0, i1],
    columns: [j0, j1],
    x: [Math.min(x[i0], x[i1]) - half(x), Math.max(x[i0], x[i1]) + half(x)],
    z: [Math.min(z[j0], z[j1]) - half(z), Math.max(z[j0], z[j1]) + half(z)],
    flipped: x[i0] > x[i1],
    upward: z[j0] < z[j1],
  };
}

/** Picture with one pixel for each node. */
function picture({ pressure, stick }, { rows, columns, flipped, upward }, what) {
  const [width, height] = [rows[1] - rows[0] + 1, columns[1] - columns[0] + 1];
  const image = new ImageData(width, height);
  const largest = Math.max(...pressure.map((row) => Math.max(...row)));
  for (let a = 0; a < width; a += 1) {
    for (let b = 0; b < height; b += 1) {
      const i = flipped ? rows[1] - a : rows[0] + a;
      const j = upward ? columns[1] - b : columns[0] + b;
      const p = pressure[i][j];
      if (p <= 0) continue;
      const color = what === "stick" ? (stick[i][j] === 1 ? STICK : SLIP) : ramp(p / largest);
      image.data.set([...color, 255], 4 * (b * width + a));
    }
  }
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width, height });
  canvas.getContext("2d").putImageData(image, 0, 0);
  return canvas;
}

/** The color for a pressure divided by the largest pressure. */
function ramp(ratio) {
  const position = Math.min(ratio, 0.9999) * (PRESSURE.length - 1);
  const [low, high] = [PRESSURE[Math.floor(position)], PRESSURE[Math.floor(position) + 1]];
  return low.map((one, k) => Math.round(one + (position % 1) * (high[k] - one)));
}

/** The colors of pressure as a CSS gradient. */
export const PRESSURE_GRADIENT = `linear-gradient(to right, ${PRESSURE.map((color) => `rgb(${color.join(" ")})`).join(", ")})`;

function drawAxes(context, frame, window, style) {
  const { left, top, width, height } = frame;
  Object.assign(context, {
    fillStyle: style.color,
    strokeStyle: style.color,
    lineWidth: 1,
    font: `12px ${style.fontFamily}`,
  });
  context.strokeRect(left, top, width, height);
  const across = (mm) => left + ((mm * 1e-3 - window.x[0]) / (window.x[1] - window.x[0])) * width;
  const down = (mm) => top + ((window.z[1] - mm * 1e-3) / (window.z[1] - window.z[0])) * height;
  const ticks = ([low, high], most) => roundTicks(1e3 * low, 1e3 * high, most);
  context.textAlign = "center";
  for (const tick of ticks(window.x, width / BESIDE)) {
    context.fillText(numberText(tick), across(tick), top + height + 16);
  }
  context.fillText(width > 180 ? "x [mm], rolling to the right →" : "x [mm] →", left + width / 2, top + height + 34);
  context.textAlign = "right";
  for (const tick of ticks(window.z, height / ABOVE)) context.fillText(numberText(tick), left - 6, down(tick) + 4);
  context.save();
  context.translate(left - MARGIN.left + 13, top + height / 2);
  context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText("z [mm]", 0, 0);
  context.restore();
}

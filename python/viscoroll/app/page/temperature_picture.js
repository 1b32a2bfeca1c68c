/** Temperature of the layers: its numbers, and charts through and across its hottest place. */

import { chart } from "./chart.js";
import { el } from "./dom.js";
import { inPageUnits } from "./messages.js";
import { SI, fromSI, numberText, quantityText } from "./units.js";

/** Labels and factors of the coordinates. */
const AXES = {
  radius: ["radius [mm]", 1e3],
  depth: ["depth [mm]", 1e3],
  z: ["z, across the path [mm]", 1e3],
  theta: ["polar angle θ [°]", 180 / Math.PI],
};

export class TemperaturePicture {
  #root;

  /** @param {HTMLElement} root section with a list of numbers, figures and a message */
  constructor(root) {
    this.#root = root;
  }

  /** Remove the temperature; `isComputed` if another one follows. */
  begin(isComputed) {
    this.#root.hidden = !isComputed;
    this.#fill([], [], isComputed ? "The temperature is computed after the refined result." : "");
  }

  /** Show a temperature. */
  show({ rise, axes, warnings, ...numbers }) {
    const [row, column] = hottest(rise);
    const [through, across] = Object.keys(axes);
    const lines = [
      [through, rise.map((values) => values[column]), "through the layers, at the hottest place"],
      [across, rise[row], "across the path, at the hottest depth"],
    ];
    const drawable = lines.filter(([name]) => axes[name].length > 1).map((line) => [...line, axes]);
    this.#fill(cardsOf(numbers), drawable, warnings.map(inPageUnits).join(" "), "warning");
  }

  /** Show the text of an error. */
  fail(text) {
    this.#fill([], [], text, "error");
  }

  #fill(cards, lines, text, kind = "note") {
    const [numbers, figures, said] = ["dl", ".profiles", ".said"].map((part) => this.#root.querySelector(part));
    numbers.replaceChildren(
      ...cards.map(([label, value, note]) =>
        el("div", { class: "card" }, el("dt", {}, label), el("dd", {}, value), el("dd", { class: "note" }, note)),
      ),
    );
    const frames = lines.map(([, , caption]) => el("figure", {}, el("figcaption", {}, `Temperature rise ${caption}`)));
    figures.replaceChildren(...frames);
    for (const [i, frame] of frames.entries()) frame.append(drawn(lines[i], Math.max(frame.clientWidth, 240)));
    said.textContent = text;
    said.dataset.kind = kind;
  }
}

/** Label, text and note of each number. */
function cardsOf({ maximum, surface_maximum: surface, mean, heat, heat_to_core: inwards, heat_unit: unit, ambient }) {
  const temperature = (label, rise) => [label, degrees(ambient + rise), `${kelvin(rise)} above the surroundings`];
  return [
    temperature("highest temperature", maximum),
    temperature("on the surface", surface),
    temperature("mean, weighted by the loss", mean),
    ["heat", quantityText(heat, unit), `${quantityText(inwards, unit)} of it to the core`],
  ];
}

/** Indices of the largest number of a table. */
function hottest(rise) {
  const largest = rise.map((values) => Math.max(...values));
  const row = largest.indexOf(Math.max(...largest));
  return [row, rise[row].indexOf(largest[row])];
}

function drawn([name, values, , axes], width) {
  const [xLabel, factor] = AXES[name];
  const x = axes[name].map((value) => factor * value);
  const line = { x, y: values, name: "rise", kind: "one", fill: true };
  return chart({ width, lines: [line], xLabel, yLabel: "rise [K]", xRange: [Math.min(...x), Math.max(...x)] });
}

const degrees = (value) => `${numberText(fromSI(value, "°C", "temperature")[0])} °C`;
const kelvin = (value) => `${numberText(value, 3)} ${SI.temperature}`;

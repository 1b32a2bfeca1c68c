/** Pictures of a body that rolls over an obstacle: the whole body, the surfaces near the contact, and the push force. */

import { chart } from "./chart.js";
import { el, svg } from "./dom.js";
import { heightAt, surfacesAt } from "./over_ground.js";
import { quantityText, resultUnit, suitableUnit } from "./units.js";

/** Half of the distance shown near the contact, and around the whole body, divided by the radius. */
const NEAR = 0.35;
const AROUND = 1.5;

/** Heights above the highest and below the lowest ground in the picture of the whole body, divided by the radius. */
const ABOVE = 2.15;
const BELOW = 0.2;

/** Time series that are shown as numbers, with their labels. */
const NUMBERS = {
  resisting_force: "push force",
  resisting_torque: "resisting torque",
  load: "load",
  axle_height: "height of the axle",
  contact_length: "contact length",
};

const millimeters = (values) => values.map((value) => (value === null ? NaN : 1e3 * value));

export class GroundPicture {
  #numbers;
  #figures;
  #units;

  /**
   * @param {HTMLElement} root section with a list for numbers, and with figures
   * @param {object[]} scalars table of the time series
   */
  constructor(root, scalars) {
    this.#numbers = root.querySelector("dl");
    this.#figures = [...root.querySelectorAll("figure div")];
    this.#units = Object.fromEntries(scalars.map(({ name, unit }) => [name, unit]));
  }

  /**
   * Draw an instant of a history.
   * @param {object} run tables of the motion file, `radius` [m], `line` for values per length, and `end` of the track [m]
   * @param {object} series time series by name, of all instants computed so far
   * @param {number} index instant to draw
   */
  draw(run, series, index) {
    const [whole, near, force] = this.#figures;
    const place = {
      radius: run.radius,
      distance: series.distance[index],
      height: series.axle_height[index] ?? run.radius, // undetermined on a half-plane
      angle: series.angle[index],
    };
    this.#numbers.replaceChildren(...this.#cards(run, series, index));
    whole.replaceChildren(bodyPicture(run, place));
    near.replaceChildren(nearChart(run, place, widthOf(near)));
    force.replaceChildren(this.#forceChart(run, series, index, widthOf(force)));
  }

  /** Remove numbers and pictures. */
  clear() {
    for (const part of [this.#numbers, ...this.#figures]) part.replaceChildren();
  }

  #unit(name, run) {
    return resultUnit(this.#units[name], run.line);
  }

  #cards(run, series, index) {
    return Object.entries(NUMBERS).map(([name, label]) =>
      el(
        "div",
        { class: "card" },
        el("dt", {}, label),
        el("dd", { "data-series": name, "data-value": series[name][index] }, quantityText(series[name][index], this.#unit(name, run))),
      ),
    );
  }

  #forceChart(run, series, index, width) {
    const largest = Math.max(...series.resisting_force.map(Math.abs));
    const [unit, one] = suitableUnit(largest, this.#unit("resisting_force", run));
    const x = millimeters(series.distance);
    const y = series.resisting_force.map((force) => force / one);
    const [low, high] = [Math.min(0, ...y), Math.max(0, ...y)];
    const margin = 0.08 * (high - low || 1);
    return chart({
      width,
      lines: [{ x: x.slice(0, index + 1), y: y.slice(0, index + 1), name: "push force", kind: "one" }],
      xLabel: "distance [mm]",
      yLabel: `push force [${unit}]`,
      xRange: [0, 1e3 * run.end],
      yRange: [low < 0 ? low - margin : 0, high + margin],
      mark: { x: x[index], y: y[index] },
    });
  }
}

const widthOf = (element) => Math.max(element.clientWidth, 240);

/** Largest height of the ground in magnitude [m]. */
const sizeOf = ({ height = 0, depth = 0, amplitude = 0 }) => Math.abs(height) + depth + Math.abs(amplitude);

function nearChart({ tables }, place, width) {
  const { x, body, ground, contact } = surfacesAt(tables, { ...place, half: NEAR * place.radius });
  const size = 1e3 * sizeOf(tables.ground);
  const edge = 1e3 * place.radius * (1 - Math.sqrt(1 - NEAR ** 2));
  const xs = millimeters(x);
  return chart({
    width,
    lines: [
      { x: xs, y: millimeters(body), name: "body", kind: "one" },
      { x: xs, y: millimeters(ground), name: "ground", kind: "ground" },
      { x: xs, y: millimeters(contact), name: "contact", kind: "contact" },
    ],
    xLabel: "distance [mm]",
    yLabel: "height [mm]",
    xRange: [xs[0], xs.at(-1)],
    yRange: [-size - 0.15 * edge, size + 1.3 * edge], // space for the legend
  });
}

/** The whole body at true scale, with a spoke that turns. */
function bodyPicture({ tables }, { radius, distance, height, angle }) {
  const size = sizeOf(tables.ground);
  const [width, above] = [2 * AROUND * radius, ABOVE * radius + size];
  const at = (x, y) => `${(((x - distance) / width + 0.5) * 1000).toFixed(1)},${(((above - y) / width) * 1000).toFixed(1)}`;
  const bottom = -size - BELOW * radius;
  const { x, body, ground, contact } = surfacesAt(tables, { radius, distance, height, half: 0.95 * radius });
  const rim = Array.from({ length: 181 }, (_, i) => {
    const turn = Math.asin(0.95) + ((2 * Math.PI - 2 * Math.asin(0.95)) * i) / 180;
    return at(distance + radius * Math.sin(turn), height - radius * Math.cos(turn));
  });
  const outline = [...x.map((one, i) => at(one, body[i])), ...rim].join("L");
  const ends = [distance - 0.5 * width, distance + 0.5 * width];
  const steps = Array.from({ length: 400 }, (_, i) => ends[0] + (width * i) / 399);
  const inside = (one) => one > x[0] && one < x.at(-1);
  const surface = [
    ...steps.filter((one) => one <= x[0]).map((one) => at(one, heightAt(tables.ground, one))),
    ...x.map((one, i) => at(one, ground[i])),
    ...steps.filter((one) => one > x[0] && !inside(one)).map((one) => at(one, heightAt(tables.ground, one))),
  ].join("L");
  const touching = x.flatMap((one, i) => (contact[i] === null ? [] : [at(one, contact[i])])).join("L");
  const spoke = at(distance - radius * Math.sin(angle), height - radius * Math.cos(angle));
  return svg(
    "svg",
    {
      viewBox: `0 0 1000 ${Math.round((1000 * (above - bottom)) / width)}`,
      class: "scene",
      role: "img",
      "aria-label": "body on the ground",
    },
    svg("path", { class: "ground", d: `M${at(ends[0], bottom)}L${surface}L${at(ends[1], bottom)}Z` }),
    svg("path", { class: "body", d: `M${outline}Z` }),
    svg("path", { class: "spoke", d: `M${at(distance, height)}L${spoke}` }),
    touching ? svg("path", { class: "contact", d: `M${touching}` }) : null,
  );
}

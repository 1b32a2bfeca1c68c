/** What was found: numbers by the table of the solver, pictures of the contact, and what to know before relying on it. */

import { drawContact } from "./contact_picture.js";
import { el } from "./dom.js";
import { handy, handyUnit, resultUnit, shown } from "./units.js";

/** Numbers that are shown large, those of friction where there is some; all others are in the table. */
const FIRST = [
  "resisting_torque",
  "rolling_resistance_coefficient",
  "dissipated_power",
  "penetration",
  "strain",
  "model_error",
];
const WITH_FRICTION = ["driving_torque", "driving_force", "creepage", "slip_power"];

/** Shares, which read best as percents. */
const PERCENTS = ["strain", "model_error", "creepage", "power_balance_error", "error_estimate", "max_pressure_error"];

export class Results {
  #numbers;
  #pictures;
  #table;
  #warnings;
  #scalars;
  #last = null;

  /**
   * @param {{numbers, pictures, table, warnings}} elements that are filled
   * @param {{name: string, unit: string, description: string}[]} scalars the table of the solver
   */
  constructor({ numbers, pictures, table, warnings }, scalars) {
    [this.#numbers, this.#pictures, this.#table, this.#warnings] = [numbers, pictures, table, warnings];
    this.#scalars = scalars;
    new ResizeObserver(() => this.draw()).observe(pictures);
  }

  /**
   * Show a result.
   * @param {object} result of an answer
   * @param {object} tables its case
   * @param {string[]} warnings those that stand at no field
   */
  show(result, tables, warnings) {
    this.#last = { result, line: "cylinder" in tables };
    const { scalars } = result;
    const names = [...FIRST, ...(tables.rolling.friction > 0 ? WITH_FRICTION : [])];
    this.#numbers.replaceChildren(...names.map((name) => this.#card(name, scalars, tables)));
    this.#table.replaceChildren(
      ...this.#scalars.map(({ name, description }) =>
        el(
          "tr",
          {},
          el("th", { scope: "row" }, sentence(description)),
          el("td", { "data-scalar": name, "data-value": scalars[name] }, this.text(name, scalars[name])),
        ),
      ),
    );
    this.#warnings.replaceChildren(...warnings.map(({ message }) => el("p", {}, message)));
    this.draw();
  }

  /** The main numbers on one line. */
  brief({ scalars }) {
    const [torque, coefficient] = FIRST.map((name) => this.text(name, scalars[name]));
    return `torque ${torque}  ·  coefficient ${coefficient}`;
  }

  /** The value of a scalar result as people read it. */
  text(name, value) {
    if (value === null || value === undefined) return shown(value);
    const [unit, one] = this.unit(name, value);
    return `${shown(value / one, PERCENTS.includes(name) ? 4 : 5)} ${unit}`.trim();
  }

  /** The unit in which one of its values reads best, and the SI value of that. */
  unit(name, value) {
    if (PERCENTS.includes(name)) return ["%", 1e-2];
    return handyUnit(value, resultUnit(this.#scalar(name).unit, this.#last?.line));
  }

  /** Its name as attributes and files have it, in words. */
  label(name) {
    return name.replaceAll("_", " ");
  }

  #scalar(name) {
    return this.#scalars.find((scalar) => scalar.name === name);
  }

  #card(name, scalars, tables) {
    const note = this.#note(name, scalars, tables);
    return el(
      "div",
      { class: "card" },
      el("dt", { title: sentence(this.#scalar(name).description) }, this.label(name)),
      el("dd", { "data-scalar": name, "data-value": scalars[name] }, this.text(name, scalars[name])),
      note ? el("dd", { class: "note" }, note) : null,
    );
  }

  /** What else a number says: engineers ask for the force that keeps a wheel rolling. */
  #note(name, scalars, { rolling }) {
    if (name === "rolling_resistance_coefficient" && scalars[name] !== null) {
      return `a resistance of ${handy(scalars[name] * rolling.load, this.#last.line ? "N/m" : "N")}`;
    }
    if (name === "strain") return "penetration by thickness";
    if (name === "model_error") return "what linear theory leaves open";
    return null;
  }

  /** Draw the pictures, as wide as there is room, in the colors of the page. */
  draw() {
    if (this.#last && this.#pictures.clientWidth > 0) drawContact(this.#pictures, this.#last.result);
  }
}

function sentence(text) {
  return text[0].toUpperCase() + text.slice(1);
}

/** What was found: numbers by the table of the solver, pictures of the contact, and what to know before relying on it. */

import { drawContact } from "./contact_picture.js";
import { el } from "./dom.js";
import { handy, resultUnit, shown } from "./units.js";

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
    return FIRST.slice(0, 3)
      .map((name) => this.text(name, scalars[name]))
      .join("  ·  ");
  }

  /** The value of a scalar result as people read it. */
  text(name, value) {
    if (value !== null && PERCENTS.includes(name)) return `${shown(100 * value, 4)} %`;
    return handy(value, this.unit(name), 5);
  }

  /** Its unit [SI]. */
  unit(name) {
    return resultUnit(this.#scalar(name).unit, this.#last?.line);
  }

  /** What it is, in a few words. */
  label(name) {
    return this.#scalar(name).description.split(",")[0];
  }

  #scalar(name) {
    return this.#scalars.find((scalar) => scalar.name === name);
  }

  #card(name, scalars, tables) {
    const note = this.#note(name, scalars, tables);
    return el(
      "div",
      { class: "card" },
      el("dt", { title: this.#scalar(name).description }, this.label(name)),
      el("dd", { "data-scalar": name, "data-value": scalars[name] }, this.text(name, scalars[name])),
      note ? el("dd", { class: "note" }, note) : null,
    );
  }

  /** What else a number says: engineers ask for the force that keeps a wheel rolling. */
  #note(name, scalars, { rolling }) {
    if (name === "rolling_resistance_coefficient" && scalars[name] !== null) {
      return `times the load: ${handy(scalars[name] * rolling.load, this.#last.line ? "N/m" : "N")} of resistance`;
    }
    if (name === "model_error") return "that much linear theory does not know";
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

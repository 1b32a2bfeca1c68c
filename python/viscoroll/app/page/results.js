/** Display of a result: numbers from the solver's table of scalars, pictures of the contact, and warnings. */

import { bodyOf } from "./case.js";
import { drawContact } from "./contact_picture.js";
import { el } from "./dom.js";
import { inPageUnits } from "./messages.js";
import { BODIES } from "./schema.js";
import { numberText, quantityText, resultUnit, suitableUnit } from "./units.js";

/** Main numbers, unless they are undetermined, and further ones with friction; the table contains all numbers. */
const FIRST = [
  "finite_strain_torque",
  "resisting_torque",
  "rolling_resistance_coefficient",
  "dissipated_power",
  "penetration",
  "strain",
  "model_error",
];
const WITH_FRICTION = ["driving_torque", "driving_force", "creepage", "slip_power"];

/** Ratios that are displayed in percent. */
const PERCENTS = ["strain", "overspeed", "creepage"];
const isPercent = (name) => PERCENTS.includes(name) || name.includes("error");

export class Results {
  #numbers;
  #pictures;
  #table;
  #warnings;
  #scalars;
  #last = null;

  /**
   * @param {{numbers, pictures, table, warnings}} elements elements to fill
   * @param {{name: string, unit: string, description: string}[]} scalars scalars of the solver
   */
  constructor({ numbers, pictures, table, warnings }, scalars) {
    [this.#numbers, this.#pictures, this.#table, this.#warnings] = [numbers, pictures, table, warnings];
    this.#scalars = scalars;
    new ResizeObserver(() => this.draw()).observe(pictures);
  }

  /**
   * Show a result.
   * @param {object} result result of an answer
   * @param {object} tables tables of its case
   * @param {object[]} warnings warnings to show beside the numbers
   */
  show(result, tables, warnings) {
    this.#last = { result, line: BODIES[bodyOf(tables)].line };
    const { scalars } = result;
    const names = [...this.#first(scalars), ...("penetration" in tables.rolling ? ["load"] : []), ...(tables.rolling.friction > 0 ? WITH_FRICTION : [])];
    this.#numbers.replaceChildren(...names.map((name) => this.#card(name, scalars)));
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
    this.#warnings.replaceChildren(...warnings.map(({ message }) => el("p", {}, inPageUnits(message))));
    this.draw();
  }

  /** Text of torque and coefficient, on one line. */
  brief({ scalars }) {
    const torque = this.#first(scalars)[0];
    const [first, coefficient] = [torque, "rolling_resistance_coefficient"].map((name) => this.text(name, scalars[name]));
    return `torque ${first}  ·  coefficient ${coefficient}`;
  }

  /** Names of the main numbers that a result has. */
  #first(scalars) {
    return FIRST.filter((name) => name !== "finite_strain_torque" || scalars[name] !== null);
  }

  /** Text of a scalar result in a suitable unit. */
  text(name, value) {
    if (value === null || value === undefined) return numberText(value);
    const [unit, one] = this.unit(name, value);
    return `${numberText(value / one, isPercent(name) ? 4 : 5)} ${unit}`.trim();
  }

  /** Suitable unit for a value of a scalar result, and the SI value of this unit. */
  unit(name, value) {
    if (isPercent(name)) return ["%", 1e-2];
    return suitableUnit(value, resultUnit(this.#scalar(name).unit, this.#last?.line));
  }

  /** The name of a scalar result in words. */
  label(name) {
    return name.replaceAll("_", " ");
  }

  #scalar(name) {
    return this.#scalars.find((scalar) => scalar.name === name);
  }

  #card(name, scalars) {
    const note = this.#note(name, scalars);
    return el(
      "div",
      { class: "card" },
      el("dt", { title: sentence(this.#scalar(name).description) }, this.label(name)),
      el("dd", { "data-scalar": name, "data-value": scalars[name] }, this.text(name, scalars[name])),
      note ? el("dd", { class: "note" }, note) : null,
    );
  }

  /** Note below a number, for example the force that corresponds to the coefficient. */
  #note(name, scalars) {
    if (name === "rolling_resistance_coefficient" && scalars[name] !== null) {
      return `resisting force ${quantityText(scalars[name] * scalars.load, this.#last.line ? "N/m" : "N")}`;
    }
    if (name === "strain") return "penetration divided by thickness";
    if (name === "resisting_torque" && scalars.finite_strain_torque !== null) return "linear theory";
    if (name === "model_error") return "estimated error of the torque of linear theory";
    return null;
  }

  /** Draw the pictures in the available width and the colors of the page. */
  draw() {
    if (this.#last && this.#pictures.clientWidth > 0) drawContact(this.#pictures, this.#last.result);
  }
}

function sentence(text) {
  return text[0].toUpperCase() + text.slice(1);
}

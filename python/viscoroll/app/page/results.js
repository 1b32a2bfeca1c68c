/** Display of a result: numbers from the solver's table of scalars, pictures of the contact, and warnings. */

import { bodyOf } from "./case.js";
import { drawContact } from "./contact_picture.js";
import { el } from "./dom.js";
import { inPageUnits } from "./messages.js";
import { Report, labelOf } from "./report.js";
import { BODIES } from "./schema.js";
import { resultUnit, suitableUnit } from "./units.js";

export class Results {
  #numbers;
  #pictures;
  #table;
  #warnings;
  #scalars;
  #last = null;

  /**
   * @param {{numbers, pictures, table, warnings}} elements elements to fill
   * @param {{name: string, unit: string, description: string, group: string, precision: string}[]} scalars scalars of
   *   the solver
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
    const { line, words } = BODIES[bodyOf(tables)];
    const report = new Report(result.scalars, this.#scalars, {
      prescribed: "penetration" in tables.rolling ? "penetration" : "load",
      friction: tables.rolling.friction ?? 0,
      angularSpeed: tables.rolling.angular_speed,
      line,
      words,
    });
    this.#last = { result, line, words, report };
    const sections = report.sections();
    this.#numbers.replaceChildren(...sections.answer.map((row) => this.#card(row, report)));
    this.#table.replaceChildren(
      ...Object.entries(sections).flatMap(([title, rows]) => [
        el("tr", {}, el("th", { scope: "colgroup", colspan: 2, class: "section" }, sentence(title))),
        ...rows.map(({ name, label, text }) =>
          el("tr", {}, el("th", { scope: "row" }, sentence(label)), this.#cell("td", name, text)),
        ),
      ]),
    );
    this.#warnings.replaceChildren(...warnings.map(({ message }) => el("p", {}, inPageUnits(message))));
    this.draw();
  }

  /** The first two results of the answer, push force and drive torque, on one line. */
  brief() {
    const results = this.#last.report.sections().answer.filter(({ name }) => name);
    return results.slice(0, 2).map(({ label, text }) => `${label} ${text}`).join("  ·  ");
  }

  /** Suitable unit for a value of a scalar result, and the SI value of this unit. */
  unit(name, value) {
    const { unit, precision } = this.#scalar(name);
    if (precision === "%") return ["%", 1e-2];
    return suitableUnit(value, resultUnit(unit, this.#last?.line));
  }

  /** The name of a scalar result in words. */
  label(name) {
    return labelOf(this.#scalar(name), this.#last?.words);
  }

  #scalar(name) {
    return this.#scalars.find((scalar) => scalar.name === name);
  }

  #card({ name, label, text }, report) {
    const note = name && report.explanation(name);
    return el(
      "div",
      { class: "card" },
      el("dt", {}, label),
      this.#cell("dd", name, text),
      note ? el("dd", { class: "note" }, note) : null,
    );
  }

  #cell(tag, name, text) {
    return el(tag, { "data-scalar": name, "data-value": name && this.#last.result.scalars[name] }, text);
  }

  /** Draw the pictures in the available width and the colors of the page. */
  draw() {
    if (this.#last && this.#pictures.clientWidth > 0) drawContact(this.#pictures, this.#last.result);
  }
}

function sentence(text) {
  return text[0].toUpperCase() + text.slice(1);
}

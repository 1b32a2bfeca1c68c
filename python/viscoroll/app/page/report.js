/** Report of a result: its rows in sections, with the same words, units and digits as in the printed report. */

import { percentText, quantityText, resultUnit } from "./units.js";

/** Text for bodies whose layers have no loss. */
const LOSSLESS = "this material dissipates nothing";

/** Results of a contact with an area that in line contact repeat the contact length, or do not exist. */
const POINT_CONTACT = ["contact_area", "semi_axis_x", "semi_axis_z", "contact_width"];

/** Parts of the dissipated power, which are omitted if they equal it. */
const PARTS = ["bulk_power", "rolling_bulk_power", "counterbody_bulk_power", "slip_power"];

/** Further results of which 0 is a result: a contact reaches the faces. */
const KEPT = ["face_distance"];

/** Relative difference below which the torque of the drive is the resisting torque. */
const SAME_TORQUE = 1e-6;

export class Report {
  #scalars;
  #table;
  #of;

  /**
   * @param {Object<string, number | null>} scalars scalar results [SI units]
   * @param {{name: string, unit: string, description: string, group: string, precision: string}[]} table the solver's
   *   table of scalars, in the order of reports
   * @param {{prescribed: string, friction: number, angularSpeed: number, line: boolean, words: object}} of the given
   *   one of load and penetration, friction, angular speed [rad/s], whether the contact is a line, and words of labels
   */
  constructor(scalars, table, of) {
    [this.#scalars, this.#table, this.#of] = [scalars, table, of];
  }

  /** Rows with name (of a scalar), label and text by the title of their section, as `result_sections` in Python returns them. */
  sections() {
    const rows = (group) =>
      this.#table
        .filter((scalar) => this.#group(scalar) === group && this.#isReported(scalar.name))
        .filter(({ name }) => group !== "other" || KEPT.includes(name) || this.#scalars[name] !== 0)
        .map(({ name }) => ({ name, label: this.label(name), text: this.text(name) }));
    const lossless = this.#scalars.bulk_power === 0 ? [{ label: "dissipation in the layers", text: LOSSLESS }] : [];
    return { answer: [...lossless, ...rows("answer")], "how certain": rows("certainty"), "further results": rows("other") };
  }

  /** Label of a scalar in the words for the body, without the explanation after a comma. */
  label(name) {
    return labelOf(this.#scalar(name), this.#of.words);
  }

  /** Explanation of a label, or an empty text. */
  explanation(name) {
    return this.#scalar(name).description.split(", ").slice(1).join(", ");
  }

  /** A scalar with a readable unit, its digits and its error. */
  text(name) {
    const value = this.#scalars[name] ?? null;
    const { unit, precision, group } = this.#scalar(name);
    if (precision === "%" && value !== null) return percentText(value, group === "certainty" ? 2 : 3);
    const digits = name === this.#of.prescribed ? 6 : 3;
    return quantityText(value, resultUnit(unit, this.#of.line), this.#relativeError(name, precision), digits);
  }

  /** Sum of the relative error estimates of mesh and theory; null for given values and if there are none. */
  #relativeError(name, precision) {
    if (name === this.#of.prescribed) return null;
    const known = precision.split(" ").map((error) => this.#scalars[error] ?? null).filter((error) => error !== null);
    return known.length ? known.reduce((sum, error) => sum + error, 0) : null;
  }

  /** Section of a scalar; the reasons are those of `_group` in solution/text.py. */
  #group({ name, group }) {
    const { driving_torque: drive, resisting_torque: resistance } = this.#scalars;
    if (name === "finite_strain_torque" && this.#of.friction === 0) {
      return Math.abs(drive - resistance) <= SAME_TORQUE * Math.abs(drive) ? group : "other";
    }
    if (group !== "friction") return group;
    return this.#of.friction > 0 ? "answer" : "other";
  }

  #isReported(name) {
    const { prescribed, line, angularSpeed } = this.#of;
    const value = this.#scalars[name] ?? null;
    if (name === prescribed || (line && POINT_CONTACT.includes(name))) return false;
    if (name === "finite_strain_angular_speed" && value === angularSpeed) return false;
    if (PARTS.includes(name) && value === this.#scalars.dissipated_power) return false;
    return value !== null || name === (prescribed === "load" ? "penetration" : "load");
  }

  #scalar(name) {
    return this.#table.find((scalar) => scalar.name === name);
  }
}

/** Label of an entry of the solver's table in the words for a body. */
export function labelOf({ description }, words = {}) {
  return Object.entries(words).reduce((text, [from, to]) => text.replaceAll(from, to), description.split(",")[0]);
}

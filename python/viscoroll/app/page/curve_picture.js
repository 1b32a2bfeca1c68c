/** Chart of a result against speed, load or thickness, to which points are added as they are solved. */

import { chart } from "./chart.js";
import { ALONG, pointsOf, typedAlong } from "./curve.js";
import { el } from "./dom.js";

/** Results that can be drawn, and those that exist only with friction. */
const DRAWN = [
  "rolling_resistance_torque",
  "rolling_resistance_force",
  "rolling_resistance_coefficient",
  "dissipated_power",
  "penetration",
  "strain",
  "max_pressure",
  "contact_length",
  "driving_torque",
  "driving_force",
  "creepage",
];
const OF_FRICTION = ["driving_force", "creepage"];

export class CurvePicture {
  #root;
  #results;
  #along = "speed";
  #name = DRAWN[0];
  #state = null;
  #points = [];
  #found = [];
  #marked = null;

  /**
   * @param {HTMLElement} root element with a figure and the controls
   * @param {Results} results names and units of the results
   * @param {() => void} ask called to request another curve
   */
  constructor(root, results, ask) {
    this.#root = root;
    this.#results = results;
    const chosen = root.querySelector("#curve-of");
    chosen.replaceChildren(...DRAWN.map((name) => el("option", { value: name }, results.label(name))));
    chosen.addEventListener("change", () => {
      this.#name = chosen.value;
      this.#draw();
    });
    const buttons = Object.entries(ALONG).map(([along, { label }]) =>
      el(
        "button",
        {
          type: "button",
          "aria-pressed": String(along === this.#along),
          "data-along": along,
          onclick: () => this.#choose(along, ask),
        },
        label,
      ),
    );
    root.querySelector("#curve-along").replaceChildren(...buttons);
  }

  /**
   * Remove the curve, and return the cases of the next one.
   * @param {object} state
   * @param {object|null} kept state of a case whose curve follows, if its numbers have the same units
   */
  begin(state, kept) {
    this.#state = state;
    const points = pointsOf(state, this.#along);
    const others = kept ? pointsOf(kept, this.#along).filter(({ unit }) => unit === points[0]?.unit) : [];
    this.#points = [...points, ...others.map((point) => ({ ...point, isKept: true }))];
    this.#found = [];
    this.#marked = null;
    this.#root.dataset.filling = "begun";
    for (const option of this.#root.querySelectorAll("option")) {
      option.disabled = OF_FRICTION.includes(option.value) && state.friction === 0;
    }
    return this.#points;
  }

  /** Add the answer for the case with an index in the list that `begin` returned. */
  add(index, { result }) {
    this.#found.push({ ...this.#points[index], scalars: result?.scalars ?? null });
    this.#root.dataset.filling = this.#found.length === this.#points.length ? "done" : "filling";
    this.#draw();
  }

  /** Mark the result of the case itself. */
  mark(result) {
    this.#marked = result.scalars;
    this.#draw();
  }

  #choose(along, ask) {
    this.#along = along;
    for (const button of this.#root.querySelectorAll("[data-along]"))
      button.setAttribute("aria-pressed", button.dataset.along === along);
    ask();
  }

  #draw() {
    const typed = typedAlong(this.#state, this.#along);
    if (!typed) return;
    const solved = this.#found
      .filter(({ scalars }) => Number.isFinite(scalars?.[this.#name]))
      .sort((a, b) => a.at - b.at);
    const hasKept = this.#points.some(({ isKept }) => isKept);
    const sizes = solved.map(({ scalars }) => Math.abs(scalars[this.#name]));
    const [unit, one] = this.#results.unit(this.#name, Math.max(0, ...sizes) || this.#marked?.[this.#name]);
    const ends = this.#points.map(({ at }) => at);
    const mark =
      this.#marked && Number.isFinite(this.#marked[this.#name])
        ? { x: typed[0], y: this.#marked[this.#name] / one }
        : undefined;
    this.#root.querySelector("figure").replaceChildren(
      chart({
        width: Math.max(this.#root.clientWidth, 280),
        lines: (hasKept ? [false, true] : [false]).map((kept) => {
          const points = solved.filter(({ isKept = false }) => isKept === kept);
          return {
            x: points.map(({ at }) => at),
            y: points.map(({ scalars }) => scalars[this.#name] / one),
            name: kept ? "kept case" : hasKept ? "this case" : this.#results.label(this.#name),
            kind: kept ? "two" : "one",
            points: !kept,
          };
        }),
        xLabel: `${ALONG[this.#along].label} [${typed[1]}]`,
        yLabel: `${this.#results.label(this.#name)}${unit ? ` [${unit}]` : ""}`,
        logX: true,
        xRange: [Math.min(...ends), Math.max(...ends)],
        mark,
      }),
    );
    const failed = this.#found.filter(({ scalars }) => scalars === null).length;
    const open = this.#points.length - this.#found.length;
    this.#root.querySelector("#curve-said").textContent = [
      open > 0
        ? `Coarse mesh; ${open} of ${this.#points.length} points are not solved yet.`
        : "Coarse mesh; the ring marks the case above.",
      OF_FRICTION.includes(this.#name) && this.#state.friction === 0 ? "This result exists only with friction." : "",
      failed ? failedText(failed, this.#found.length, this.#along) : "",
    ].join(" ");
  }
}

function failedText(failed, found, along) {
  if (failed === found) return "No point of the curve has a result.";
  return `${failed} of the points have no result: this case has none at that ${ALONG[along].label}.`;
}

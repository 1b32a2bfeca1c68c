/**
 * Solves only the newest case: on a coarse mesh while numbers change; after a pause, to its accuracy; then a curve.
 */

import { bodyOf } from "./case.js";
import { BODIES } from "./schema.js";

/** Pause without changes after which the case is solved to its accuracy [ms]. */
const REST = 250;

/** Number of nodes across a contact on a coarse mesh, which gives an accuracy of some percent. */
const ACROSS = 16;

/** Nodes per revolution of coarse meshes: smallest number, number before the first answer, largest number. */
const FEWEST = 300;
const FIRST = { point: 400, line: 2000 };
const MOST = { point: 3000, line: Infinity };

export class Newest {
  #solver;
  #tell;
  #wanted = null;
  #running = false;
  #abort = new AbortController();
  #changed = () => {};
  #across = null; // body of the last answer, and the nodes per revolution for ACROSS nodes across its contact

  /**
   * @param {object} solver a solver of solver.js
   * @param {object} tell functions to call: `solving(stage)`, `solved(answer, {tables, stage, seconds})`,
   *   `temperature(answer)`, `point(index, answer)` for the points of the curve, and `failed(error)`
   */
  constructor(solver, tell) {
    this.#solver = solver;
    this.#tell = tell;
  }

  /**
   * Request a case; it replaces all earlier requests.
   * @param {object} tables tables of the case
   * @param {number} radius outer radius [m]
   * @param {object[]} curve cases of a curve, in the order of solving, to be solved on coarse meshes
   * @param {object|null} [thermal] table of the temperature, if it is to be computed
   */
  ask(tables, radius, curve, thermal = null) {
    this.#wanted = { tables, radius, curve, thermal };
    this.#changed();
    this.#abort.abort(); // does not abort a coarse solve, which soon ends and gives a picture
    this.#abort = new AbortController();
    if (!this.#running) this.#run();
  }

  async #run() {
    this.#running = true;
    while (this.#wanted) {
      const { tables, radius, curve, thermal } = this.#wanted;
      this.#wanted = null;
      const { signal } = this.#abort;
      try {
        await this.#solve(tables, "coarse", radius);
        if (this.#wanted || (await this.#isDisturbed())) continue;
        const { result } = await this.#solve(tables, "fine", radius, signal);
        if (thermal && result) {
          this.#tell.temperature(await this.#solver.temperature({ case: tables, thermal }, signal));
        }
        await this.#follow(curve, signal);
      } catch (error) {
        this.#failed(error);
      }
    }
    this.#running = false;
  }

  async #solve(tables, stage, radius, signal) {
    this.#tell.solving(stage);
    const begun = performance.now();
    const meshed = stage === "coarse" ? coarse(tables, this.#nodes(tables, radius)) : tables;
    const answer = await this.#solver.solve({ case: meshed, fields: true }, signal);
    const length = answer.result?.scalars.semi_axis_x;
    if (length > 0) this.#across = { body: bodyOf(tables), nodes: (ACROSS * Math.PI * radius) / length };
    this.#tell.solved(answer, { tables, stage, seconds: (performance.now() - begun) / 1e3 });
    return answer;
  }

  async #follow(curve, signal) {
    for (const [index, { tables, radius }] of curve.entries()) {
      if (signal.aborted) return;
      const request = { case: coarse(tables, this.#nodes(tables, radius)), fields: false };
      this.#tell.point(index, await this.#solver.solve(request, signal));
    }
  }

  #nodes(tables, radius) {
    const body = bodyOf(tables);
    const contact = BODIES[body].line ? "line" : "point";
    if (this.#across?.body !== body || !(radius > 0)) return FIRST[contact];
    return Math.round(Math.min(Math.max(this.#across.nodes, FEWEST), MOST[contact]));
  }

  /** Whether the case changes during the pause. */
  async #isDisturbed() {
    return new Promise((resolve) => {
      const timer = setTimeout(() => resolve(false), REST);
      this.#changed = () => {
        clearTimeout(timer);
        resolve(true);
      };
    });
  }

  #failed(error) {
    if (error.name !== "AbortError") this.#tell.failed(error);
  }
}

/** Tables of the case with nodes per revolution instead of an accuracy. */
function coarse(tables, nodes) {
  const { accuracy: _, ...numerics } = tables.numerics;
  return { ...tables, numerics: { ...numerics, nodes_per_revolution: nodes } };
}

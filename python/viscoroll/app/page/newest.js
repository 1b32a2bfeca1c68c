/**
 * Solves the newest case alone: coarsely while numbers change, to its accuracy when they rest, and then along a curve.
 */

/** How long nothing changes before the page takes it as rest [ms]. */
const REST = 250;

/** Nodes across a contact of a coarse answer, by which it is right to some percent. */
const ACROSS = 16;

/** Nodes per revolution of coarse meshes: at the least, before any answer is there, and at the most. */
const FEWEST = 300;
const FIRST = { ball: 400, wheel: 400, cylinder: 2000 };
const MOST = 3000;

export class Newest {
  #solver;
  #tell;
  #wanted = null;
  #running = false;
  #abort = new AbortController();
  #changed = () => {};
  #across = null; // nodes per revolution that the last answer asks for, and of what

  /**
   * @param {object} solver as of solver.js
   * @param {object} tell `solving(stage)`, `solved(answer, {tables, stage, seconds})`, `point(place, answer)`, `failed(error)`
   */
  constructor(solver, tell) {
    this.#solver = solver;
    this.#tell = tell;
  }

  /**
   * Ask for a case, in place of all that was asked for.
   * @param {object} tables the case
   * @param {number} radius outer radius [m]
   * @param {object[]} curve cases along a curve, coarse ones, in the order in which they are to be solved
   */
  ask(tables, radius, curve) {
    this.#wanted = { tables, radius, curve };
    this.#changed();
    this.#abort.abort(); // what is coarse and under way is not of this signal: it is soon there, and shown
    this.#abort = new AbortController();
    if (!this.#running) this.#run();
  }

  async #run() {
    this.#running = true;
    while (this.#wanted) {
      const { tables, radius, curve } = this.#wanted;
      this.#wanted = null;
      const { signal } = this.#abort;
      try {
        await this.#solve(tables, "coarse", radius);
        if (this.#wanted || (await this.#isDisturbed())) continue;
        await this.#solve(tables, "fine", radius, signal);
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
  }

  async #follow(curve, signal) {
    for (const [place, { tables, radius }] of curve.entries()) {
      if (signal.aborted) return;
      const request = { case: coarse(tables, this.#nodes(tables, radius)), fields: false };
      this.#tell.point(place, await this.#solver.solve(request, signal));
    }
  }

  #nodes(tables, radius) {
    const body = bodyOf(tables);
    if (this.#across?.body !== body || !(radius > 0)) return FIRST[body];
    return Math.round(Math.min(Math.max(this.#across.nodes, FEWEST), body === "cylinder" ? Infinity : MOST));
  }

  /** Whether anything changes within the time of rest. */
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

const bodyOf = (tables) => Object.keys(FIRST).find((name) => name in tables);

/** The case on a mesh of its own in place of an accuracy. */
function coarse(tables, nodes) {
  const { accuracy: _, ...numerics } = tables.numerics;
  return { ...tables, numerics: { ...numerics, nodes_per_revolution: nodes } };
}

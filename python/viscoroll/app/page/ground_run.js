/** The live view "Over ground": computes a history, and plays it while it is computed. */

import { isLine, outerRadius } from "./case.js";
import { GroundPicture } from "./ground_picture.js";
import { motionOf } from "./over_ground.js";

/** Pause without changes after which a history starts [ms]. */
const REST = 250;

/** Time in which a history is played if it is computed faster [ms], and shortest time between two pictures [ms]. */
const PLAYED = 6000;
const BETWEEN = 40;

export class GroundRun {
  #root;
  #solver;
  #picture = null;
  #sayError;
  #state = null;
  #abort = new AbortController();
  #timer = null;

  /**
   * @param {HTMLElement} root section of the view, with a button and a message
   * @param {object} solver a solver of solver.js that computes nothing else
   * @param {(error: object) => string} sayError shows an error at its field and returns its text
   */
  constructor(root, solver, sayError) {
    this.#root = root;
    this.#solver = solver;
    this.#sayError = sayError;
    root.querySelector("button").addEventListener("click", () => {
      if (root.dataset.run === "rolling") this.#stop();
      else this.#start();
    });
  }

  /** Request the history of a state; it replaces the previous one. Without an obstacle the view is hidden. */
  ask(state) {
    const wanted = state.obstacle === "none" ? null : state;
    const isSame = wanted && this.#state && JSON.stringify(motionOf(wanted)) === JSON.stringify(motionOf(this.#state));
    if (isSame) return;
    this.#state = wanted;
    this.#end();
    this.#root.hidden = !wanted;
    if (wanted) this.#timer = setTimeout(() => this.#start(), REST);
  }

  #end() {
    clearTimeout(this.#timer);
    this.#abort.abort();
    this.#abort = new AbortController();
  }

  #stop() {
    this.#end();
    this.#show("stopped", "Stopped.");
  }

  async #start() {
    this.#end();
    const { signal } = this.#abort;
    const run = {
      tables: motionOf(this.#state),
      radius: outerRadius(this.#state),
      line: isLine(this.#state),
      series: {},
      begun: performance.now(),
    };
    run.end = run.tables.motion.distance.at(-1);
    this.#root.dataset.of = JSON.stringify(run.tables); // for programs that read the page, such as its tests
    this.#show("rolling", "Computing the state at rest …");
    try {
      this.#picture ??= new GroundPicture(this.#root, await this.#solver.historyScalars());
      if (signal.aborted) return;
      this.#picture.clear();
      const answer = this.#solver.roll({ case: run.tables }, (part) => this.#receive(run, part, signal), signal);
      const played = this.#play(run, signal);
      const { result, error } = await answer;
      run.isComputed = true;
      if (error) this.#fail(this.#sayError(error));
      else await this.#finish(run, result, played, signal);
    } catch (error) {
      if (error.name !== "AbortError") this.#fail(error.message);
    }
  }

  #receive(run, part, signal) {
    if (signal.aborted) return;
    for (const [name, values] of Object.entries(part)) (run.series[name] ??= []).push(...values);
    const steps = run.series.time.length - 1;
    run.first ??= performance.now();
    run.said = `${steps} steps, ${perStep(performance.now() - run.first, steps)}.`;
  }

  async #finish(run, { nodes_per_revolution: nodes }, played, signal) {
    run.said = `${run.said} ${nodes} nodes per revolution, without friction.`;
    await played;
    if (!signal.aborted) this.#show("done", run.said);
  }

  #fail(text) {
    this.#end();
    this.#picture?.clear();
    this.#show("failed", text);
  }

  /** Play the history, at most up to the newest instant, until its end. */
  async #play(run, signal) {
    const isStill = globalThis.matchMedia("(prefers-reduced-motion: reduce)").matches;
    let [before, shown, frames, position] = [performance.now(), -1, 0, 0];
    while (!signal.aborted) {
      await new Promise((resolve) => setTimeout(resolve, BETWEEN));
      await new Promise(requestAnimationFrame);
      const now = performance.now();
      const computed = run.series.distance?.at(-1) ?? 0;
      position = isStill ? computed : Math.min(position + (run.end * (now - before)) / PLAYED, computed);
      before = now;
      const index = (run.series.distance ?? []).findLastIndex((distance) => distance <= position);
      if (signal.aborted) return;
      if (index > shown) {
        shown = index;
        this.#root.dataset.frames = frames += 1;
        this.#picture.draw(run, run.series, index);
        this.#root.querySelector(".said").textContent = run.said;
      }
      if (run.isComputed && position >= computed) return;
    }
  }

  #show(run, text) {
    this.#root.dataset.run = run;
    const said = this.#root.querySelector(".said");
    said.textContent = text;
    said.dataset.kind = run === "failed" ? "error" : "note";
    this.#root.querySelector("button").textContent = run === "rolling" ? "Stop" : "Roll again";
  }
}

const perStep = (milliseconds, steps) =>
  steps > 0 ? `${(milliseconds / steps).toFixed(1)} ms per step` : "first contact";

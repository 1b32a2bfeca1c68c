/**
 * The solvers: the program that serves the page, or WebAssembly in a worker. Both have the methods
 *
 *     async solve(request, signal) -> {result} or {error}    async scalars() -> [{name, unit, description}]
 *     async open(text) -> {tables, skipped} or {error}       the case of a case file
 *     async roll(request, each, signal) -> {result} or {error}   a history; `each` receives parts of its time series
 *     async historyScalars() -> [{name, unit, description}]
 *     async temperature(request, signal) -> {temperature} or {error}    only if `hasTemperature`
 *
 * for the same requests. An aborted signal ends a solve, and its promise is rejected with an AbortError.
 */

import { openCase } from "./case_file.js";
import { withMaterials } from "./tabulated.js";

/** The solver that the page specifies. */
export function connect(start) {
  if (start.solver === "native") return new NativeSolver();
  return new WorkerSolver(globalThis.viscorollWorker, globalThis.viscorollMaterials);
}

/** Solver in the program that serves the page. */
class NativeSolver {
  where = "on this machine, by the installed library";
  hasTemperature = true;

  async solve(request, signal) {
    return post("solve", request, signal);
  }

  async open(text) {
    return post("open", text);
  }

  async temperature(request, signal) {
    return post("temperature", request, signal);
  }

  async scalars() {
    return post("scalars", {});
  }

  async historyScalars() {
    return post("history_scalars", {});
  }

  /** The answer is a line of JSON for each part, and a last one for the answer. */
  async roll(request, each, signal) {
    const response = await respond("roll", request, signal);
    const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
    let text = "";
    for (;;) {
      const { value, done } = await reader.read();
      if (done) throw new Error(ENDED);
      const lines = (text + value).split("\n");
      text = lines.pop();
      for (const { part, answer } of lines.map((line) => JSON.parse(line))) {
        if (answer) return answer;
        each(part);
      }
    }
  }
}

const ENDED = "viscoroll app does not respond; start it again if it has ended.";

async function post(name, content, signal) {
  return (await respond(name, content, signal)).json();
}

async function respond(name, content, signal) {
  const options = { method: "POST", body: JSON.stringify(content), signal };
  let response;
  try {
    response = await fetch(name, options);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Error(ENDED);
  }
  if (!response.ok) throw new Error(`viscoroll app rejects the request: ${response.status} ${response.statusText}`);
  return response;
}

/** Solver in a worker, which answers one request after the other. To abort one, the worker is replaced by a new one. */
class WorkerSolver {
  where = "in this browser, by WebAssembly; no data leave it";
  hasTemperature = false;
  #script;
  #materials;
  #worker = null;
  #waiting = new Map();
  #count = 0;

  /**
   * @param {string} text script of the worker; a text also works on a page that was opened as a file
   * @param {object} materials tables for tabulated.js
   */
  constructor(text, materials) {
    this.#script = URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    this.#materials = materials;
  }

  async solve(request, signal) {
    const { known, error } = withMaterials(request, this.#materials);
    return error ? { error } : this.#ask("solve", known, signal);
  }

  async roll(request, each, signal) {
    const { known, error } = withMaterials(request, this.#materials);
    return error ? { error } : this.#ask("roll", known, signal, each);
  }

  async open(text) {
    return openCase(text);
  }

  async scalars() {
    return this.#ask("scalars", null);
  }

  async historyScalars() {
    return this.#ask("historyScalars", null);
  }

  #ask(name, content, signal, each = () => {}) {
    signal?.throwIfAborted();
    this.#worker ??= this.#newWorker();
    const id = (this.#count += 1);
    return new Promise((resolve, reject) => {
      const aborted = () => {
        this.#end(new DOMException("replaced by a newer request", "AbortError"));
      };
      const settled = (settle) => (value) => {
        signal?.removeEventListener("abort", aborted);
        settle(value);
      };
      this.#waiting.set(id, { resolve: settled(resolve), reject: settled(reject), each });
      signal?.addEventListener("abort", aborted);
      this.#worker.postMessage({ id, name, content });
    });
  }

  #newWorker() {
    const worker = new Worker(this.#script);
    worker.onmessage = ({ data: { id, part, answer, failure } }) => {
      const request = this.#waiting.get(id);
      if (part) return request?.each(part);
      this.#waiting.delete(id);
      if (failure === undefined) request?.resolve(answer);
      else request?.reject(new Error(failure));
    };
    worker.onerror = (event) =>
      this.#end(new Error(`the solver does not start: ${event.message ?? "unknown reason"}`));
    return worker;
  }

  #end(reason) {
    this.#worker?.terminate();
    this.#worker = null;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const request of waiting) request.reject(reason);
  }
}

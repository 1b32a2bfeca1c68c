/** The page: it makes a case from the form, has it solved, and shows numbers and pictures. */

import { caseOf, initialState, outerRadius, stateOf } from "./case.js";
import { connectCopies } from "./copies.js";
import { CurvePicture } from "./curve_picture.js";
import { el } from "./dom.js";
import { EXAMPLES, exampleState } from "./examples.js";
import { Form } from "./form.js";
import { fragmentOf, stateOfFragment } from "./link.js";
import { Newest } from "./newest.js";
import { Results } from "./results.js";
import { connect } from "./solver.js";
import { followTheme } from "./theme.js";

const at = (id) => document.getElementById(id);

class Page {
  #state;
  #form = new Form(at("form"), (state) => this.#change(state));
  #results;
  #curve;
  #newest = null; // null until there is a solver

  /** @param {object} start the solver, and maybe an initial case, from the script element of the page */
  constructor(start) {
    const linked = stateOfFragment(location.hash);
    const { state, left } = linked || !start.case ? { state: linked ?? initialState(), left: [] } : stateOf(start.case);
    this.#state = state;
    this.#form.show(state);
    if (left.length) at("left").textContent = `The form does not support ${left.join(", ")} of the case file, and ignores it.`;
    this.#connectExamples();
    connectCopies(() => this.#state);
    globalThis.addEventListener("hashchange", () => this.#follow(stateOfFragment(location.hash)));
    at("brief").addEventListener("click", () => at("answer").scrollIntoView({ behavior: "smooth" }));
    new IntersectionObserver(([numbers]) => (at("brief").hidden = numbers.isIntersecting)).observe(at("numbers"));
    this.#solveBy(connect(start)).catch((error) => this.#fail(error));
  }

  async #solveBy(solver) {
    if (!solver) {
      say(
        "This page has no solver, because the site was built without WebAssembly. `viscoroll app` serves it with a solver.",
      );
      return;
    }
    const elements = { numbers: at("numbers"), pictures: at("pictures"), table: at("table"), warnings: at("warnings") };
    this.#results = new Results(elements, await solver.scalars());
    this.#curve = new CurvePicture(at("curve"), this.#results, () => this.#ask());
    this.#newest = new Newest(solver, {
      solving: (stage) => this.#tellSolving(stage),
      solved: (...of) => this.#tellSolved(...of),
      point: (index, answer) => this.#curve.add(index, answer),
      failed: (error) => this.#fail(error),
    });
    at("where").textContent = `Solved ${solver.where}.`;
    followTheme(() => this.#results.draw());
    this.#ask();
  }

  #change(state) {
    this.#state = state;
    history.replaceState(null, "", fragmentOf(state) || "#");
    this.#ask();
  }

  /** Show a state that does not come from the form. */
  #follow(state) {
    if (!state || fragmentOf(state) === fragmentOf(this.#state)) return;
    this.#form.show(state);
    this.#change(state);
  }

  #ask() {
    if (this.#newest && document.body.dataset.wrong === "true") this.#takeBack();
    this.#newest?.ask(caseOf(this.#state), outerRadius(this.#state), this.#curve.begin(this.#state));
  }

  #connectExamples() {
    const select = at("examples");
    const options = Object.entries(EXAMPLES).map(([value, label]) => el("option", { value }, label));
    select.replaceChildren(el("option", { value: "" }, "choose …"), ...options);
    select.addEventListener("change", () => {
      if (select.value) this.#follow(exampleState(select.value));
      select.value = "";
    });
  }

  #tellSolving(stage) {
    document.body.dataset.stage = stage;
    if (stage === "fine" && at("said").textContent) say(`${at("said").textContent} Refining …`);
  }

  #tellSolved({ result, error }, { tables, stage, seconds }) {
    this.#form.sayNothing();
    document.body.dataset.wrong = Boolean(error);
    if (error) this.#tellError(error);
    else this.#tellResult(result, tables, stage, seconds);
    at("answer").dataset.of = JSON.stringify(tables); // for programs that read the page, such as its tests
    document.body.dataset.stage = `${stage}-solved`;
  }

  #tellError(error) {
    at("error").textContent = this.#form.sayError(error);
    at("brief").textContent = "No result ↓";
    say("");
  }

  #tellResult(result, tables, stage, seconds) {
    const warnings = result.warnings.filter(({ kind }) => stage === "fine" || kind !== "coarse_mesh");
    at("error").textContent = "";
    this.#results.show(result, tables, this.#form.sayWarnings(warnings));
    this.#curve.mark(result);
    at("brief").textContent = `${this.#results.brief()} ↓`;
    say(stage === "coarse" ? `Result on a coarse mesh (${meshText(result, seconds)}).` : refinedText(result, seconds));
  }

  /** Remove the messages about the previous case, while the new one is solved. */
  #takeBack() {
    this.#form.sayNothing();
    at("error").textContent = "";
    say("Solving …");
  }

  /** Show an error of the page itself, or of the connection to the solver. */
  #fail(error) {
    document.body.dataset.wrong = true;
    at("error").textContent = error.message;
    say("");
  }
}

function say(text) {
  at("said").textContent = text;
}

function meshText({ scalars }, seconds) {
  const time = seconds < 1 ? `${Math.round(1e3 * seconds)} ms` : `${seconds.toFixed(1)} s`;
  return `${Math.round(scalars.nodes_per_revolution)} nodes per revolution, ${time}`;
}

function refinedText(result, seconds) {
  const state = result.state === "converged" ? "" : ` ${result.state.replaceAll("_", " ")},`;
  const percent = (100 * result.scalars.error_estimate).toPrecision(2);
  return `Refined:${state} estimated error of the mesh ${percent} % (${meshText(result, seconds)}).`;
}

new Page(JSON.parse(at("start").textContent));

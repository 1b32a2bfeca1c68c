/** The page: it makes a case from the form, has it solved, and shows numbers and pictures. */

import { caseOf, initialState, outerRadius, stateOf, thermalOf } from "./case.js";
import { Comparison } from "./comparison.js";
import { connectCopies } from "./copies.js";
import { CurvePicture } from "./curve_picture.js";
import { el } from "./dom.js";
import { EXAMPLES, exampleState } from "./examples.js";
import { NAME, connectFiles } from "./files.js";
import { Form } from "./form.js";
import { GroundRun } from "./ground_run.js";
import { fragmentOf, stateOfFragment } from "./link.js";
import { Newest } from "./newest.js";
import { Results } from "./results.js";
import { connect } from "./solver.js";
import { TemperaturePicture } from "./temperature_picture.js";
import { followTheme } from "./theme.js";

/** Largest size of a case file [bytes]; the server of the page has the same limit. */
const LARGEST_FILE = 1_000_000;

const DOWNLOADED =
  `${NAME} is in the downloads. Others open it by \`viscoroll app ${NAME}\`, or by dropping it on this page.`;

const at = (id) => document.getElementById(id);

class Page {
  #state;
  #form;
  #temperature = new TemperaturePicture(at("temperature"));
  #results;
  #comparison;
  #curve;
  #ground;
  #solver;
  #newest = null; // null until the solver answers

  /** @param {object} start the solver, and maybe an initial case, from the script element of the page */
  constructor(start) {
    this.#solver = connect(start);
    this.#form = new Form(at("form"), this.#solver.hasTemperature, (state) => this.#change(state));
    this.#state = stateOfFragment(location.hash) ?? (start.case ? this.#stateOfFile(start.case, []) : initialState());
    this.#form.show(this.#state);
    this.#ground = new GroundRun(at("over-ground"), connect(start), (error) => this.#form.sayError(error));
    this.#connectExamples();
    const isServedToOthers = start.solver !== "native" && location.protocol.startsWith("http");
    connectCopies(() => this.#state, isServedToOthers);
    connectFiles({
      state: () => this.#state,
      open: (file) => this.#open(file),
      downloaded: () => sayOfFile(DOWNLOADED),
    });
    globalThis.addEventListener("hashchange", () => this.#follow(stateOfFragment(location.hash)));
    at("brief").addEventListener("click", () => at("answer").scrollIntoView({ behavior: "smooth" }));
    new IntersectionObserver(([numbers]) => (at("brief").hidden = numbers.isIntersecting)).observe(at("numbers"));
    this.#start().catch((error) => this.#fail(error));
  }

  async #start() {
    const elements = { numbers: at("numbers"), pictures: at("pictures"), table: at("table"), warnings: at("warnings") };
    this.#results = new Results(elements, await this.#solver.scalars());
    const ofKept = { keep: at("keep"), exchange: at("exchange"), remove: at("remove-kept"), said: at("kept-said") };
    this.#comparison = new Comparison(
      { ...ofKept, numbers: at("numbers"), pictures: at("kept-pictures"), root: at("cases") },
      { changed: () => this.#ask(), open: (state) => this.#follow(state) },
    );
    this.#curve = new CurvePicture(at("curve"), this.#results, () => this.#ask());
    this.#newest = new Newest(this.#solver, {
      solving: (stage) => this.#tellSolving(stage),
      solved: (...of) => this.#tellSolved(...of),
      temperature: (answer) => this.#tellTemperature(answer),
      point: (index, answer) => this.#curve.add(index, answer),
      failed: (error) => this.#fail(error),
    });
    at("where").textContent = `Solved ${this.#solver.where}.`;
    followTheme(() => {
      this.#results.draw();
      this.#comparison.draw();
    });
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

  /** Open a case file. */
  async #open(file) {
    const { tables, skipped, error } = await this.#read(file);
    if (error) {
      sayOfFile(`${file.name} is not opened: ${error.message}`, "error");
      return;
    }
    sayOfFile(`${file.name} is opened.`);
    this.#follow(this.#stateOfFile(tables, skipped));
  }

  async #read(file) {
    if (file.size > LARGEST_FILE) return { error: { message: `a case file must have at most ${LARGEST_FILE} bytes` } };
    try {
      return await this.#solver.open(await file.text());
    } catch (error) {
      return { error };
    }
  }

  /** The state for the tables of a case file; the page shows which parts of the file it ignores. */
  #stateOfFile(tables, skipped) {
    const { state, left } = stateOf(tables);
    const ignored = [...skipped.map((name) => `[${name}]`), ...left];
    if (ignored.length) {
      sayOfFile(`The page ignores parts of the case file that it does not support: ${ignored.join(", ")}.`, "warning");
    }
    return state;
  }

  #ask() {
    if (this.#newest && document.body.dataset.wrong === "true") this.#takeBack();
    this.#ground.ask(this.#state);
    const isComputed = this.#solver.hasTemperature && this.#state.temperature === "on";
    this.#temperature.begin(isComputed);
    this.#comparison?.wait();
    this.#newest?.ask(
      caseOf(this.#state),
      outerRadius(this.#state),
      this.#curve.begin(this.#state, this.#comparison.state),
      isComputed ? thermalOf(this.#state) : null,
    );
  }

  #connectExamples() {
    const select = at("examples");
    const options = Object.entries(EXAMPLES).map(([value, label]) => el("option", { value }, label));
    select.replaceChildren(el("option", { value: "" }, "choose …"), ...options);
    select.addEventListener("change", () => {
      if (select.value) this.#follow(exampleState(select.value));
      sayOfFile("");
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
    at("brief").textContent = "No result\u00a0↓";
    say("");
  }

  #tellResult(result, tables, stage, seconds) {
    const warnings = result.warnings.filter(({ kind }) => stage === "fine" || kind !== "coarse_mesh");
    at("error").textContent = "";
    this.#form.markWarnings(warnings);
    this.#results.show(result, tables, warnings);
    const isOfForm = stage === "fine" && JSON.stringify(caseOf(this.#state)) === JSON.stringify(tables);
    this.#comparison.use(result, tables, isOfForm ? this.#state : null);
    this.#curve.mark(result);
    at("brief").textContent = `${this.#results.brief()}${countText(warnings.length)}\u00a0↓`;
    say(stage === "coarse" ? `Result on a coarse mesh (${meshText(result, seconds)}).` : refinedText(result, seconds));
  }

  #tellTemperature({ temperature, error }) {
    if (error) this.#temperature.fail(this.#form.sayError(error));
    else this.#temperature.show(temperature);
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

/** Show a message about a case file; `kind` is "error", "warning" or "note". */
function sayOfFile(text, kind = "note") {
  at("file-said").textContent = text;
  at("file-said").dataset.kind = kind;
}

function say(text) {
  at("said").textContent = text;
}

/** Number of warnings for the brief answer, empty without warnings. */
function countText(count) {
  if (count === 0) return "";
  return `  ·  ${count}\u00a0${count === 1 ? "warning" : "warnings"}`;
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

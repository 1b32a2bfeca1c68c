/** The form: rolling body, counterbody, motion, and messages of the solver at the fields. */

import { withBody } from "./body_change.js";
import { coreRadius, groundsOf, isLine, outerRadius, quantity, sizedBy } from "./case.js";
import { el } from "./dom.js";
import { DRIVES, scaleOf } from "./drives.js";
import { choiceField, numberField } from "./field.js";
import { layerRow, layerRows } from "./layer_rows.js";
import { errorText } from "./messages.js";
import { OBSTACLES } from "./over_ground.js";
import { BODIES, CLASSES } from "./schema.js";
import { numberText, quantityText } from "./units.js";

/** Fields that are marked by warnings, by the kind of the warning. */
const WARNED = { contact_at_side: "width", edge_pressure: "sides", tight_crown: "crown_radius" };

const INSIDES = { rigid: "rigid core", hollow: "hollow", solid: "solid, no core" };

/** Text in place of the fields of the temperature, where the solver does not compute it. */
const WITHOUT_TEMPERATURE = "The installed page, viscoroll app, also computes the temperature of the layers.";

/** Label and slider ranges of load and penetration, for total values and per length (`line`), in SI units. */
const PRESSED = {
  load: { label: "load", range: [0.1, 1e5], line: [10, 1e6], lineLabel: "load per length" },
  penetration: { label: "penetration", range: [1e-6, 1e-2], line: [1e-6, 1e-2], lineLabel: "penetration" },
};
const PRESSED_BY = { load: "a load", penetration: "a fixed gap: given penetration" };

export class Form {
  #root;
  #hasTemperature;
  #change;
  #fields = [];
  #state;
  #modelIsOpen = false;
  #changed = []; // numbers that changed with the body, in words

  /**
   * @param {HTMLElement} root element to fill
   * @param {boolean} hasTemperature whether the solver computes temperatures
   * @param {(state) => void} change called with each new state
   */
  constructor(root, hasTemperature, change) {
    this.#root = root;
    this.#hasTemperature = hasTemperature;
    this.#change = change;
    root.addEventListener("submit", (event) => event.preventDefault());
  }

  /** Show the fields of a state that does not come from the form. */
  show(state) {
    this.#changed = [];
    this.#draw(state);
  }

  /** Draw the fields of a state; the focus stays at its position. */
  #draw(state) {
    const position = this.#controls().indexOf(document.activeElement);
    this.#state = state;
    this.#fields = [];
    this.#root.replaceChildren(
      this.#motion(),
      this.#size(),
      this.#layers(),
      this.#ground(),
      this.#friction(),
      this.#obstacle(),
      this.#hasTemperature ? this.#temperature() : el("p", { class: "note" }, WITHOUT_TEMPERATURE),
      this.#model(),
    );
    if (position >= 0) this.#controls()[position]?.focus();
  }

  /** Show an error at the field that caused it, if there is one; return the text to show with the results. */
  sayError(error) {
    const field = error.parameter && this.#field(error.parameter);
    const text = errorText(error, field);
    field?.say(text, "error");
    field?.root.closest("details")?.setAttribute("open", "");
    return `No result: ${text}`;
  }

  /** Mark the fields of warnings; their texts appear beside the answer. */
  markWarnings(warnings) {
    for (const { kind } of warnings) {
      const name = kind === "large_strain" ? this.#state.pressed : WARNED[kind];
      (name && this.#field(name))?.say("", "warning");
    }
  }

  /** Remove all messages. */
  sayNothing() {
    for (const field of this.#fields) field.say("", "");
  }

  #controls() {
    return [...this.#root.querySelectorAll("input, select, button, summary")];
  }

  /** The field for the parameter of a message: the one with the same path, or else with the same last name. */
  #field(parameter) {
    const path = parameter
      .replace(/^(\w+)\./, (whole, table) => {
        if (table in BODIES || table === "rolling" || table === "numerics") return "";
        return table in CLASSES ? "on." : whole;
      })
      .replace(/^on\.base\./, "on.layers[0].")
      .replace(/shear_modulus$/, "type")
      .replace(/(shear_modulus|drive)\./g, "")
      .replace(/^layer\./, "layers[0].");
    const last = (name) => name.split(".").at(-1);
    return (
      this.#fields.find((field) => field.parameter === path) ??
      this.#fields.find((field) => last(field.parameter) === last(path))
    );
  }

  /** Change the state; `redraw` if the new state has other fields. */
  #set(part, redraw = false) {
    this.#state = { ...this.#state, ...part };
    if (redraw) this.#draw(this.#state);
    else for (const field of this.#fields) field.refresh();
    this.#change(this.#state);
  }

  #add(field) {
    this.#fields.push(field);
    return field.root;
  }

  #number(name, label, more) {
    return this.#add(
      numberField({
        label,
        parameter: name,
        value: this.#state[name],
        quantity: quantity(name, this.#state),
        radius: () => outerRadius(this.#state),
        change: (value) => this.#set({ [name]: value }),
        ...more,
      }),
    );
  }

  #choice(name, label, options, more) {
    return this.#add(
      choiceField({
        label,
        parameter: name,
        value: () => String(this.#state[name]),
        options,
        change: (value) => this.#set({ [name]: value }, true),
        ...more,
      }),
    );
  }

  /** A field that is visible while a condition holds. It is hidden, not removed, so that inputs keep their focus. */
  #shownWhile(condition, root) {
    const refresh = () => (root.hidden = !condition());
    refresh();
    this.#fields.push({ root, parameter: "", say: () => {}, refresh });
    return root;
  }

  /** The numbers that change most often come first, so that they are visible without scrolling. */
  #motion() {
    const { pressed } = this.#state;
    const line = isLine(this.#state);
    const { label, lineLabel, range, line: rangeOfLine } = PRESSED[pressed];
    const nouns = Object.fromEntries(Object.entries(BODIES).map(([name, { noun }]) => [name, noun]));
    return group(
      "Body, load and speed",
      this.#choice("body", "body", nouns, { change: (body) => this.#setBody(body) }),
      ...this.#changed.map((text) => el("p", { class: "changed", role: "status" }, text)),
      this.#choice("pressed", "pressed by", PRESSED_BY),
      this.#number(pressed, line ? lineLabel : label, { range: line ? rangeOfLine : range }),
      this.#number("speed", "speed", { parameter: "angular_speed", range: [1e-2, 1e3] }),
    );
  }

  #setBody(body) {
    const { state, changed } = withBody(this.#state, body);
    this.#changed = changed;
    this.#set(state, true);
  }

  #size() {
    const { body, given, inner_boundary: inside } = this.#state;
    const solid = body === "ball" && inside === "solid";
    const size = [
      this.#choice(
        "given",
        "size given by",
        { core_radius: "radius of the core", outer_diameter: "outer diameter" },
        { change: (by) => this.#set(sizedBy(this.#state, by), true) },
      ),
      this.#number("size", given === "core_radius" ? "core radius" : "outer diameter", {
        parameter: "core_radius",
        derived: given !== "core_radius",
        range: [2e-3, 0.5],
      }),
    ];
    return group(
      `Size of the ${BODIES[body].noun}`,
      body === "ball"
        ? this.#choice("inner_boundary", "inside", INSIDES, { change: (chosen) => this.#setInside(chosen) })
        : null,
      ...(solid ? [] : size),
      this.#otherSize(),
      ...(body === "wheel" ? this.#wheel() : []),
    );
  }

  /** Set the inside of a ball. Without a rigid core its layers are thick, and the exact curvature is used. */
  #setInside(inside) {
    this.#set({ inner_boundary: inside, curvature: inside === "rigid" ? "sphere" : "exact" }, true);
  }

  /** Text with the size that follows from the given size. */
  #otherSize() {
    const text = el("p", { class: "note" });
    const refresh = () => {
      const { given, body, inner_boundary: inside } = this.#state;
      const byCore = given === "core_radius" || (body === "ball" && inside === "solid");
      text.textContent = byCore
        ? `outer diameter ${quantityText(2 * outerRadius(this.#state), "m", null, 6)}`
        : `core radius ${quantityText(coreRadius(this.#state), "m", null, 6)}`;
    };
    refresh();
    return this.#add({ root: text, parameter: "outer_radius", say: () => {}, refresh });
  }

  #wheel() {
    const hubs = { straight: "straight", crowned: "crowned like the tread" };
    return [
      this.#number("width", "width of the tread", { range: [2e-3, 0.2] }),
      this.#number("crown_radius", "crown radius", {
        range: [2e-3, 2],
        empty: "flat",
        note: "Radius of the profile across the path, at least half of the width; empty: flat.",
      }),
      this.#shownWhile(() => this.#state.crown_radius !== null, this.#choice("hub", "hub", hubs)),
      this.#choice("sides", "sides", { free: "free faces", unbounded: "unbounded tread (no faces)" }),
    ];
  }

  #layers() {
    return group("Layers, from the core outwards", ...layerRows(this.#rowsOf("layers", "")));
  }

  #rowsOf(list, prefix) {
    const change = (layers, redraw) => this.#set({ [list]: layers }, redraw);
    return { layers: () => this.#state[list], prefix, add: (field) => this.#add(field), change };
  }

  #ground() {
    const fields = {
      rigid: () => [],
      plane: () => layerRows(this.#rowsOf("ground", "on.")),
      half_space: () => [layerRow({ ...this.#rowsOf("ground", "on."), index: 0, halfSpace: true })],
      groove: () => [
        this.#number("radius", "radius across the path", {
          parameter: "on.radius",
          range: [-0.5, 0.5],
          linear: true,
          note: "Positive for a groove, negative for a rail.",
        }),
      ],
      drum: () => [this.#number("radius", "radius of the drum", { parameter: "on.core_radius", range: [5e-3, 2] })],
    };
    return group("Counterbody", this.#choice("on", "counterbody", groundsOf(this.#state.body)), ...fields[this.#state.on]());
  }

  #friction() {
    const { drive } = this.#state;
    const rubs = () => this.#state.friction > 0;
    const offers = Object.fromEntries(Object.entries(DRIVES).map(([name, { offer }]) => [name, offer]));
    return group(
      "Friction and drive",
      this.#number("friction", "friction coefficient", { range: [0, 1], linear: true, step: 0.01 }),
      this.#shownWhile(rubs, this.#choice("drive", "driven by", offers)),
      this.#shownWhile(
        rubs,
        this.#number(drive, DRIVES[drive].label, { range: scaleOf(drive, isLine(this.#state)).range, linear: true }),
      ),
    );
  }

  #obstacle() {
    const { obstacle } = this.#state;
    const found = OBSTACLES[obstacle];
    const labels = Object.fromEntries(Object.entries(OBSTACLES).map(([type, { label }]) => [type, label]));
    const axles = { load: "only the load", mass: "load and mass of the axle" };
    const isHeavy = () => this.#state.axle === "mass";
    const ofObstacle = (name, key, range) => this.#number(name, key, { parameter: `ground.${key}`, range });
    const held = () => [
      this.#choice("axle", "held by", axles),
      this.#shownWhile(
        isHeavy,
        this.#number("axle_mass", `mass [${isLine(this.#state) ? "kg/m" : "kg"}]`, {
          parameter: "axle.mass",
          range: [1e-2, 1e3],
        }),
      ),
    ];
    return group(
      "Over ground",
      this.#choice("obstacle", "obstacle", { none: "none", ...labels }),
      found ? ofObstacle("obstacle_size", found.size, [1e-5, 1e-2]) : null,
      found?.length ? ofObstacle("obstacle_length", found.length, [1e-3, 0.2]) : null,
      ...(found && this.#state.pressed === "load" ? held() : []),
    );
  }

  #temperature() {
    const { core } = this.#state;
    const isComputed = () => this.#state.temperature === "on";
    const cores = { insulated: "insulated", isothermal: "as warm as the surroundings" };
    if (!(core in cores)) cores[core] = `solid, ${core} W/(m K)`; // from a case file
    const fields = [
      this.#number("convection", "convection [W/(m² K)]", { range: [1, 200] }),
      this.#number("ambient", "surroundings", { range: [253.15, 333.15], linear: true, step: 1 }),
      this.#number("conductivity", "conductivity [W/(m K)]", { range: [0.05, 1] }),
      this.#choice("core", "core or hub", cores),
    ];
    return group(
      "Temperature",
      this.#choice("temperature", "temperature", { off: "not computed", on: "computed" }),
      ...fields.map((field) => this.#shownWhile(isComputed, field)),
    );
  }

  #model() {
    const compliances = { radial: "radial", vertical: "vertical" };
    const curvatures = {
      sphere: "thin layers",
      exact: "exact: thick layers, solid balls",
      paper: "as printed in the paper",
    };
    const own = this.#state.accuracy; // a case file may give any accuracy
    const accuracies = { [own]: `${numberText(100 * own)} %`, 0.03: "3 %", 0.01: "1 %", 0.003: "0.3 %" };
    return el(
      "details",
      { class: "group", open: this.#modelIsOpen, ontoggle: (event) => (this.#modelIsOpen = event.target.open) },
      el("summary", {}, "Model and accuracy"),
      this.#choice("compliance", "compliance", compliances),
      this.#state.body === "ball" ? this.#choice("curvature", "curvature", curvatures) : "",
      this.#choice("accuracy", "accuracy", accuracies, {
        change: (value) => this.#set({ accuracy: Number(value) }),
      }),
    );
  }
}

function group(title, ...children) {
  return el("fieldset", { class: "group" }, el("legend", {}, title), ...children.filter(Boolean));
}

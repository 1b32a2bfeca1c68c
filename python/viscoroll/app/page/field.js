/** One line of the form: a label, what is typed, its unit, the SI value beside, a slider, and what is wrong with it. */

import { el } from "./dom.js";
import { SI, UNITS, fromSI, shown, tidy, toSI, unitNamed } from "./units.js";

const STEPS = 300; // of a slider: some half a percent of a decade's value each, over three decades

/** How long nothing more is typed before a number is read [ms]: 7 on the way to 78 is none to be solved. */
const PAUSE = 300;

/** 1,000 is one to some, and a thousand to others: it is asked for. */
const THOUSANDS = /^[-+]?[1-9]\d{0,2},\d{3}(?!\d)/;

let count = 0;

/**
 * A number with its unit.
 * @param {object} of
 * @param {string} of.label
 * @param {string} of.parameter what messages call it
 * @param {[number, string]|number|null} of.value as it is typed; null: left empty
 * @param {string} [of.quantity] without it the number has no unit, and is no pair
 * @param {[number, number]} of.range of the slider, in SI units; what is typed may lie outside
 * @param {boolean} [of.linear] whether the slider is; otherwise it is logarithmic
 * @param {number} [of.step] of the slider, in the unit that is shown
 * @param {string} [of.empty] what an empty field means, where it may be empty
 * @param {() => number} [of.radius] outer radius, for speeds of the center
 * @param {string} [of.note] a few words below
 * @param {(value) => void} of.change is given what is typed
 */
export function numberField({
  label,
  parameter,
  value,
  quantity,
  range,
  linear,
  step,
  empty,
  radius = () => 1,
  note,
  change,
}) {
  const id = `field-${(count += 1)}`;
  const pair = (typed) => (quantity ? typed : [typed, ""]);
  const whole = (number, unit) => (quantity ? [number, unit] : number);
  const si = ([number, unit]) => (quantity ? toSI([number, unit], quantity, radius()) : number);
  const back = (number, unit) => (quantity ? fromSI(number, unit, quantity, radius())[0] : tidy(number));
  const units = quantity ? Object.keys(UNITS[quantity]) : [];
  let misread = false;
  let pause = null; // before what was typed is read
  let [number, unit] = value === null ? [null, units[0] ?? ""] : pair(value);

  const input = el("input", {
    id,
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    placeholder: empty,
    oninput: typed,
    onchange: left, // or Enter is pressed
  });
  const select =
    units.length > 1
      ? el(
          "select",
          { "aria-label": `unit of ${label}`, onchange: converted },
          ...units.map((name) => el("option", {}, name)),
        )
      : el("span", { class: "unit" }, units[0] ?? "");
  const slider = el("input", { type: "range", min: 0, max: STEPS, "aria-label": `${label}, slider`, oninput: slid });
  const beside = el("output", { class: "si", for: id });
  const problem = el("p", { class: "problem", role: "alert" });

  function show({ text = true } = {}) {
    if (text) input.value = number === null ? "" : String(number);
    if (units.length > 1) select.value = unit;
    slider.disabled = number === null;
    const shownSI = number === null ? null : si([number, unit]);
    beside.textContent =
      shownSI === null || !quantity || SI[quantity] === unit ? "" : `= ${shown(shownSI, 5)} ${SI[quantity]}`;
    if (shownSI !== null) slider.value = position(shownSI);
    slider.setAttribute("aria-valuetext", `${number} ${unit}`.trim());
  }
  function position(x) {
    const [low, high] = range;
    const share = linear ? (x - low) / (high - low) : Math.log(Math.max(x, 1e-300) / low) / Math.log(high / low);
    return Math.round(STEPS * Math.min(Math.max(share, 0), 1));
  }
  function typed() {
    clearTimeout(pause);
    say("", "");
    pause = setTimeout(read, PAUSE);
  }
  function read() {
    if (pause === null) return;
    clearTimeout(pause);
    pause = null;
    const text = input.value.trim().replace("−", "-").replace(THOUSANDS, "$&?").replace(",", ".");
    const found = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*)$/i.exec(text);
    const named = found && quantity && unitNamed(found[2], quantity);
    if (text === "" && empty !== undefined) number = null;
    else if (found && (found[2] === "" || named)) {
      number = Number(found[1]);
      if (named) unit = named;
    } else {
      const those = units.length ? `, maybe with one of the units ${units.join(", ")}` : "";
      say(`${label} must be a number, as 1000 or 0.5${those}`, "error");
      misread = true;
      return;
    }
    misread = false;
    show({ text: false });
    change(number === null ? null : whole(number, unit));
  }
  function left() {
    read();
    if (!misread) show(); // with what was typed as a unit at its place
  }
  function converted() {
    const kept = number === null ? null : si([number, unit]);
    unit = select.value;
    misread = false;
    say("", "");
    if (kept !== null) number = Number(back(kept, unit).toPrecision(6));
    show();
    if (number !== null) change(whole(number, unit));
  }
  function slid() {
    const [low, high] = range;
    const share = slider.value / STEPS;
    const x = back(linear ? low + share * (high - low) : low * (high / low) ** share, unit);
    number = step ? tidy(Math.round(x / step) * step) : Number(x.toPrecision(3));
    misread = false;
    say("", "");
    show();
    change(whole(number, unit));
  }
  function say(text, kind) {
    problem.textContent = text;
    root.dataset.problem = kind;
    input.setAttribute("aria-invalid", kind === "error");
  }

  const root = el(
    "div",
    { class: "field" },
    el("label", { for: id }, label),
    el("span", { class: "typed" }, input, select),
    slider,
    beside,
    note ? el("p", { class: "note" }, note) : null,
    problem,
  );
  show();
  const sayOfRead = (text, kind) => misread || say(text, kind); // what the solver says is of another number
  return { root, parameter, say: sayOfRead, refresh: () => show({ text: false }) };
}

/**
 * A choice of a few.
 * @param {() => string} of.value which it is
 * @param {() => string} [of.note] a few words below
 */
export function choiceField({ label, parameter, value, options, note = () => "", change }) {
  const id = `field-${(count += 1)}`;
  const select = el(
    "select",
    { id, onchange: () => change(select.value) },
    ...Object.entries(options).map(([name, text]) => el("option", { value: name }, text)),
  );
  const below = el("p", { class: "note" });
  const problem = el("p", { class: "problem", role: "alert" });
  const root = el("div", { class: "field choice" }, el("label", { for: id }, label), select, below, problem);
  const say = (text, kind) => {
    problem.textContent = text;
    root.dataset.problem = kind;
  };
  const refresh = () => {
    select.value = value();
    below.textContent = note();
  };
  refresh();
  return { root, parameter, say, refresh };
}

/** One row of the form: label, input, unit, SI value, slider, and error message. */

import { el } from "./dom.js";
import { UNITS } from "./unit_table.js";
import { SI, fromSI, numberText, tidy, toSI, unitNamed } from "./units.js";

const STEPS = 300; // number of steps of a slider: over three decades, a step changes the number by about 2 %

/** Largest number of digits that a user types, and number of digits shown of longer numbers, which are converted. */
const TYPED = 8;
const SHOWN = 5;

/** Pause in typing after which a number is read [ms], so that the first digit of 78 is not solved as 7. */
const PAUSE = 300;

/** Pattern of ambiguous numbers: 1,000 means 1 or 1000, so that it gives an error message. */
const THOUSANDS = /^[-+]?[1-9]\d{0,2},\d{3}(?!\d)/;

let count = 0;

/** Text of a number in its field: as typed, or shorter if a conversion gave the number. */
function fieldText(number) {
  return String(Number(number.toPrecision(TYPED)) === number ? number : Number(number.toPrecision(SHOWN)));
}

/**
 * A field for a number with its unit.
 * @param {object} of
 * @param {string} of.label
 * @param {string} of.parameter name of the parameter in messages
 * @param {boolean} [of.derived] whether the parameter follows from the number of the field, and is not this number
 * @param {[number, string]|number|null} of.value number as the user types it; null: empty
 * @param {string} [of.quantity] without it, the value is a number without unit, not a pair
 * @param {[number, number]} of.range range of the slider, in SI units; typed numbers may be outside of it
 * @param {boolean} [of.linear] whether the slider is linear; otherwise it is logarithmic
 * @param {number} [of.step] step of the slider from the lower end of its range, in the selected unit
 * @param {string} [of.empty] meaning of an empty field, if it may be empty
 * @param {() => number} [of.radius] outer radius [m], for speeds of the center
 * @param {string} [of.note] note below the field
 * @param {(value) => void} of.change called with the new value
 */
export function numberField({
  label,
  parameter,
  derived = false,
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
  let pause = null; // timer until the typed text is read
  let [number, unit] = value === null ? [null, units[0] ?? ""] : pair(value);

  const input = el("input", {
    id,
    type: "text",
    inputmode: "decimal",
    autocomplete: "off",
    placeholder: empty,
    oninput: typed,
    onchange: left, // also after Enter
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
    if (text) input.value = number === null ? "" : fieldText(number);
    if (units.length > 1) select.value = unit;
    slider.disabled = number === null;
    const shownSI = number === null ? null : si([number, unit]);
    beside.textContent =
      shownSI === null || !quantity || SI[quantity] === unit ? "" : `= ${numberText(shownSI, 5)} ${SI[quantity]}`;
    if (shownSI !== null) slider.value = position(shownSI);
    slider.setAttribute("aria-valuetext", `${number} ${unit}`.trim());
  }
  function position(x) {
    const [low, high] = range;
    const fraction = linear ? (x - low) / (high - low) : Math.log(Math.max(x, 1e-300) / low) / Math.log(high / low);
    return Math.round(STEPS * Math.min(Math.max(fraction, 0), 1));
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
      const those = units.length ? `, optionally with a unit (${units.join(", ")})` : "";
      say(`${label} must be a number such as 1000 or 0.5${those}`, "error");
      misread = true;
      return;
    }
    misread = false;
    show({ text: false });
    change(number === null ? null : whole(number, unit));
  }
  function left() {
    read();
    if (!misread) show(); // moves a typed unit to the list of units
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
    const fraction = slider.value / STEPS;
    const x = back(linear ? low + fraction * (high - low) : low * (high / low) ** fraction, unit);
    const first = back(low, unit);
    number = step ? tidy(first + Math.round((x - first) / step) * step) : Number(x.toPrecision(3));
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
  const sayOfRead = (text, kind) => misread || say(text, kind); // messages of the solver concern an earlier number
  const written = (value, name) => `${numberText(value, 6)} ${name}`.trim();
  return {
    root,
    label,
    parameter,
    derived,
    siUnit: SI[quantity],
    say: sayOfRead,
    refresh: () => show({ text: false }),
    typed: () => (number === null ? (empty ?? "") : written(number, unit)),
    inUnit: (value) => written(Number(back(value, unit)), unit),
  };
}

/**
 * A field for a choice from a list.
 * @param {() => string} of.value returns the current choice
 * @param {() => string} [of.note] returns the note below the field
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
  return { root, label, parameter, derived: true, say, refresh };
}

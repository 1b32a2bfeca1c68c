/** Change of the rolling body: the state keeps its numbers, or a text says which of them changed. */

import { coreRadius, groundsOf, isLine, sizedBy } from "./case.js";
import { DRIVES, scaleOf } from "./drives.js";
import { BODIES } from "./schema.js";
import { fromSI, numberText, quantityText, tidy, toSI } from "./units.js";

/** Significant digits of a total value. It is a product, and fewer digits than those of a quotient undo a division. */
const DIGITS = 11;

/**
 * The same state with another body. The outer diameter gives the size of wheels and rollers, as in catalogs. Between
 * total values and values per length, load and drive are converted with the width of the tread.
 * @returns {{state: object, changed: string[]}} the state, and sentences about the numbers that changed
 */
export function withBody(before, body) {
  if (body === before.body) return { state: before, changed: [] };
  const { noun } = BODIES[body];
  const changed = [];
  let state = { ...before, body };
  if (before.body === "ball") {
    if (before.inner_boundary !== "rigid") {
      state = { ...state, inner_boundary: "rigid", curvature: "sphere" };
      changed.push(`A ${noun} has a rigid core, here with a radius of ${quantityText(coreRadius(state), "m")}.`);
    }
    state = sizedBy(state, "outer_diameter");
  }
  if (!(state.on in groundsOf(body))) {
    const { [state.on]: old } = groundsOf(before.body);
    state.on = "rigid";
    changed.push(`The counterbody is now a ${groundsOf(body).rigid}: the page has no ${noun} on a ${old}.`);
  }
  if (isLine(state) !== isLine(before)) convert(before, state, changed);
  return { state, changed };
}

/** Convert load and drives, and describe those that the form shows. */
function convert(before, state, changed) {
  const line = isLine(state);
  const width = toSI(state.width, "length");
  const scales = {
    load: { total: { quantity: "force", unit: "N" }, line: { quantity: "line_force", unit: "N/mm" } },
    ...Object.fromEntries(
      Object.keys(DRIVES)
        .filter((name) => name !== "creepage") // a ratio
        .map((name) => [name, { total: scaleOf(name, false), line: scaleOf(name, true) }]),
    ),
  };
  for (const [name, { total, line: perLength }] of Object.entries(scales)) {
    const [from, to] = line ? [total, perLength] : [perLength, total];
    const old = toSI(before[name], from.quantity);
    const value = line ? tidy(old / width) : Number((old * width).toPrecision(DIGITS));
    state[name] = fromSI(value, to.unit, to.quantity);
    const isDriven = state.friction > 0 && state.drive === name && value !== 0;
    const isShown = name === "load" ? state.pressed === name : isDriven;
    if (isShown) changed.push(changeText(name, before[name], state[name], state.width));
  }
}

function changeText(name, ...quantities) {
  const [old, now, width] = quantities.map(([value, unit]) => `${numberText(value)} ${unit}`);
  return `The ${name} of ${old} is now ${now}, for a width of ${width}.`;
}

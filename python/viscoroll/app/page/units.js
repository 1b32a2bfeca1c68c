/** Units for input and display, and conversion to SI units. */

import { ALIASES, CENTER_SPEEDS, DISPLAY_UNITS, OFFSETS, PER_LENGTH, UNITS } from "./unit_table.js";

/** SI unit of each quantity, as in messages of the solver; empty if it has none. */
export const SI = Object.fromEntries(
  Object.entries(UNITS).map(([quantity, units]) => [
    quantity,
    Object.keys(units).find((unit) => units[unit] === 1 && !(unit in OFFSETS)) ?? "",
  ]),
);

/** The unit of a quantity that a text names, regardless of case; undefined if there is none. */
export function unitNamed(text, quantity) {
  const name = text.toLowerCase();
  const wanted = (ALIASES[name] ?? name).toLowerCase();
  return Object.keys(UNITS[quantity]).find((unit) => unit.toLowerCase() === wanted);
}

/**
 * SI value of a number with a unit, without round-off in the last digits: 3 mm are 0.003 m.
 * @param {[number, string]} typed number and unit
 * @param {string} quantity
 * @param {number} [radius] outer radius [m], for speeds of the center
 */
export function toSI([value, unit], quantity, radius) {
  return tidy(value * factor(unit, quantity, radius) + (OFFSETS[unit] ?? 0));
}

/** Number and unit for an SI value. */
export function fromSI(value, unit, quantity, radius) {
  return [tidy((value - (OFFSETS[unit] ?? 0)) / factor(unit, quantity, radius)), unit];
}

function factor(unit, quantity, radius) {
  return unit in CENTER_SPEEDS && quantity === "speed" ? CENTER_SPEEDS[unit] / radius : UNITS[quantity][unit];
}

/** A number without round-off in its last digits. */
export function tidy(value) {
  return Number(value.toPrecision(13));
}

/** Text of a number, with at most `digits` significant digits. */
export function numberText(value, digits = 4) {
  if (value === null || value === undefined) return "–";
  const rounded = Number(value.toPrecision(digits));
  const size = Math.abs(rounded);
  if (size !== 0 && (size >= 1e6 || size < 1e-4)) {
    const [mantissa, exponent] = rounded.toExponential().split("e");
    return `${mantissa}·10${[...String(Number(exponent))].map((c) => SUPERSCRIPTS[c]).join("")}`;
  }
  return String(rounded).replace("-", "−");
}

const SUPERSCRIPTS = Object.fromEntries([..."-0123456789"].map((c, i) => [c, [..."⁻⁰¹²³⁴⁵⁶⁷⁸⁹"][i]]));

/**
 * Suitable unit for a result, and the SI value of this unit, as `suitable_unit` in Python.
 * @returns {[string, number]}
 */
export function suitableUnit(value, unit) {
  if (unit === "1") return ["", 1];
  const displayed = Object.entries(DISPLAY_UNITS[unit] ?? {});
  const size = Math.abs(value ?? 0);
  if (size === 0 || !displayed.length) return [displayed.find(([, [scale]]) => scale === 1)?.[0] ?? unit, 1];
  const [name, [scale]] = displayed.find(([, [, least]]) => size >= least) ?? displayed.at(-1);
  return [name, scale];
}

/** Most digits of a value with an error, and leading digits of an error below which a second digit is displayed. */
const MOST_DIGITS = 6;
const TWO_DIGITS = 3;

/** A number with as many digits as its error supports, and the error, as `with_error` in Python. */
export function withError(value, error, digits = 4) {
  if (error === null || value === 0 || !Number.isFinite(value) || !Number.isFinite(error))
    return numberText(value, digits);
  const size = Math.abs(error);
  const finest = Math.floor(Math.log10(Math.abs(value))) - MOST_DIGITS + 1;
  if (size < 0.5 * 10 ** finest) return numberText(value, MOST_DIGITS);
  const leading = Math.floor(Math.log10(size));
  const place = Math.max(leading - (size < TWO_DIGITS * 10 ** leading ? 1 : 0), finest);
  const one = 10 ** Math.max(place, 0);
  const text = (number) => (Math.round(number / one) * one).toFixed(0);
  const texts = [value, size].map((number) => (place > 0 ? text(number) : number.toFixed(-place)));
  return texts.join(" ± ").replace("-", "−");
}

/** Text of a result with a suitable unit, and its error if its relative error is given. */
export function quantityText(value, unit, relativeError = null, digits = 4) {
  if (value === null || value === undefined) return "undetermined";
  const [name, scale] = suitableUnit(value, unit);
  const error = relativeError === null ? null : (relativeError * value) / scale;
  return `${withError(value / scale, error, digits)} ${name}`.trim();
}

/** Text of a ratio in percent. */
export function percentText(ratio, digits = 3) {
  return `${numberText(100 * ratio, digits)} %`;
}

/** The unit of a scalar result; `unit` is its unit in point contact. */
export function resultUnit(unit, lineContact) {
  return (lineContact && PER_LENGTH[unit]) || unit;
}

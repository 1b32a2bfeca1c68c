/** Units for input and display, and conversion to SI units. */

import { ALIASES, CENTER_SPEEDS, OFFSETS, UNITS } from "./unit_table.js";

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

const PREFIXES = [
  ["G", 1e9],
  ["M", 1e6],
  ["k", 1e3],
  ["", 1],
  ["m", 1e-3],
  ["µ", 1e-6],
  ["n", 1e-9],
];

/** Units that take prefixes, and their usual prefixes (no km). */
const PREFIXED = { m: "mµn", N: "kmµ", "N m": "kmµ", "N m/m": "kmµ", W: "kmµ", Pa: "GMk", "N/m": "kM", "W/m": "kmµ", "m/s": "mµ" };

/**
 * Suitable unit for a result, and the SI value of this unit.
 * @returns {[string, number]}
 */
export function suitableUnit(value, unit) {
  if (unit === "1") return ["", 1];
  if (unit === "m^2") return ["mm²", 1e-6];
  const allowed = PREFIXED[unit];
  const size = Math.abs(value ?? 0);
  if (!allowed || size === 0) return [unit, 1];
  if (unit === "Pa" && size >= 1e5 && size < 1e9) return ["MPa", 1e6]; // 0.3 MPa, not 300 kPa, as in the input of moduli
  if (unit === "m" && size >= 1e-5) return size < 1 ? ["mm", 1e-3] : ["m", 1]; // as in the input of lengths
  const fitting = PREFIXES.filter(([prefix]) => prefix === "" || allowed.includes(prefix));
  const [prefix, scale] = fitting.find(([, scale]) => size >= scale) ?? fitting.at(-1);
  return [prefix + unit, scale];
}

/** Text of a result with a suitable unit. */
export function quantityText(value, unit, digits = 4) {
  if (value === null || value === undefined) return "–";
  const [name, scale] = suitableUnit(value, unit);
  return `${numberText(value / scale, digits)} ${name}`.trim();
}

/** Units of results in line contact, by their units in point contact: in line contact these results are per length. */
const PER_LENGTH = { "N m": "N m/m", N: "N/m", W: "W/m", "m^2": "m" };

/** The unit of a scalar result; `unit` is its unit in point contact. */
export function resultUnit(unit, lineContact) {
  return (lineContact && PER_LENGTH[unit]) || unit;
}

/** Units for input and display, and conversion to SI units. */

const TURN = 2 * Math.PI;

/** SI values of the units, by quantity; the first unit is the default. For speeds (null), see `factor`. */
export const UNITS = {
  length: { mm: 1e-3, cm: 1e-2, m: 1, in: 0.0254 },
  modulus: { MPa: 1e6, kPa: 1e3, GPa: 1e9, Pa: 1, psi: 6894.757293168 },
  force: { N: 1, kN: 1e3, kgf: 9.80665, lbf: 4.4482216152605 },
  line_force: { "N/mm": 1e3, "N/m": 1, "kN/m": 1e3, "lbf/in": 175.12683524647636 },
  torque: { "N m": 1, "mN m": 1e-3, "lbf in": 0.1129848290276167 },
  line_torque: { "N m/m": 1, "N mm/mm": 1 },
  power: { W: 1, kW: 1e3, mW: 1e-3, hp: 745.69987158227022 },
  line_power: { "W/m": 1, "kW/m": 1e3 },
  speed: { "km/h": null, "m/s": null, mph: null, rpm: TURN / 60, "rad/s": 1 },
  time: { s: 1, ms: 1e-3, µs: 1e-6 },
  frequency: { "rad/s": 1, Hz: TURN },
  density: { "kg/m³": 1, "g/cm³": 1e3 },
  temperature: { "°C": 1, K: 1 },
  percent: { "%": 1e-2 },
};

/** SI value of 0 in a unit, for units whose zero is not that of the SI unit. */
const OFFSETS = { "°C": 273.15 };

/** SI unit of each quantity, as in messages of the solver; empty if it has none. */
export const SI = Object.fromEntries(
  Object.entries(UNITS).map(([quantity, units]) => [
    quantity,
    Object.keys(units).find((unit) => units[unit] === 1 && !(unit in OFFSETS)) ?? "",
  ]),
);

/** Other spellings of units that users may type. */
const ALIASES = {
  kg: "kgf",
  lb: "lbf",
  inch: "in",
  '"': "in",
  nm: "N m",
  mnm: "mN m",
  "kg/m3": "kg/m³",
  "g/cm3": "g/cm³",
  us: "µs",
  kmh: "km/h",
  kph: "km/h",
  c: "°C",
};

/** The unit of a quantity that a text names, regardless of case; undefined if there is none. */
export function unitNamed(text, quantity) {
  const name = text.toLowerCase();
  const wanted = (ALIASES[name] ?? name).toLowerCase();
  return Object.keys(UNITS[quantity]).find((unit) => unit.toLowerCase() === wanted);
}

/** SI values [m/s] of the units for the speed of the center, which is the angular speed times the outer radius. */
const CENTER_SPEEDS = { "km/h": 1 / 3.6, "m/s": 1, mph: 0.44704 };

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

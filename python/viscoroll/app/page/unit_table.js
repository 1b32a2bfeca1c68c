// Written by wasm/make_types.py from python/viscoroll/case/units.txt.

/** SI values of the units, by quantity; the first unit is the default. `CENTER_SPEEDS` has those of null. */
export const UNITS = {
  length: { mm: 0.001, cm: 0.01, m: 1, in: 0.0254 },
  modulus: { MPa: 1000000, kPa: 1000, GPa: 1000000000, Pa: 1, psi: 6894.757293168362 },
  force: { N: 1, kN: 1000, kgf: 9.80665, lbf: 4.4482216152605 },
  line_force: { "N/mm": 1000, "N/m": 1, "kN/m": 1000, "lbf/in": 175.1268352464764 },
  torque: { "N m": 1, "mN m": 0.001, "lbf in": 0.1129848290276167 },
  line_torque: { "N m/m": 1, "N mm/mm": 1 },
  power: { W: 1, kW: 1000, mW: 0.001, hp: 745.6998715822702 },
  line_power: { "W/m": 1, "kW/m": 1000 },
  speed: { "km/h": null, "m/s": null, mph: null, rpm: 0.10471975511965978, "rad/s": 1 },
  time: { s: 1, ms: 0.001, µs: 1e-6 },
  frequency: { "rad/s": 1, Hz: 6.283185307179586 },
  density: { "kg/m³": 1, "g/cm³": 1000 },
  temperature: { "°C": 1, K: 1 },
  percent: { "%": 0.01 },
};

/** SI value of 0 in a unit, for units whose zero is not that of the SI unit. */
export const OFFSETS = {
  "°C": 273.15,
};

/** Other spellings of units that users may type, in lower case. */
export const ALIASES = {
  kg: "kgf",
  lb: "lbf",
  inch: "in",
  "\"": "in",
  nm: "N m",
  mnm: "mN m",
  "kg/m3": "kg/m³",
  "g/cm3": "g/cm³",
  us: "µs",
  kmh: "km/h",
  kph: "km/h",
  c: "°C",
};

/** SI values [m/s] of units for the speed of the center: the angular speed times the outer radius. */
export const CENTER_SPEEDS = {
  "km/h": 0.2777777777777778,
  "m/s": 1,
  mph: 0.44704,
};

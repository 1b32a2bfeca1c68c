// Written by wasm/make_types.py from case/units.txt and _support/units.py in python/viscoroll.

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

/** Units in which results are displayed, by SI unit: SI value, and smallest value displayed in the unit. */
export const DISPLAY_UNITS = {
  N: { kN: [1000, 1000], N: [1, 1], mN: [0.001, 0.0001], µN: [1e-6, 1e-7], nN: [1e-9, 0] },
  "N m": { "kN m": [1000, 1000], "N m": [1, 1], "mN m": [0.001, 0.0001], "µN m": [1e-6, 1e-7], "nN m": [1e-9, 0] },
  "N m/m": { "kN m/m": [1000, 1000], "N m/m": [1, 1], "mN m/m": [0.001, 0.0001], "µN m/m": [1e-6, 1e-7], "nN m/m": [1e-9, 0] },
  W: { kW: [1000, 1000], W: [1, 1], mW: [0.001, 0.0001], µW: [1e-6, 1e-7], nW: [1e-9, 0] },
  "W/m": { "kW/m": [1000, 1000], "W/m": [1, 1], "mW/m": [0.001, 0.0001], "µW/m": [1e-6, 1e-7], "nW/m": [1e-9, 0] },
  J: { kJ: [1000, 1000], J: [1, 1], mJ: [0.001, 0.0001], µJ: [1e-6, 1e-7], nJ: [1e-9, 0] },
  "J/m": { "kJ/m": [1000, 1000], "J/m": [1, 1], "mJ/m": [0.001, 0.0001], "µJ/m": [1e-6, 1e-7], "nJ/m": [1e-9, 0] },
  "N/m": { "kN/m": [1000, 1000], "N/m": [1, 1], "mN/m": [0.001, 0] },
  m: { m: [1, 1], mm: [0.001, 1e-5], µm: [1e-6, 1e-8], nm: [1e-9, 0] },
  "m^2": { "m²": [1, 1], "mm²": [1e-6, 1e-9], "µm²": [1e-12, 0] },
  "m/s": { "m/s": [1, 0.1], "mm/s": [0.001, 0.0001], "µm/s": [1e-6, 0] },
  Pa: { GPa: [1000000000, 1000000000], MPa: [1000000, 100000], kPa: [1000, 1000], Pa: [1, 0] },
  "J/m^3": { "MJ/m³": [1000000, 1000000], "kJ/m³": [1000, 1000], "J/m³": [1, 1], "mJ/m³": [0.001, 0] },
  "Pa s": { "MPa s": [1000000, 1000000], "kPa s": [1000, 1000], "Pa s": [1, 1], "mPa s": [0.001, 0] },
  s: { s: [1, 1], ms: [0.001, 0.001], µs: [1e-6, 1e-6], ns: [1e-9, 0] },
};

/** Units in line contact of results that are per length there. */
export const PER_LENGTH = {
  "N m": "N m/m",
  N: "N/m",
  "N/m": "N/m^2",
  "N s/m": "N s/m^2",
  W: "W/m",
  J: "J/m",
  kg: "kg/m",
  "m^2": "m",
};

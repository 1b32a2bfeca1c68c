/** Reader of case files for the site; `viscoroll app` reads them in Python (app/case_text.py). */

import { bodyOf, stateOf } from "./case.js";
import { hasCase } from "./link.js";
import { BODIES, KEY_UNITS, OTHER_TABLES } from "./schema.js";
import { parseToml } from "./toml.js";
import { CENTER_SPEEDS, UNITS } from "./unit_table.js";
import { SI, resultUnit, tidy, toSI, unitNamed } from "./units.js";

const QUANTITY = /^\s*([-+−]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)\s*(.*?)\s*$/i;

/** Keys of tables; of each group, a case file has exactly one. */
const SIZE = ["core_radius", "outer_diameter"];
const REQUIRED = {
  ball: [],
  cylinder: [SIZE],
  wheel: [SIZE, ["width"]],
  rolling: [
    ["load", "penetration"],
    ["angular_speed", "speed"],
  ],
};

/**
 * The case that the text of a case file describes.
 * @returns {{tables: object, skipped: string[]}|{error: {message: string}}} tables in SI units, and names of the tables
 *   that the page does not support
 */
export function openCase(text) {
  try {
    const document = parseToml(text);
    const skipped = OTHER_TABLES.filter((name) => name in document);
    for (const name of [...skipped, "allow_large"]) delete document[name];
    const body = bodyOf(document);
    if (!body) throw new Error(`one of the tables ${Object.keys(BODIES).join(", ")} must be given`);
    requireKeys(document, body);
    const tables = inSI(document, "", BODIES[body].line);
    for (const table of Object.values(tables)) replaceDiameter(table);
    if (!isCase(tables)) throw new Error("a number is missing, or a table is not as `viscoroll example` prints it");
    return { tables, skipped };
  } catch (error) {
    return { error: { message: error.message } };
  }
}

/** Check that all values of the file are tables, with the keys for which the form has an initial number. */
function requireKeys(document, body) {
  const isTable = (value) => typeof value === "object" && !Array.isArray(value);
  const other = Object.keys(document).find((name) => !isTable(document[name]));
  if (other) throw new Error(`${other} must be a table`);
  for (const table of [body, "rolling"]) {
    for (const keys of REQUIRED[table]) {
      const given = keys.filter((key) => key in (document[table] ?? {}));
      if (given.length !== 1) {
        const one = keys.length > 1 ? "exactly one of " : "";
        throw new Error(`${one}${keys.map((key) => `${table}.${key}`).join(" and ")} must be given`);
      }
    }
  }
}

/** Whether the form has a number for each of its fields. */
function isCase(tables) {
  try {
    return hasCase(stateOf(tables).state);
  } catch {
    return false;
  }
}

/** Tables and lists with numbers in SI units in place of texts with units. */
function inSI(value, path, line) {
  if (Array.isArray(value)) return value.map((one, i) => inSI(one, `${path}[${i}]`, line));
  if (value !== null && typeof value === "object") {
    const inside = (name) => (path ? `${path}.${name}` : name);
    return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, inSI(one, inside(name), line)]));
  }
  if (typeof value === "number" && !Number.isFinite(value)) throw new Error(`${path} must be finite on this page`);
  const key = path.split(".").at(-1).replace(/\[\d+\]$/, "");
  return typeof value === "string" && key in KEY_UNITS && QUANTITY.test(value) ? number(value, key, path, line) : value;
}

function number(text, key, path, line) {
  const [, digits, name] = QUANTITY.exec(text);
  const value = Number(digits.replace("−", "-"));
  const si = resultUnit(KEY_UNITS[key], line);
  if (si === "m/s") {
    const unit = unitNamed(name, "speed");
    if (unit in CENTER_SPEEDS) return tidy(value * CENTER_SPEEDS[unit]);
  } else {
    const quantity = Object.keys(UNITS).find((one) => (SI[one] || "1") === si && unitNamed(name, one) !== undefined);
    const unit = quantity && unitNamed(name, quantity);
    if (unit && !(unit in CENTER_SPEEDS)) return toSI([value, unit], quantity);
  }
  throw new Error(`${path} must be a number [${si}] or have a unit that this page reads, got "${text}"`);
}

/** Give the radius of the core in place of the outer diameter, as the form does. */
function replaceDiameter(table) {
  if (table?.outer_diameter === undefined) return;
  const thickness = (table.layers ?? []).reduce((sum, layer) => sum + layer.thickness, 0);
  table.core_radius = tidy(0.5 * table.outer_diameter - thickness);
  delete table.outer_diameter;
}

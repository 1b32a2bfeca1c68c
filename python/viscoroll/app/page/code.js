/** A case as Python code and as a case file, with exactly the numbers of the page. */

import { bodyOf } from "./case.js";
import { CLASSES, COMMON_MODULI, INTEGERS } from "./schema.js";

/** Classes of types whose class does not have the name of the type. */
const MODULI = {
  softening: "materials.SofteningModulus",
  kraus: "materials.KrausNetwork",
  masing: "materials.MasingNetwork",
  strain_sweep: "materials.StrainSweep",
  generalized_maxwell: "Prony.from_moduli",
};

/** The class of a modulus in the package: "materials.KelvinVoigt" for the type "kelvin_voigt". */
export function classOf(type) {
  const name = type.replace(/(?:^|_)(.)/g, (_, letter) => letter.toUpperCase());
  return MODULI[type] ?? (COMMON_MODULI.includes(name) ? name : `materials.${name}`);
}

/** Python code that solves a case and prints its results. */
export function pythonOf(tables) {
  const { rolling, numerics = {}, thermal, ...bodies } = tables;
  const rolls = bodyOf(bodies);
  const on = Object.keys(bodies).find((name) => name !== rolls);
  const lines = ["import viscoroll as vr", ""];
  const layers = (table, prefix) =>
    (table.layers ?? []).map((layer, index) => {
      const name = table.layers.length === 1 ? prefix : `${prefix}_${index + 1}`;
      lines.push(`${name} = ${call("Layer", layer)}`);
      return name;
    });
  const body = (name, variable, prefix) => {
    const { layers: _, ...rest } = bodies[name];
    const names = layers(bodies[name], prefix);
    const listed = { ...rest, ...(bodies[name].layers ? { layers: { raw: `[${names.join(", ")}]` } } : {}) };
    lines.push(`${variable} = ${call(CLASSES[name], listed)}`);
  };
  body(rolls, rolls, "layer");
  if (on) body(on, "ground", "ground_layer");
  const { drive, ...rest } = rolling;
  const options = {
    ...(on ? { on: { raw: "ground" } } : {}),
    ...rest,
    ...(drive ? { drive: { raw: call("Drive", drive) } } : {}),
    ...numerics,
  };
  lines.push("", `r = vr.solve(${[rolls, ...keywords(options)].join(", ")})`, "print(r)");
  if (thermal) lines.push(`t = r.temperature(${keywords(thermal).join(", ")})`, "print(t)");
  return `${lines.map(wrapped).join("\n")}\n`;
}

function call(name, keys) {
  return `vr.${name}(${keywords(keys).join(", ")})`;
}

function keywords(keys) {
  return Object.entries(keys).map(([name, value]) => `${name}=${python(name, value)}`);
}

function python(name, value) {
  if (value?.raw) return value.raw;
  if (Array.isArray(value)) return `[${value.map((one) => python("", one)).join(", ")}]`;
  if (value !== null && typeof value === "object") return name === "base" ? call("HalfSpace", value) : modulus(value);
  return literal(name, value);
}

/** A modulus from its table; data of data sheets and publications become calls of the functions that convert them. */
function modulus({ type, ...table }) {
  if (type === "published") {
    return `vr.rheology.example_material(${literal("", table.name)}).at(temperature=${literal("", table.temperature)})`;
  }
  if (type !== "hardness") return call(classOf(type), table);
  const scale = table.scale ? `, scale=${literal("", table.scale)}` : "";
  const static_modulus = { raw: `vr.rheology.hardness_to_modulus(${literal("", table.hardness)}${scale}).value` };
  if (table.rebound === undefined) return call("Elastic", { modulus: static_modulus });
  const { reference_frequency, decades } = table;
  const loss_factor = { raw: `vr.rheology.rebound_to_loss_factor(${literal("", table.rebound)}).value` };
  return call("LossFactor", {
    modulus: static_modulus,
    loss_factor,
    reference_frequency,
    ...(decades ? { decades } : {}),
  });
}

/** A number or a text in the common syntax of Python and TOML. */
function literal(name, value) {
  if (typeof value !== "number") return JSON.stringify(value);
  if (INTEGERS.includes(name)) return String(value);
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e5 || size < 1e-2)) return value.toExponential().replace("e+", "e");
  return Number.isInteger(value) ? `${value}.0` : String(value);
}

/** A line of code; if it is longer than 100 characters, with one line for each argument of the outer call. */
function wrapped(line) {
  if (line.length <= 100) return line;
  const open = line.indexOf("(");
  const parts = [];
  let depth = 0;
  let start = open + 1;
  for (let i = open; i < line.length; i += 1) {
    if ("([{".includes(line[i])) depth += 1;
    if (")]}".includes(line[i])) depth -= 1;
    if ((line[i] === "," && depth === 1) || (depth === 0 && line[i] === ")")) {
      parts.push(line.slice(start, i).trim());
      start = i + 1;
    }
  }
  return `${line.slice(0, open + 1)}\n${parts.map((part) => `    ${part},\n`).join("")})`;
}

/** A case file in TOML. */
export function caseFileOf(tables) {
  const header = ["# A case for `viscoroll solve`. All numbers are in SI units."];
  return `${[...header, ...Object.entries(tables).flatMap(([name, table]) => tomlTable(name, table))].join("\n")}\n`;
}

function tomlTable(name, table) {
  const isList = (value) => Array.isArray(value) && value.some((one) => typeof one === "object");
  const rows = Object.entries(table).filter(([, value]) => !isList(value));
  const lists = Object.entries(table).filter(([, value]) => isList(value));
  const nested = lists.flatMap(([key, list]) =>
    list.flatMap((one) => ["", `[[${name}.${key}]]`, ...Object.entries(one).map(([k, v]) => `${k} = ${toml(k, v)}`)]),
  );
  return ["", `[${name}]`, ...rows.map(([key, value]) => `${key} = ${toml(key, value)}`), ...nested];
}

function toml(name, value) {
  if (Array.isArray(value)) return `[${value.map((one) => toml("", one)).join(", ")}]`;
  if (value === null || typeof value !== "object") return literal(name, value);
  return `{ ${Object.entries(value)
    .map(([key, one]) => `${key} = ${toml(key, one)}`)
    .join(", ")} }`;
}

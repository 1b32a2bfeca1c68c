/** Kinds of materials in the form, and presets. */

import { fromSI, tidy, toSI } from "./units.js";

/** Ranges of hardness with a known modulus, by scale [Shore]. */
const SHORE_A = [20, 90];
export const SHORE_D = [30, 85];

/**
 * Kinds of materials, by the `type` of a case file. `fields`: the fields of the form; `table`: function that converts a
 * layer of the state to the table of a case file; `typed`: the inverse function. Fields have the names of the keys of
 * case files if there are such keys.
 */
export const KINDS = {
  standard_linear_solid: {
    label: "standard linear solid",
    fields: [
      { name: "instantaneous_modulus", label: "shear modulus, instantaneous", quantity: "modulus", range: [1e4, 1e9] },
      { name: "share", label: "relaxed / instantaneous modulus", range: [0.02, 1], linear: true, parameter: "relaxed_modulus", derived: true },
      { name: "relaxation_time", label: "relaxation time", quantity: "time", range: [1e-6, 10] },
    ],
    initial: { instantaneous_modulus: [6, "MPa"], share: 0.5, relaxation_time: [0.125, "s"] },
    table: (layer) => {
      const instantaneous = toSI(layer.instantaneous_modulus, "modulus");
      return {
        type: "standard_linear_solid",
        instantaneous_modulus: instantaneous,
        relaxed_modulus: tidy(instantaneous * layer.share),
        relaxation_time: toSI(layer.relaxation_time, "time"),
      };
    },
    typed: (table) => ({
      instantaneous_modulus: fromSI(table.instantaneous_modulus, "MPa", "modulus"),
      share: tidy(table.relaxed_modulus / table.instantaneous_modulus),
      relaxation_time: fromSI(table.relaxation_time, "s", "time"),
    }),
  },
  hardness: {
    label: "hardness and rebound",
    fields: [
      { name: "hardness", label: "hardness", range: SHORE_A, linear: true, step: 1 },
      { name: "scale", label: "scale", options: { A: "Shore A", D: "Shore D" }, chosen: onScale },
      {
        name: "rebound",
        label: "rebound",
        quantity: "percent",
        range: [0.02, 0.99],
        linear: true,
        step: 1,
        empty: "no loss",
      },
      { name: "reference_frequency", label: "frequency of the modulus", quantity: "frequency", range: [0.1, 1e4] },
    ],
    // A durometer is read after one second. The loss factor is constant from there to the frequencies of contacts.
    initial: { hardness: 85, scale: "A", rebound: [55, "%"], reference_frequency: [1, "rad/s"], decades: 4.5 },
    table: (layer) => ({
      type: "hardness",
      hardness: layer.hardness,
      ...(layer.scale === "A" ? {} : { scale: layer.scale }),
      ...(layer.rebound === null
        ? {}
        : {
            rebound: toSI(layer.rebound, "percent"),
            reference_frequency: toSI(layer.reference_frequency, "frequency"),
            decades: layer.decades,
          }),
    }),
    typed: (table) => ({
      hardness: table.hardness,
      scale: table.scale ?? "A",
      rebound: table.rebound === undefined ? null : fromSI(table.rebound, "%", "percent"),
      reference_frequency: [table.reference_frequency ?? 1, "rad/s"],
      decades: table.rebound === undefined ? 4.5 : (table.decades ?? 3),
    }),
  },
  loss_factor: {
    label: "modulus and loss factor",
    fields: [
      { name: "modulus", label: "storage shear modulus", quantity: "modulus", range: [1e4, 1e9] },
      { name: "loss_factor", label: "loss factor tan δ", range: [0.01, 1], linear: true, step: 0.01 },
      { name: "reference_frequency", label: "frequency of both values", quantity: "frequency", range: [1, 1e5] },
    ],
    initial: { modulus: [3, "MPa"], loss_factor: 0.2, reference_frequency: [300, "rad/s"], decades: 3 },
    table: (layer) => ({
      type: "loss_factor",
      modulus: toSI(layer.modulus, "modulus"),
      loss_factor: layer.loss_factor,
      reference_frequency: toSI(layer.reference_frequency, "frequency"),
      decades: layer.decades,
    }),
    typed: (table) => ({
      modulus: fromSI(table.modulus, "MPa", "modulus"),
      loss_factor: table.loss_factor,
      reference_frequency: [table.reference_frequency, "rad/s"],
      decades: table.decades ?? 3,
    }),
  },
  elastic: {
    label: "elastic (no loss)",
    fields: [{ name: "modulus", label: "shear modulus", quantity: "modulus", range: [1e4, 1e11] }],
    initial: { modulus: [3, "MPa"] },
    table: (layer) => ({ type: "elastic", modulus: toSI(layer.modulus, "modulus") }),
    typed: (table) => ({ modulus: fromSI(table.modulus, "MPa", "modulus") }),
  },
  published: {
    label: "published measurement",
    fields: [
      {
        name: "name",
        label: "material",
        options: {
          pressure_sensitive_adhesive: "pressure-sensitive adhesive 468MP",
          vinyl_nitrile_foam: "vinyl nitrile foam VN01",
        },
      },
      {
        name: "temperature",
        label: "temperature",
        quantity: "temperature",
        range: [263.15, 323.15],
        linear: true,
        step: 10,
      },
    ],
    initial: { name: "pressure_sensitive_adhesive", temperature: [20, "°C"] },
    table: (layer) => ({ type: "published", name: layer.name, temperature: toSI(layer.temperature, "temperature") }),
    typed: (table) => ({ name: table.name, temperature: fromSI(table.temperature, "°C", "temperature") }),
  },
  kept: {
    label: "as in the case file",
    fields: [],
    initial: null, // the user cannot choose this kind
    table: (layer) => layer.kept,
    typed: (table) => ({ kept: table }),
  },
};

/** Convert a hardness to another scale, within its range: for equal moduli, Shore D is 50 less than Shore A. */
function onScale({ hardness }, scale) {
  const [low, high] = scale === "D" ? SHORE_D : SHORE_A;
  return { scale, hardness: Math.min(Math.max(hardness + (scale === "D" ? -50 : 50), low), high) };
}

/** The kind for a table of a case file. */
export function kindOf(table) {
  const kind = KINDS[table.type];
  const optional = ["type", "scale", "rebound", "reference_frequency", "decades"];
  const needed = Object.keys(kind?.initial ?? {}).map((name) => (name === "share" ? "relaxed_modulus" : name));
  const known = kind && Object.keys(table).every((name) => optional.includes(name) || needed.includes(name));
  return known ? table.type : "kept";
}

const rubber = { poisson_ratio: 0.5, density: [1000, "kg/m³"] };
const urethane = { poisson_ratio: 0.495, density: [1100, "kg/m³"] };
const hard = (hardness, rebound) => ({
  kind: "hardness",
  ...KINDS.hardness.initial,
  hardness,
  rebound: [rebound, "%"],
});

const IMPACT =
  "Hardness gives the modulus after one second, within a factor of about 1.4; rebound gives the loss in an impact of milliseconds.";

/** Presets by name: label, source, and the part of a layer that they set. */
export const PRESETS = {
  paper_rubber: {
    label: "rubber of the paper",
    source: "G.-P. Zéhil and H. P. Gavin, Rolling resistance of a rigid sphere with viscoelastic coatings, section 14.",
    layer: { kind: "standard_linear_solid", ...KINDS.standard_linear_solid.initial, ...rubber },
  },
  skate: {
    label: "skate wheel, 82 A, rebound 70 %",
    source: `Not measured: values that makers print on good wheels, from the series 78, 82, 86 A. ${IMPACT}`,
    layer: { ...hard(82, 70), ...urethane },
  },
  caster: {
    label: "caster polyurethane, 85 A, rebound 55 %",
    source: `Not measured: typical values of data sheets. ${IMPACT}`,
    layer: { ...hard(85, 55), ...urethane },
  },
  soft_rubber: {
    label: "soft rubber, 60 A, rebound 45 %",
    source: `Not measured: typical values of data sheets. ${IMPACT}`,
    layer: { ...hard(60, 45), poisson_ratio: 0.499, density: [1150, "kg/m³"] },
  },
  adhesive: {
    label: "pressure-sensitive adhesive",
    source:
      "468MP, measured: A. Perego, hermes-rheo (3M), MIT license, github.com/3mcloud/hermes-rheo. Poisson's ratio was not measured.",
    layer: { kind: "published", ...KINDS.published.initial, poisson_ratio: 0.499, density: [1000, "kg/m³"] },
  },
  foam: {
    label: "vinyl nitrile foam",
    source:
      "VN01, measured at 10 rad/s: A. K. Landauer et al., Materials & Design (2023) 112381; data doi:10.18434/mds2-2989. Its density was not measured.",
    layer: {
      kind: "published",
      name: "vinyl_nitrile_foam",
      temperature: [20, "°C"],
      poisson_ratio: 0.22825,
      density: [0, "kg/m³"],
    },
  },
};

/** A new layer, made of the rubber of the paper. */
export function newLayer() {
  return { thickness: [1, "mm"], preset: "paper_rubber", ...PRESETS.paper_rubber.layer };
}

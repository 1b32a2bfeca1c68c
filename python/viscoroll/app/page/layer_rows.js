/** Rows of the form for the layers of a body, with materials from presets or numbers. */

import { el } from "./dom.js";
import { choiceField, numberField } from "./field.js";
import { KINDS, PRESETS, SHORE_D, newLayer } from "./materials.js";

/**
 * Rows for all layers, and a button that adds a layer.
 * @param {object} of
 * @param {() => object[]} of.layers returns the current layers
 * @param {string} of.prefix prefix of the names of their parameters
 * @param {(field) => void} of.add called with each field
 * @param {(layers, redraw: boolean) => void} of.change called with the changed layers
 * @returns {HTMLElement[]}
 */
export function layerRows(of) {
  const more = () => of.change([...of.layers(), newLayer()], true);
  const rows = of.layers().map((_, index) => layerRow({ ...of, index }));
  return [
    ...rows,
    el("button", { type: "button", onclick: more }, rows.length ? "Add an outer layer" : "Add a layer"),
  ];
}

/** Row for one layer; `halfSpace`: a half-space, which has no thickness. */
export function layerRow({ layers, prefix, add, change, index, halfSpace = false }) {
  const layer = () => layers()[index];
  const update = (part, redraw = false) =>
    change(
      layers().map((one, i) => (i === index ? { ...one, ...part } : one)),
      redraw,
    );
  const remove = () =>
    change(
      layers().filter((_, i) => i !== index),
      true,
    );
  const added = (make, { name, parameter = name, ...more }) => {
    const field = make({ parameter: `${prefix}layers[${index}].${parameter}`, ...more });
    add(field);
    return field.root;
  };
  const number = (of) =>
    added(numberField, { value: layer()[of.name], change: (value) => update({ [of.name]: value, preset: "" }), ...of });
  const choice = (of) =>
    added(choiceField, {
      value: () => layer()[of.name],
      change: (value) => update({ ...(of.chosen?.(layer(), value) ?? { [of.name]: value }), preset: "" }, true),
      ...of,
    });

  const { kind } = layer();
  const material = KINDS[kind].fields.map((one) => {
    if (one.options) return choice(one);
    return number(one.name === "hardness" && layer().scale === "D" ? { ...one, range: SHORE_D } : one);
  });
  const head = el(
    "div",
    { class: "head" },
    el("h3", {}, halfSpace ? "Material" : `Layer ${index + 1}`),
    halfSpace
      ? null
      : el("button", { type: "button", onclick: remove, "aria-label": `remove layer ${index + 1}` }, "Remove"),
  );
  return el(
    "div",
    { class: "layer" },
    head,
    halfSpace
      ? null
      : number({
          name: "thickness",
          label: "thickness",
          quantity: "length",
          range: [1e-4, 0.1],
          change: (thickness) => update({ thickness }),
        }),
    choice({
      name: "preset",
      label: "material",
      options: { "": "custom", ...labels(PRESETS) },
      value: () => layer().preset ?? "",
      note: () => PRESETS[layer().preset]?.source ?? "",
      change: (preset) => update({ preset, ...PRESETS[preset]?.layer }, true),
    }),
    choice({
      name: "kind",
      parameter: "type",
      label: "given by",
      options: labels(
        Object.fromEntries(Object.entries(KINDS).filter(([name, one]) => one.initial !== null || name === kind)),
      ),
      change: (chosen) => update({ ...KINDS[chosen].initial, kind: chosen, preset: "" }, true),
    }),
    ...material,
    layer().bulk_modulus === undefined
      ? number({ name: "poisson_ratio", label: "Poisson’s ratio", range: [0, 0.5], linear: true, step: 0.005 })
      : null,
    number({
      name: "density",
      label: "density (0: no inertia)",
      quantity: "density",
      range: [0, 3000],
      linear: true,
      step: 50,
    }),
  );
}

function labels(table) {
  return Object.fromEntries(Object.entries(table).map(([name, { label }]) => [name, label]));
}

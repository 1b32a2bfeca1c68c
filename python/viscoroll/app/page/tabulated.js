/**
 * Materials of data sheets and laboratories for the library in WebAssembly, which does not have them: only the Python
 * package has their formulas and data. It tabulated their moduli when the site was built (app/tabulated.py).
 */

/**
 * The request with materials that the library has.
 * @returns {{known: object}|{error: {message: string, parameter: string, rule: string, value: string}}} an error for
 * values that are not tabulated
 */
export function withMaterials(request, tables) {
  try {
    return { known: { ...request, case: replaced(request.case, tables, "") } };
  } catch (error) {
    if (error instanceof NotTabulated) {
      const { message, parameter, rule, value } = error;
      return { error: { message, parameter, rule, value } };
    }
    throw error;
  }
}

class NotTabulated extends Error {
  constructor(path, name, rule, value) {
    super(`${path}.${name} must be ${rule} on this page, got ${value}`);
    this.parameter = `${path}.${name}`;
    this.rule = `must be ${rule} on this page`;
    this.value = String(value);
  }
}

function replaced(value, tables, path) {
  if (Array.isArray(value)) return value.map((one, i) => replaced(one, tables, `${path}[${i}]`));
  if (value === null || typeof value !== "object") return value;
  const made = { hardness: ofDataSheet, loss_factor: ofLossFactor, published: ofLaboratory }[value.type];
  if (made) return made(value, tables, path);
  const inside = (name) => (path ? `${path}.${name}` : name);
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, replaced(one, tables, inside(name))]));
}

function ofDataSheet({ hardness, scale = "A", rebound, ...table }, tables, path) {
  const modulus = tables.hardness[scale][hardness];
  if (modulus === undefined) {
    const all = Object.keys(tables.hardness[scale]);
    const rule = `a whole number in [${all[0]}, ${all.at(-1)}] Shore ${scale}`;
    throw new NotTabulated(path, "hardness", rule, `${hardness}${inShoreD(hardness, scale)}`);
  }
  if (rebound === undefined) return { type: "elastic", modulus };
  const found = tables.rebound.series[percent(rebound)];
  if (!found) throw new NotTabulated(path, "rebound", "a whole percentage in [2, 99]", `${percent(rebound)} %`);
  return scaled(found, tables.rebound, { modulus, ...table }, path);
}

/** Hint for hardnesses above 90 Shore A, for which the tables use Shore D: about 50 less. */
function inShoreD(hardness, scale) {
  return scale === "A" && hardness > 90 && hardness <= 100 ? `; it is about ${hardness - 50} Shore D` : "";
}

function ofLossFactor({ loss_factor: lossFactor, ...table }, tables, path) {
  const found = tables.loss_factor.series[percent(lossFactor)];
  if (!found) throw new NotTabulated(path, "loss_factor", "a multiple of 0.01 in [0.01, 1]", lossFactor);
  return scaled(found, tables.loss_factor, table, path);
}

function ofLaboratory({ name, temperature }, tables, path) {
  const table = tables.published[name][temperature];
  if (!table) throw new NotTabulated(path, "temperature", "263.15, 273.15, ... or 323.15 K (-10, 0, ... or 50 °C)", `${temperature} K`);
  return table;
}

const percent = (ratio) => Number((100 * ratio).toPrecision(12));

/** A tabulated series of 1 Pa at 1 rad/s, with geometric weights between the ends, scaled to modulus and frequency. */
function scaled([instantaneous, first, second, ratio, last], { decades, relaxation_times: times }, table, path) {
  const { modulus, reference_frequency: frequency, decades: wanted = 3 } = table;
  if (wanted !== decades) throw new NotTabulated(path, "decades", String(decades), wanted);
  const between = Array.from({ length: times.length - 2 }, (_, k) => second * ratio ** k);
  return {
    type: "prony",
    instantaneous_modulus: instantaneous * modulus,
    weights: [first, ...between, last],
    relaxation_times: times.map((time) => time / frequency),
  };
}

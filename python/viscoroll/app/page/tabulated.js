/**
 * Published materials for the library in WebAssembly: only the Python package has their data. It tabulated their moduli
 * when the site was built (app/tabulated.py).
 */

/**
 * The request with materials that the library has.
 * @returns {{known: object}|{error: {message: string, parameter: string, rule: string, value: string, allowed: null}}} an error for a
 * temperature that is not tabulated
 */
export function withMaterials(request, tables) {
  try {
    return { known: { ...request, case: replaced(request.case, tables, "") } };
  } catch (error) {
    if (error instanceof NotTabulated) {
      const { message, parameter, rule, value } = error;
      return { error: { message, parameter, rule, value, allowed: null } };
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
  if (value.type === "published") return ofLaboratory(value, tables, path);
  const inside = (name) => (path ? `${path}.${name}` : name);
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, replaced(one, tables, inside(name))]));
}

function ofLaboratory({ name, temperature }, tables, path) {
  const table = tables[name][temperature];
  if (!table) throw new NotTabulated(path, "temperature", "263.15, 273.15, ... or 323.15 K (-10, 0, ... or 50 °C)", `${temperature} K`);
  return table;
}

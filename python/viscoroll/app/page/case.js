/**
 * The state of the form, and the case that it describes.
 *
 * A state holds the numbers of all fields of the form, as the user typed them, with their units, such as [20, "mm"]. A
 * case has the tables and keys of a case file, as JSON in SI units; it is the input of the solvers.
 */

import { DRIVES, driveZeros, scaleOf } from "./drives.js";
import { KINDS, kindOf, newLayer } from "./materials.js";
import { BODIES, MESH } from "./schema.js";
import { fromSI, tidy, toSI } from "./units.js";

/** State for the example of the README. */
export function initialState() {
  return {
    body: "ball",
    given: "core_radius",
    size: [20, "mm"],
    inner_boundary: "rigid",
    width: [30, "mm"],
    crown_radius: null, // flat
    hub: "straight",
    sides: "free",
    layers: [newLayer()],
    on: "rigid",
    ground: [newLayer()],
    radius: [30, "mm"],
    pressed: "load", // or "penetration"
    load: [100, "N"],
    penetration: [0.2, "mm"],
    speed: [2.5, "rad/s"],
    friction: 0,
    drive: "force",
    ...driveZeros(false),
    compliance: "radial",
    curvature: "sphere",
    accuracy: 0.01,
    temperature: "off", // or "on"
    convection: 10, // [W/(m² K)]
    ambient: [20, "°C"],
    conductivity: 0.2, // [W/(m K)]
    core: "insulated",
    obstacle: "none", // or a type of `OBSTACLES`
    obstacle_size: [0.1, "mm"],
    obstacle_length: [10, "mm"],
    axle: "load", // or "mass"
    axle_mass: 2, // [kg], in line contact [kg/m]
    numerics: {}, // other keys of this table in a case file
  };
}

/** Whether load and results are per length. */
export const isLine = (state) => BODIES[state.body].line;

/** Table of the rolling body of a case. */
export const bodyOf = (tables) => Object.keys(BODIES).find((name) => name in tables);

/** Quantity of a number of the state; the kinds of materials define the quantities of their numbers. */
export function quantity(name, state) {
  const line = isLine(state);
  if (name in DRIVES) return scaleOf(name, line).quantity;
  return {
    size: "length",
    width: "length",
    crown_radius: "length",
    radius: "length",
    thickness: "length",
    density: "density",
    load: line ? "line_force" : "force",
    penetration: "length",
    speed: "speed",
    ambient: "temperature",
    obstacle_size: "length",
    obstacle_length: "length",
  }[name];
}

/** Whether the body has a core; a solid ball has none. */
const hasCore = (state) => state.body !== "ball" || state.inner_boundary !== "solid";

function thickness(state) {
  return state.layers.reduce((sum, layer) => sum + toSI(layer.thickness, "length"), 0);
}

/** Outer radius of the body [m]. */
export function outerRadius(state) {
  const size = toSI(state.size, "length");
  if (!hasCore(state)) return thickness(state);
  return tidy(state.given === "outer_diameter" ? 0.5 * size : size + thickness(state));
}

/** Radius of the core [m]. */
export function coreRadius(state) {
  if (!hasCore(state)) return 0;
  const size = toSI(state.size, "length");
  return tidy(state.given === "outer_diameter" ? 0.5 * size - thickness(state) : size);
}

/** Angular speed [rad/s]. */
const angularSpeed = (state) => toSI(state.speed, "speed", outerRadius(state));

/** Names of the counterbodies that the form offers for a body. */
export function groundsOf(body) {
  return {
    rigid: "rigid plane",
    plane: "layers on a rigid base",
    half_space: "half-space of one material",
    ...(BODIES[body].line ? {} : { groove: "rigid groove or rail" }),
    ...(body === "ball" ? {} : { drum: "rigid drum or roller" }),
  };
}

/** The same state with the size given by core radius or outer diameter. */
export function sizedBy(state, given) {
  const meters = given === "core_radius" ? coreRadius(state) : 2 * outerRadius(state);
  return given === state.given ? state : { ...state, given, size: fromSI(meters, "mm", "length") };
}

/** Tables of the case file for a state, in SI units: those of its case, and of the temperature if it is computed. */
export function fileOf(state) {
  return { ...caseOf(state), ...(state.temperature === "on" ? { thermal: thermalOf(state) } : {}) };
}

/** Table of the temperature. */
export function thermalOf({ convection, ambient, conductivity, core }) {
  const isNumber = Number.isFinite(Number(core)); // the conductivity of a solid core, in a case file
  return { convection, ambient: toSI(ambient, "temperature"), conductivity, core: isNumber ? Number(core) : core };
}

/** Tables of the case for a state, in SI units, without its temperature. */
export function caseOf(state) {
  return {
    [state.body]: bodyTable(state),
    ...groundTables(state),
    rolling: rollingTable(state),
    numerics: numericsTable(state),
  };
}

function bodyTable(state) {
  const layers = state.layers.map(layerTable);
  if (state.body === "cylinder") return { core_radius: coreRadius(state), layers };
  if (state.body === "wheel") {
    return {
      core_radius: coreRadius(state),
      width: toSI(state.width, "length"),
      ...(state.crown_radius === null ? {} : { crown_radius: toSI(state.crown_radius, "length"), hub: state.hub }),
      ...(state.sides === "free" ? {} : { sides: state.sides }),
      layers,
    };
  }
  if (state.inner_boundary === "solid") return { inner_boundary: "solid", layers };
  return { core_radius: coreRadius(state), inner_boundary: state.inner_boundary, layers };
}

function layerTable(layer) {
  return {
    thickness: toSI(layer.thickness, "length"),
    shear_modulus: KINDS[layer.kind].table(layer),
    ...materialTable(layer),
  };
}

function materialTable(layer) {
  const bulk =
    layer.bulk_modulus === undefined ? { poisson_ratio: layer.poisson_ratio } : { bulk_modulus: layer.bulk_modulus };
  return { ...bulk, density: toSI(layer.density, "density") };
}

function groundTables(state) {
  const radius = toSI(state.radius, "length");
  switch (state.on) {
    case "plane":
      return { plane: { layers: state.ground.map(layerTable) } };
    case "half_space": {
      const { thickness: _, ...material } = layerTable(state.ground[0]);
      return { plane: { base: material } };
    }
    case "groove":
      return { groove: { radius } };
    case "drum":
      return { other_cylinder: { core_radius: radius, layers: [] } };
    default:
      return {};
  }
}

function rollingTable(state) {
  const rolling = {
    [state.pressed]: toSI(state[state.pressed], quantity(state.pressed, state)),
    angular_speed: angularSpeed(state),
    friction: state.friction,
  };
  if (state.friction === 0) return rolling; // without friction there is no drive
  return { ...rolling, drive: { [state.drive]: toSI(state[state.drive], quantity(state.drive, state)) } };
}

function numericsTable(state) {
  const model = state.body === "ball" && state.curvature !== "sphere" ? { curvature: state.curvature } : {};
  return { accuracy: state.accuracy, compliance: state.compliance, ...model, ...state.numerics };
}

/**
 * The state of the form for a case, and the paths of the keys that the form does not support (`left`).
 * @returns {{state: object, left: string[]}}
 */
export function stateOf(tables) {
  const state = initialState();
  state.body = bodyOf(tables) ?? "ball";
  const body = tables[state.body] ?? {};
  const mm = (value) => fromSI(value, "mm", "length");
  state.size = mm(body.core_radius ?? 0);
  state.inner_boundary = body.inner_boundary ?? (body.core_radius ? "rigid" : "solid");
  if (body.width !== undefined) state.width = mm(body.width);
  if (Number.isFinite(body.crown_radius)) state.crown_radius = mm(body.crown_radius);
  state.hub = body.hub ?? "straight";
  state.sides = body.sides ?? "free";
  state.layers = layersOf(body);
  readGround(state, tables);
  const rolling = tables.rolling ?? {};
  const line = isLine(state);
  state.load = fromSI(rolling.load ?? 100, line ? "N/mm" : "N", quantity("load", state));
  if (rolling.penetration !== undefined) {
    Object.assign(state, { pressed: "penetration", penetration: mm(rolling.penetration) });
  }
  state.speed = rolling.speed === undefined ? [rolling.angular_speed ?? 2.5, "rad/s"] : [rolling.speed, "m/s"];
  state.friction = rolling.friction ?? 0;
  Object.assign(state, driveZeros(line));
  if (state.friction > 0) readDrive(state, rolling.drive);
  readNumerics(state, tables.numerics ?? {});
  if (tables.thermal) readThermal(state, tables.thermal, body.layers?.at(-1));
  const { speed, ...others } = rolling; // the case has the angular speed
  return { state, left: missingIn(fileOf(state), { ...tables, rolling: others }) };
}

/** Without a conductivity of all layers, use that of the outer layer. */
function readThermal(state, { convection, ambient = 293.15, conductivity, core }, layer) {
  state.temperature = "on";
  if (Number.isFinite(convection)) state.convection = convection;
  state.ambient = fromSI(ambient, "°C", "temperature");
  state.conductivity = [conductivity, layer?.conductivity].flat().find(Number.isFinite) ?? state.conductivity;
  state.core = core ?? state.core;
}

/** Values of keys that a case omits because they are the default. */
const DEFAULTS = { hub: "straight", sides: "free", curvature: "sphere" };

/** Paths of the keys that tables of a file have and tables of a case do not, unless their values are defaults. */
function missingIn(tables, file, path = "") {
  return Object.entries(file).flatMap(([name, value]) => {
    const inside = Array.isArray(file) ? `${path}[${name}]` : path ? `${path}.${name}` : name;
    if (!(name in tables)) return isDefault(name, value) ? [] : [inside];
    if (Array.isArray(value) && typeof tables[name] === "number") return [inside]; // a number for each layer
    const areTables = [value, tables[name]].every((one) => one !== null && typeof one === "object");
    return areTables ? missingIn(tables[name], value, inside) : [];
  });
}

function isDefault(name, value) {
  if (value === null || value === 0 || DEFAULTS[name] === value) return true;
  return typeof value === "object" && Object.entries(value).every(([key, one]) => isDefault(key, one));
}

function readGround(state, tables) {
  const { plane, groove, other_cylinder: drum } = tables;
  if (plane?.base && !plane.layers?.length) {
    state.on = "half_space";
    state.ground = layersOf({ layers: [{ thickness: 1e-3, ...plane.base }] });
  } else if (plane?.layers?.length) {
    state.on = "plane";
    state.ground = layersOf(plane);
  } else if (groove) {
    state.on = "groove";
    state.radius = fromSI(groove.radius ?? 0, "mm", "length");
  } else if (drum) {
    state.on = "drum";
    state.radius = fromSI(drum.core_radius, "mm", "length");
  }
}

function readDrive(state, drive) {
  if (!drive) return;
  state.drive = Object.keys(DRIVES).find((name) => name in drive) ?? "force";
  const [, unit] = state[state.drive];
  state[state.drive] = fromSI(drive[state.drive] ?? 0, unit, quantity(state.drive, state));
}

function readNumerics(state, { accuracy = 0.01, compliance = "radial", curvature = "sphere", ...others }) {
  const kept = Object.entries(others).filter(([name]) => !MESH.includes(name)); // the page chooses the meshes
  Object.assign(state, { accuracy, compliance, curvature, numerics: Object.fromEntries(kept) });
}

function layersOf({ layers = [] }) {
  return layers.map(({ thickness: thick, shear_modulus: modulus, poisson_ratio, bulk_modulus, density = 0 }) => {
    const table = typeof modulus === "number" ? { type: "elastic", modulus } : modulus;
    const kind = kindOf(table);
    return {
      thickness: fromSI(thick, "mm", "length"),
      kind,
      ...KINDS[kind].typed(table),
      ...(bulk_modulus === undefined ? { poisson_ratio } : { bulk_modulus }),
      density: [density, "kg/m³"],
    };
  });
}

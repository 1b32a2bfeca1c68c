// Written by wasm/make_types.py from the package and the JSON Schema of case files.

/** Rolling bodies by their tables in case files: noun, whether values are per length, and words of labels. */
export const BODIES = {
  ball: { noun: "ball", line: false, words: { "rolling body": "ball" } },
  cylinder: { noun: "roller", line: true, words: { "rolling body": "roller", "contact length": "nip length" } },
  wheel: { noun: "wheel", line: false, words: { "rolling body": "wheel" } },
};

/** Classes of bodies in Python, by their tables in case files. */
export const CLASSES = {
  ball: "CoatedSphere",
  cylinder: "CoatedCylinder",
  wheel: "CoatedWheel",
  plane: "CoatedPlane",
  groove: "Groove",
  other_ball: "CoatedSphere",
  other_cylinder: "CoatedCylinder",
  other_wheel: "CoatedWheel",
};

/** Classes of moduli that are names of the Python package; the others are names of its module `materials`. */
export const COMMON_MODULI = ["Elastic", "LossFactor", "MasterCurve", "Prony", "StandardLinearSolid"];

/** Keys of case files whose values are whole numbers. */
export const INTEGERS = ["nodes_per_revolution", "max_order", "theta_nodes_per_revolution"];

/** Keys of the table `numerics` that describe a mesh. */
export const MESH = ["nodes_per_revolution", "max_order", "theta_nodes_per_revolution"];

/** SI units of keys of case files, in point contact. */
export const KEY_UNITS = {
  shear_modulus: "Pa",
  bulk_modulus: "Pa",
  density: "kg/m³",
  thickness: "m",
  core_radius: "m",
  outer_diameter: "m",
  width: "m",
  crown_radius: "m",
  radius: "m",
  path_radius: "m",
  force: "N",
  torque: "N m",
  power: "W",
  creepage: "1",
  lateral_creepage: "1",
  strength: "Pa",
  range: "m",
  load: "N",
  penetration: "m",
  angular_speed: "rad/s",
  speed: "m/s",
  friction: "1",
  accuracy: "1",
  modulus: "Pa",
  instantaneous_modulus: "Pa",
  weights: "1",
  relaxation_times: "s",
  relaxed_modulus: "Pa",
  relaxation_time: "s",
  retardation_times: "s",
  loss_factor: "1",
  reference_frequency: "rad/s",
  decades: "1",
  compression_set: "1",
  compression_time: "s",
  recovery_time: "s",
  creep_ratio: "1",
  creep_time: "s",
  creep_start: "s",
  order: "1",
  asymmetry: "1",
  frequency: "rad/s",
  storage: "Pa",
  loss: "Pa",
  temperature: "K",
};

/** Tables of case files that the page does not support. */
export const OTHER_TABLES = ["thermal", "motion", "ground", "tread", "axle", "surface", "sliding", "sweep", "design"];

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

/** Keys of case files whose values are whole numbers. */
export const INTEGERS = ["nodes_per_revolution", "max_order", "theta_nodes_per_revolution"];

/** Keys of the table `numerics` that describe a mesh. */
export const MESH = ["nodes_per_revolution", "max_order", "theta_nodes_per_revolution"];

/** Rolling resistance of balls, rollers and wheels with viscoelastic layers. All numbers are in SI units. */

/** A modulus [Pa] over angular frequency, or a number: an elastic one. */
export type ShearModulus =
  | number
  | { type: "elastic"; modulus: number }
  | {
      type: "standard_linear_solid";
      instantaneous_modulus: number;
      relaxed_modulus: number;
      relaxation_time: number;
    }
  | { type: "prony"; instantaneous_modulus: number; weights: number[]; relaxation_times: number[] }
  | { type: "creep_compliance"; instantaneous_compliance: number; compliances: number[]; retardation_times: number[] }
  | { type: "kelvin_voigt"; modulus: number; viscosity: number }
  | {
      type: "fractional_zener";
      instantaneous_modulus: number;
      relaxed_modulus: number;
      relaxation_time: number;
      order: number;
    }
  | {
      type: "master_curve";
      frequency: number[];
      storage: number[];
      loss: number[];
      extrapolation?: "error" | "hold";
    };

/** Exactly one of `poisson_ratio` and `bulk_modulus` is given. */
export interface HalfSpace {
  shear_modulus: ShearModulus;
  poisson_ratio?: number | null;
  bulk_modulus?: number | null;
  density?: number;
}

export interface Layer extends HalfSpace {
  thickness: number;
  conductivity?: number | null;
}

export interface Ball {
  core_radius?: number;
  /** From the center outwards. */
  layers?: Layer[];
  inner_boundary?: "rigid" | "hollow" | "solid";
}

/** A roller in line contact, whose load, forces, torques and powers are per length. */
export interface Cylinder {
  core_radius: number;
  layers?: Layer[];
}

export interface Wheel {
  core_radius: number;
  layers?: Layer[];
  width: number;
  /** Flat where it is left out. */
  crown_radius?: number;
  hub?: "straight" | "crowned";
  sides?: "free" | "unbounded";
}

/** Without layers and base it is rigid. */
export interface Plane {
  /** From the base outwards. */
  layers?: Layer[];
  base?: HalfSpace | null;
}

/** Curved across the path, along it, or both ways: hollow where a radius is > 0. */
export interface Groove extends Plane {
  radius?: number | null;
  path_radius?: number | null;
}

/** One of the three; without friction a force of 0 or a creepage. */
export type Drive =
  | { force: number }
  | { torque: number }
  | { creepage: number; lateral_creepage?: number; spin?: number };

export interface Rolling {
  /** Force on what it rolls on [N], of a roller per length [N/m]. */
  load: number;
  /** [rad/s] */
  angular_speed: number;
  /** Coulomb's coefficient, up to 4; Infinity: full stick. */
  friction?: number;
  drive?: Drive;
}

/** Either a mesh is given or an accuracy is reached. */
export interface Numerics {
  accuracy?: number | null;
  nodes_per_revolution?: number | null;
  theta_nodes_per_revolution?: number | null;
  max_order?: number | null;
  compliance?: "radial" | "vertical";
  curvature?: "sphere" | "paper" | "exact";
  patch_load?: "flat" | "spherical";
  slip_kinematics?: "exact" | "flat";
}

/** The tables and keys of a case file: one body, and at most one that it rolls on, a rigid plane without. */
export interface Case {
  ball?: Ball;
  cylinder?: Cylinder;
  wheel?: Wheel;
  plane?: Plane;
  groove?: Groove;
  other_ball?: Ball;
  other_cylinder?: Cylinder;
  other_wheel?: Wheel;
  rolling: Rolling;
  numerics?: Numerics;
}

export interface Request {
  case: Case;
  /** Whether fields are wanted. */
  fields?: boolean;
}

/** Rows along x, the direction of rolling; columns along z, across it. */
export interface Fields {
  /** [m] */
  x: number[];
  /** [m] */
  z: number[];
  /** [Pa] */
  pressure: number[][];
  /** 1 where it sticks, 2 where it slips, 0 out of contact; null without friction. */
  stick: number[][] | null;
  /** Heights in the middle plane, as the surface is and as it was [m]. */
  profile: { x: number[]; surface: number[]; rigid: number[] };
}

export interface Result {
  /** Those of `scalars()`, null where undetermined or infinite, with contact_nodes, nodes_per_revolution, max_order. */
  scalars: Record<string, number | null>;
  state: "converged" | "max_iterations" | "accuracy_not_reached";
  warnings: { kind: string; message: string }[];
  fields?: Fields;
}

/** An error. The last three are null if it is not about the value of a parameter. */
export interface Failure {
  message: string;
  /** Path in the case, such as "ball.layers[0].thickness". */
  parameter: string | null;
  /** Rule that the value violates, with range and unit, such as "must be > 0 m". */
  rule: string | null;
  value: string | null;
}

export type Answer = { result: Result; error?: undefined } | { error: Failure; result?: undefined };

export interface Scalar {
  name: string;
  unit: string;
  description: string;
}

/** Solve a case, on the thread that asks: in a page, have a worker ask. Bad input is an answer, too. */
export function solve(request: Request): Promise<Answer>;

/** The table of scalar results. */
export function scalars(): Promise<Scalar[]>;

/**
 * Have a worker answer messages: `{id, name: "solve", content: request}` or `{id, name: "scalars"}` by `{id, answer}`,
 * or `{id, failure}` where the module broke off.
 */
export function serve(scope?: object): void;

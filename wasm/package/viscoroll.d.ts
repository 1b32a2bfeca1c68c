/** Rolling resistance of balls, rollers and wheels with viscoelastic layers. All numbers are in SI units. */

/** Shear modulus [Pa] as a function of angular frequency; a number is an elastic modulus. */
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

/** Material of a layer or half-space, with exactly one of `poisson_ratio` and `bulk_modulus`. */
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
  /** Layers from the center outwards. */
  layers?: Layer[];
  inner_boundary?: "rigid" | "hollow" | "solid";
}

/** Roller in line contact. Its load, forces, torques and powers are per length. */
export interface Cylinder {
  core_radius: number;
  layers?: Layer[];
}

export interface Wheel {
  core_radius: number;
  layers?: Layer[];
  width: number;
  /** Radius of the profile across the path [m]; by default the tread is flat. */
  crown_radius?: number;
  hub?: "straight" | "crowned";
  sides?: "free" | "unbounded";
}

/** Plane with layers on a base; without layers and base it is rigid. */
export interface Plane {
  /** Layers from the base outwards. */
  layers?: Layer[];
  base?: HalfSpace | null;
}

/** Surface curved across the path (`radius`), along it (`path_radius`), or both [m]; concave if a radius is > 0. */
export interface Groove extends Plane {
  radius?: number | null;
  path_radius?: number | null;
}

/** Drive: exactly one of force, torque and creepage. Without friction, only a force of 0 or a creepage is allowed. */
export type Drive =
  | { force: number }
  | { torque: number }
  | { creepage: number; lateral_creepage?: number; spin?: number };

export interface Rolling {
  /** Normal load [N]; for rollers, load per length [N/m]. */
  load?: number;
  /** Radius of the body at rest minus height of its center [m]; exactly one of load and penetration is given. */
  penetration?: number;
  /** [rad/s] */
  angular_speed: number;
  /** Coulomb's coefficient of friction, at most 4; with Infinity the whole contact sticks. */
  friction?: number;
  drive?: Drive;
}

/** Options of the solver: a mesh, or an accuracy to which the solver refines the mesh. */
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

/** Tables and keys of a case file: one rolling body and at most one counterbody, by default a rigid plane. */
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
  /** Whether to return fields. */
  fields?: boolean;
}

/** Fields at the nodes: rows along x, the direction of rolling, and columns along z, across it. */
export interface Fields {
  /** [m] */
  x: number[];
  /** [m] */
  z: number[];
  /** [Pa] */
  pressure: number[][];
  /** State of each node: 1 if it sticks, 2 if it slips, 0 if it is not in contact; null without friction. */
  stick: number[][] | null;
  /** Heights in the middle plane, of the deformed surface (`surface`) and of the undeformed one (`rigid`) [m]. */
  profile: { x: number[]; surface: number[]; rigid: number[] };
}

export interface Result {
  /** Scalars of `scalars()`, and contact_nodes, nodes_per_revolution, max_order; null if undetermined or infinite. */
  scalars: Record<string, number | null>;
  state: "converged" | "max_iterations" | "accuracy_not_reached";
  warnings: { kind: string; message: string }[];
  fields?: Fields;
}

/** An error. `parameter`, `rule` and `value` are null if the error does not concern the value of a parameter. */
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

/** Solve a case on the calling thread; a page should call it in a worker. For invalid input, return an error. */
export function solve(request: Request): Promise<Answer>;

/** The table of scalar results. */
export function scalars(): Promise<Scalar[]>;

/**
 * Make a worker answer the messages `{id, name: "solve", content: request}` and `{id, name: "scalars"}` with
 * `{id, answer}`, or with `{id, failure}` if the module fails.
 */
export function serve(scope?: object): void;

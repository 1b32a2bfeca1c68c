/** Rolling resistance of balls, rollers and wheels with viscoelastic layers. All numbers are in SI units. */

// Written by wasm/make_types.py from the JSON Schema of case files:

export interface Elastic {
  /** Shear modulus G [Pa], > 0. */
  modulus: number;
  type: "elastic";
}

export interface Prony {
  /** Shear modulus G₀ at infinite frequency [Pa], > 0. */
  instantaneous_modulus: number;
  /** Weights g_k [-], each in [0, 1], with a sum of at most 1 apart from round-off. Terms of weight 0 are dropped. */
  weights: number[];
  /** Relaxation times τ_k [s], > 0, as many as `weights`. */
  relaxation_times: number[];
  type: "prony";
}

export interface StandardLinearSolid {
  /** Shear modulus at infinite frequency [Pa], > 0. */
  instantaneous_modulus: number;
  /** Shear modulus at zero frequency [Pa], in [1e-12, 1] times `instantaneous_modulus`. */
  relaxed_modulus: number;
  /** Relaxation time τ of the stress at constant strain [s], > 0. */
  relaxation_time: number;
  type: "standard_linear_solid";
}

export interface CreepCompliance {
  /** Shear compliance J₀ at infinite frequency [1/Pa], > 0. */
  instantaneous_compliance: number;
  /** Compliances J_k of the terms [1/Pa], ≥ 0. */
  compliances: number[];
  /** Retardation times τ_k of the strain at constant stress [s], > 0, as many as `compliances`. */
  retardation_times: number[];
  type: "creep_compliance";
}

export interface LossFactor {
  /** Storage shear modulus at `reference_frequency` [Pa], > 0. */
  modulus: number;
  /** Loss factor η = tan δ [-], in [1e-6, 2]. */
  loss_factor: number;
  /** ω₀ [rad/s], > 0. Choose Ω R/a, with the angular speed Ω, the radius R and the half-width a of the contact. */
  reference_frequency: number;
  /** Decades above and below ω₀ over which the law holds [-], in [0.5, 8]. */
  decades?: number | null;
  /**
   * Compression set of ISO 815, the strain that remains after a compression divided by this compression [-], in (0, 1).
   * A data sheet states it in percent.
   */
  compression_set?: number | null;
  /** Duration of the compression [s], > 0. Required with `compression_set`. */
  compression_time?: number | null;
  /** Time from the release of the compression to the measurement [s], > 0; by default 1800, as in ISO 815. */
  recovery_time?: number | null;
  /**
   * Strain at `creep_time` divided by the strain at `creep_start` under constant stress [-], > 1. Excludes
   * `compression_set`.
   */
  creep_ratio?: number | null;
  /** Time of the last strain of a creep test [s], > `creep_start`. Required with `creep_ratio`. */
  creep_time?: number | null;
  /** Time of the first strain of a creep test [s], > 0. Required with `creep_ratio`. */
  creep_start?: number | null;
  type: "loss_factor";
}

export interface KelvinVoigt {
  /** Relaxed shear modulus G [Pa], > 0. */
  modulus: number;
  /** Shear viscosity η [Pa s], ≥ 0. */
  viscosity: number;
  type: "kelvin_voigt";
}

export interface FractionalZener {
  /** Shear modulus G₀ at infinite frequency [Pa], at least `relaxed_modulus`. */
  instantaneous_modulus: number;
  /** Shear modulus G_∞ at zero frequency [Pa], > 0. */
  relaxed_modulus: number;
  /** Relaxation time τ [s], > 0. */
  relaxation_time: number;
  /** Order α of the derivatives [-], in (0, 1]; 1 gives the standard linear solid. */
  order: number;
  type: "fractional_zener";
}

export interface HavriliakNegami {
  /** Shear modulus G₀ at infinite frequency [Pa], at least `relaxed_modulus`. */
  instantaneous_modulus: number;
  /** Shear modulus G_∞ at zero frequency [Pa], > 0. */
  relaxed_modulus: number;
  /** Relaxation time τ [s], > 0. */
  relaxation_time: number;
  /** Exponent α [-], in (0, 1]. */
  order: number;
  /**
   * Exponent β [-], in (0, 1]; 1 gives the fractional Zener solid, which is the Cole-Cole model; with α = 1, the solid
   * is the Cole-Davidson model.
   */
  asymmetry: number;
  type: "havriliak_negami";
}

export interface MasterCurve {
  /** Angular frequencies [rad/s], ≥ 0, strictly increasing, at least two of them above 0. */
  frequency: number[];
  /** Storage moduli [Pa], > 0, as many as `frequency`. */
  storage: number[];
  /** Loss moduli [Pa], ≥ 0, as many as `frequency`. */
  loss: number[];
  /** Treatment of frequencies outside the table: raise an error, or hold the end values. */
  extrapolation?: "error" | "hold" | null;
  type: "master_curve";
}

export interface Hardness {
  /** Hardness, a number of `scale`. */
  hardness: number;
  /** Scale of Shore. */
  scale?: "A" | "D" | null;
  /** Rebound resilience as a fraction; without it, the material has no loss. */
  rebound?: number | null;
  /**
   * Angular frequency [rad/s] of modulus and loss factor; required with a rebound. A durometer is read after about one
   * second, which is 1 rad/s.
   */
  reference_frequency?: number | null;
  /** Decades of frequency on each side over which the loss factor is constant. */
  decades?: number | null;
  type: "hardness";
}

/** Modulus [Pa] as a function of angular frequency; a number is an elastic modulus. */
export type ShearModulus =
  | number
  | Elastic
  | Prony
  | StandardLinearSolid
  | CreepCompliance
  | LossFactor
  | KelvinVoigt
  | FractionalZener
  | HavriliakNegami
  | MasterCurve
  | Hardness;

export interface HalfSpace {
  shear_modulus: ShearModulus;
  /** Real, constant Poisson's ratio ν in (-1, 0.5]; 0.5 means incompressible. */
  poisson_ratio?: number | null;
  /** Real, constant bulk modulus [Pa], > 0. Poisson's ratio is then complex and depends on frequency. */
  bulk_modulus?: number | null;
  /** Density [kg/m³], ≥ 0; 0 neglects inertia. */
  density?: number | null;
}

export interface Layer {
  /** Thickness [m], > 0, and at least 1e-9 of the radius of the rolling body. */
  thickness: number;
  shear_modulus: ShearModulus;
  /** Real, constant Poisson's ratio ν in (-1, 0.5]; 0.5 means incompressible. */
  poisson_ratio?: number | null;
  /** Real, constant bulk modulus [Pa], > 0. Poisson's ratio is then complex and depends on frequency. */
  bulk_modulus?: number | null;
  /** Density [kg/m³], ≥ 0; 0 neglects inertia. */
  density?: number | null;
  /** Thermal conductivity [W/(m K)], > 0; only temperatures need it. */
  conductivity?: number | null;
}

export interface Ball {
  /** Radius of the core or the cavity [m], > 0. By default 0, which means a solid ball. */
  core_radius?: number | null;
  /** Layers from the center outwards. By default none: a rigid ball, which needs a deformable counterbody. */
  layers?: Layer[] | null;
  /**
   * Inner boundary of the layers: a rigid core (RIGID), a cavity (HOLLOW), or none, with layers that reach the center
   * (SOLID), the default for layers without a core radius. Without a core, the mean rotation of the coating is set to
   * zero, because any other value cannot be distinguished from a rotation of the whole ball.
   */
  inner_boundary?: "rigid" | "hollow" | "solid" | null;
}

export interface Cylinder {
  /** Radius of the core [m], > 0. */
  core_radius: number;
  /** Layers from the core outwards. By default none: a rigid roller. */
  layers?: Layer[] | null;
}

export interface Wheel {
  /** Radius of the hub at the middle of the width [m], > 0. */
  core_radius: number;
  /**
   * Width of the tread from face to face [m], > 0, at most 1000 times the outer radius. With free sides, at least 0.001
   * of the thickness of the layers.
   */
  width: number;
  /** Layers from the hub outwards, with their thickness at the middle. By default none: a rigid wheel. */
  layers?: Layer[] | null;
  /**
   * Radius of the convex tread profile across the path [m], at least half of the width and at most 1e6 times the outer
   * radius, or infinite for a flat tread.
   */
  crown_radius?: number | null;
  /**
   * Hub of a crowned tread. "straight": a cylinder, on which the tread is thinner at the faces. "crowned": a hub that
   * follows the profile, so that the tread has the same thickness everywhere.
   */
  hub?: "straight" | "crowned" | null;
  /**
   * Ends of the tread. "free": faces that bulge, as those of real wheels. "unbounded": no faces; the tread continues
   * beyond the width, where it carries no pressure. This is faster, and correct to 1 % if the contact ends one
   * thickness before the faces. A contact that reaches the faces of a tread three thicknesses wide is a quarter too
   * stiff.
   */
  sides?: "free" | "unbounded" | null;
}

export interface Plane {
  /** Layers from the base outwards. By default none. */
  layers?: Layer[] | null;
  /** Half-space that supports the layers. By default the base is rigid. */
  base?: HalfSpace | null;
}

export interface Groove {
  /**
   * Radius of curvature across the path [m]: positive if concave, then at least 1.02 times the radius of the body;
   * negative if convex. By default straight across, as rollers require.
   */
  radius?: number | null;
  /**
   * Radius of curvature along the path [m], with the same signs and limits, for a dish or the race of a bearing. By
   * default straight along the path.
   */
  path_radius?: number | null;
  /** Layers from the base outwards. By default none: a rigid groove. */
  layers?: Layer[] | null;
  /** Half-space that supports the layers. By default the base is rigid. */
  base?: HalfSpace | null;
}

export interface Drive {
  /**
   * Q, horizontal force on the center, positive forward [N]; its magnitude is less than friction times load. With 0 the
   * torque alone drives the body.
   */
  force?: number | null;
  /** T, driving torque about the rolling axis [N m]. With 0 the body is towed. */
  torque?: number | null;
  /**
   * Driving power at the axle [W]: the driving torque times the angular speed Ω. A negative power brakes the body; with
   * 0 it is towed.
   */
  power?: number | null;
  /** V_s / (Ω r_o) - 1 [-], where V_s is the speed of the center and Ω r_o the rolling speed. */
  creepage?: number | null;
  /** Lateral speed of the center divided by Ω r_o [-]; allowed only with `creepage`. */
  lateral_creepage?: number | null;
  /**
   * Angular speed of the body about the downward axis through the contact, divided by Ω r_o [1/m]; allowed only with
   * `creepage`.
   */
  spin?: number | null;
}

export interface Adhesion {
  /**
   * Work of adhesion w [J/m²], > 0, gained where the surfaces come together. Clean rubber on glass has 0.05 to 0.1.
   */
  work: number;
  /** Attraction at contact [Pa], > 0. */
  strength?: number | null;
  /** Gap at which the attraction ends [m], > 0, instead of `strength`. */
  range?: number | null;
  /**
   * Work to separate the surfaces again [J/m²], ≥ `work`; by default `work`. The difference is dissipated at the
   * trailing edge.
   */
  separation_work?: number | null;
}

/** The table `rolling`: the load case. */
export interface Rolling {
  /**
   * Normal load P [N], > 0; with adhesion it may also be zero or negative. For rollers, load per length [N/m]. Exactly
   * one of `load` and `penetration` must be given.
   */
  load?: number | null;
  /**
   * Penetration r_o - H [m], as for rollers with a fixed gap; the load is then the result `Result.load`. It is the same
   * quantity as `Result.penetration`: radius of the rolling body at rest minus height of its center above the
   * undeformed counterbody. It must be larger than minus `Result.centrifugal_displacement`, which is 0 without density,
   * and smaller than the thickness of the layers of both bodies. In line contact on a half-space it is undetermined and
   * cannot be given. It does not contain thermal expansion: use the radius of the warm body.
   */
  penetration?: number | null;
  /**
   * Angular speed Ω [rad/s], > 0 and below `critical_speed(body)`. On another ball, roller or wheel, the speed relative
   * to the line of centers. Exactly one of `angular_speed` and `speed` must be given.
   */
  angular_speed?: number | null;
  /**
   * Speed V of the ground or belt [m/s], > 0; only without friction. The contact is solved at the angular speed V /
   * r_o, which is `Result.angular_speed`; because the surface is stretched in the contact, the body turns more slowly,
   * at `Result.finite_strain_angular_speed`.
   */
  speed?: number | null;
  /**
   * Coulomb's coefficient of friction μ [-], in [0, 4]. With ``math.inf`` the whole contact sticks; if that would
   * require tension, a `ConvergenceError` is raised.
   */
  friction?: number | null;
  /**
   * Condition that determines the speed of the center. Without friction, where that speed is undetermined, only a force
   * of 0 or a creepage is allowed; torque and force then follow from the power dissipated in each body.
   */
  drive?: Drive | null;
  /**
   * Adhesion of the surfaces of balls and rollers, without friction; by default none. With adhesion there are no
   * results at finite strain and no sensitivities.
   */
  adhesion?: Adhesion | null;
}

/** The table `numerics` of a load case. */
export interface Numerics {
  /** 2π/Δφ in [16, 1 000 000], where Δφ is the spacing along φ. A value of 500 is the paper's Δ = π/250. */
  nodes_per_revolution?: number | null;
  /**
   * Truncation order N_t, as in the paper: the orders |m|, |n| ≤ N_t are summed. It must be at least half of the nodes
   * per revolution, since fewer orders cannot resolve the mesh. By default all orders are summed, at a cost that hardly
   * grows with the mesh.
   */
  max_order?: number | null;
  /** 2π/Δθ, where Δθ is the spacing along θ. By default the spacing is the same as along φ. */
  theta_nodes_per_revolution?: number | null;
  /**
   * Requested relative error [-], in [1e-4, 0.5]; only without `mesh`. The error estimate is the larger of the energy-
   * balance error, with adhesion a tenth of it, and the largest change from the previous mesh of all results that are
   * not given: load, penetration, torques, forces, speed and powers. The largest pressure has an estimate of its own,
   * `Result.max_pressure_error`. The solver refines the mesh further for it, within some seconds; if that does not
   * suffice, it issues a warning.
   */
  accuracy?: number | null;
  /**
   * Compliance in the contact condition: C_RR (RADIAL), pressure along the radius, which is closer to finite strain, or
   * C_WW (VERTICAL), pressure along the normals of the undeformed ball. The difference is of the order of the strain
   * and measures the error of linear theory.
   */
  compliance?: "radial" | "vertical" | null;
  /**
   * Curvature terms in the equations of the layers: the membrane stiffness of a sphere (SPHERE), that of the paper as
   * printed (PAPER), or all terms (EXACT), for thick coatings and for hollow and solid balls.
   */
  curvature?: "sphere" | "paper" | "exact" | null;
  /** Traction on the patch of a node: equation (53) (FLAT) or (38) (SPHERICAL) of the paper. */
  patch_load?: "flat" | "spherical" | null;
  /**
   * Distance that material travels between nodes, with friction: that on the undeformed body (EXACT), or the last form
   * of the paper's (55a) (FLAT), which has no Heathcote slip and serves only for comparison.
   */
  slip_kinematics?: "exact" | "flat" | null;
  /**
   * Whether to compute `Result.finite_strain_torque` and the other results at finite strain. Unless `speed` is given,
   * they need a second solution, at a speed that is higher by `Result.overspeed`.
   */
  finite_strain?: boolean | null;
}

export interface Points {
  /** Distances [m], not decreasing, at least two. Two equal distances are a step. */
  distance: number[];
  /** Height at each distance [m]. */
  height: number[];
  /** Whether the profile repeats. */
  periodic?: boolean | null;
  type: "points";
}

export interface Step {
  /** Height of the ground behind the step [m]. */
  height: number;
  /** Distance of the step [m]. */
  at: number;
  type: "step";
}

export interface HalfSine {
  /** Height of the top [m]. */
  height: number;
  /** Length of the bump [m], positive. */
  length: number;
  /** Distance of the top [m]. */
  at: number;
  type: "half_sine";
}

export interface Joint {
  /** Depth of the joint [m], positive. If it exceeds the penetration, its value has no effect. */
  depth: number;
  /** Width along the track [m], positive. */
  width: number;
  /** Distance of the middle of the joint [m]. */
  at: number;
  type: "joint";
}

export interface Corrugation {
  /** Amplitude [m]. */
  amplitude: number;
  /** Length of a period [m], positive. On a tread, the circumference is a multiple of it. */
  period: number;
  /** Distance at which the height rises through zero [m]. */
  at?: number | null;
  type: "corrugation";
}

export interface Axle {
  /**
   * Mass that moves up and down with the axle [kg], for rollers per length [kg/m], ≥ 0. Steps are then at most a
   * sixtieth of the period in which it vibrates on the contact.
   */
  mass?: number | null;
  /** Stiffness of the spring [N/m], for rollers per length [N/m^2], ≥ 0. */
  stiffness?: number | null;
  /** Force of the damper per speed [N s/m], for rollers per length [N s/m^2], ≥ 0. */
  damping?: number | null;
}

/** The table `motion`: waypoints in lists or in a file, or an oscillation. */
export interface Motion {
  /**
   * Times of the waypoints [s], not decreasing. Two equal times are a jump, which requires a coating with an
   * instantaneous compliance.
   */
  time?: number[] | null;
  /** Angle ψ turned at the waypoints [rad]; the body rolls forward if it increases. */
  angle?: number[] | null;
  /**
   * Distance rolled along the track at the waypoints [m], in place of the angle: r_o ψ, the displacement of the contact
   * without slip.
   */
  distance?: number[] | null;
  /**
   * Normal load P at the waypoints [N], for rollers per length [N/m], ≥ 0, and > 0 at the first one; a number for all
   * waypoints. At 0 the body has lifted off. With an axle, the external force on it. Exactly one of load and
   * `axle_height` is given.
   */
  load?: number | number[] | null;
  /**
   * Height of the axle at the waypoints [m], r_o minus the penetration; the load is then a result. At the first
   * waypoint, the height is smaller than r_o. Not with an axle.
   */
  axle_height?: number | number[] | null;
  /** Amplitude of an oscillation about the start [rad]. */
  amplitude?: number | null;
  /** Frequency of the oscillation [Hz]. */
  frequency?: number | null;
  /** Number of cycles, in (0, 1e4]. */
  cycles?: number | null;
  /**
   * State before the first waypoint: the load has rested on the body until the material has fully relaxed (RELAXED),
   * the load is applied instantaneously (UNDEFORMED), or the state of another history, at a time between the waypoints,
   * from which the motion continues.
   */
  start?: "relaxed" | "undeformed" | null;
  /**
   * Coulomb's coefficient of friction μ between the two bodies [-], in [0, 4]. With friction, a step takes several
   * times as long (docs/theory/transient-friction.md).
   */
  friction?: number | null;
  /** Force on the center [N]; needs friction. */
  driving_force?: number | null;
  /** Torque on the body [N m] instead of a driving force. */
  driving_torque?: number | null;
  /**
   * Displacement of the center at the waypoints [m], starting from 0; requires friction. By default the forces
   * determine it.
   */
  center_displacement?: number[] | null;
  /**
   * Mass that moves with the center [kg], ≥ 0; requires friction and a given force Q on the center. Q minus the force
   * of the contact is mass times acceleration. If Q exceeds friction, the body slides, which is not an error.
   */
  mass?: number | null;
  /** Initial speed of the center, forward [m/s]; used only with a mass. */
  center_speed?: number | null;
}

/** The table `numerics` of a motion. */
export interface HistoryNumerics {
  /** 2π/Δφ in [16, 1 000 000], where Δφ is the spacing along φ. A value of 500 is the paper's Δ = π/250. */
  nodes_per_revolution?: number | null;
  /**
   * Truncation order N_t, as in the paper: the orders |m|, |n| ≤ N_t are summed. It must be at least half of the nodes
   * per revolution, since fewer orders cannot resolve the mesh. By default all orders are summed, at a cost that hardly
   * grows with the mesh.
   */
  max_order?: number | null;
  /** 2π/Δθ, where Δθ is the spacing along θ. By default the spacing is the same as along φ. */
  theta_nodes_per_revolution?: number | null;
  /**
   * Compliance in the contact condition, same as in `viscoroll.solve`; VERTICAL only for a ball on the rigid plane.
   */
  compliance?: "radial" | "vertical" | null;
  /** Curvature terms in the equations of the layers of balls: SPHERE or PAPER. */
  curvature?: "sphere" | "paper" | null;
  /**
   * Number of meshes, each shifted by an equal fraction of the node spacing, over which results are averaged, in [1,
   * 16]. A single mesh is four times as fast, but its torque varies with the position of its nodes.
   */
  averaged_meshes?: number | null;
  /**
   * Number of time steps while the body turns by one node spacing, in [1, 64]; at standstill each step is a tenth
   * longer than the one before. None: one step to each waypoint, and to the end of each `advance`.
   */
  steps_per_spacing?: number | null;
  /**
   * Largest relative error of the compliance due to discrete retardation times [-]. For layers with different
   * relaxation functions, it determines the number of times and therefore the cost of a step.
   */
  spectrum_tolerance?: number | null;
}

/** Height over the distance, of the ground along the track or of the tread around the body. */
export type Profile = Points | Step | HalfSine | Joint | Corrugation;

/** Tables and keys of a case file. */
export interface Case {
  ball?: Ball | null;
  cylinder?: Cylinder | null;
  wheel?: Wheel | null;
  plane?: Plane | null;
  groove?: Groove | null;
  other_ball?: Ball | null;
  other_cylinder?: Cylinder | null;
  other_wheel?: Wheel | null;
  rolling: Rolling;
  numerics?: Numerics | null;
}

/** Tables and keys of a motion file. */
export interface MotionCase {
  ball?: Ball | null;
  cylinder?: Cylinder | null;
  wheel?: Wheel | null;
  plane?: Plane | null;
  groove?: Groove | null;
  other_ball?: Ball | null;
  other_cylinder?: Cylinder | null;
  other_wheel?: Wheel | null;
  numerics?: HistoryNumerics | null;
  motion: Motion;
  ground?: Profile | null;
  tread?: Profile | null;
  axle?: Axle | null;
}

// End of the types that are written by wasm/make_types.py

export interface Request {
  case: Case;
  /** Whether to return fields. */
  fields?: boolean;
}

export interface HistoryRequest {
  case: MotionCase;
}

/** Time series of new instants by the names of `historyScalars()`; null if undetermined. */
export type Series = Record<string, (number | null)[]>;

export interface HistoryResult {
  /** Number of time steps. */
  steps: number;
  nodes_per_revolution: number;
  /** Largest relative error of the compliance due to discrete retardation times [-]. */
  spectrum_error: number;
}

export type HistoryAnswer = { result: HistoryResult; error?: undefined } | { error: Failure; result?: undefined };

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

/** Interval of the allowed values of a number, in an SI unit, which is empty for a pure number. */
export interface Range {
  unit: string;
  /** An end that does not exist is null. */
  minimum: number | null;
  maximum: number | null;
  excludes_minimum: boolean;
  excludes_maximum: boolean;
}

/** An error. `parameter`, `rule`, `value` and `allowed` are null if the error does not concern the value of a parameter. */
export interface Failure {
  message: string;
  /** Path in the case, such as "ball.layers[0].thickness". */
  parameter: string | null;
  /** Rule that the value violates, with range and unit, such as "must be > 0 m". */
  rule: string | null;
  value: string | null;
  /** Range that the value leaves; null if the rule is not a range. */
  allowed: Range | null;
}

export type Answer = { result: Result; error?: undefined } | { error: Failure; result?: undefined };

export interface Scalar {
  name: string;
  unit: string;
  description: string;
  /** Part of a report: "answer", "friction" (of the answer, with friction), "certainty" or "other". */
  group: string;
  /** Names of the relative error estimates whose sum limits the digits; "%" for a ratio displayed in percent. */
  precision: string;
}

/** Solve a case on the calling thread; a page should call it in a worker. For invalid input, return an error. */
export function solve(request: Request): Promise<Answer>;

/**
 * Compute a history on the calling thread. `each` receives the first instant, and then every few steps the new instants.
 * To stop a history, end the worker that computes it.
 */
export function roll(request: HistoryRequest, each?: (series: Series) => void): Promise<HistoryAnswer>;

/** The table of scalar results. */
export function scalars(): Promise<Scalar[]>;

/** The table of the time series of histories. */
export function historyScalars(): Promise<{ name: string; unit: string; description: string }[]>;

/**
 * Make a worker answer the messages `{id, name: "solve", content: request}`, `{id, name: "roll", content: request}`,
 * `{id, name: "scalars"}` and `{id, name: "historyScalars"}` with `{id, answer}`, or with `{id, failure}` if the module
 * fails. While it computes a history, it sends the messages `{id, part}` with the new instants.
 */
export function serve(scope?: object): void;

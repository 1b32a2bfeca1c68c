/// @file
/// @brief Parameters of the search for states of stick and slip, each with its purpose or the cases that determined it.
#pragma once

namespace viscoroll::detail {

/// @brief Parameters of the Newton steps at a given friction and of the starting points. A residual is the norm of the
/// violations of all conditions, as forces, per load.
/// "Tried" compares half and twice a value, or the given values, on 972 cases of the friction grid and 70 randomized
/// tests; every case found a state.
struct FrictionSettings {
  // Convergence of a state

  /// Residual of a state. It is multiplied by the coefficient of friction, but not if that is above 1; the product is
  /// at least the tolerance of the contact.
  double tolerance = 1e-10;
  /// Lower bound of that factor, since the load itself is accurate to 1e-14.
  double least_friction = 0.01;
  /// Residual, with the same factor, at which a state is accepted if steps no longer halve the residual. Without the
  /// coefficient of friction as a factor, sticking nodes kept 2 % of the fastest slip at a coefficient of 0.0048.
  double round_off = 1e-8;
  /// Slip of sticking nodes relative to the range of the increments of displacement in the contact. It is a fifth of
  /// the tolerance of the randomized tests. On meshes of a million nodes the residual alone left 1e-4.
  double max_slip_of_sticking_nodes = 2e-7;
  /// Largest number of further steps that reduce this slip.
  int max_slip_reduction_steps = 3;

  /// Residual at one instant of a motion, which direct solutions reach; its errors carry over to later instants.
  double instant_tolerance = 1e-12;
  /// Residual at which an instant is accepted if steps no longer halve the residual.
  double instant_round_off = 1e-10;

  // Failure of an iteration

  /// Residual at which an iteration stops as diverged, relative to that of the start if that is above 1. The limit is
  /// large because, at a small load, forces of nodes at a start may be far above the load; one step corrects them.
  double divergence_residual = 1e3;
  /// Steps of an iteration: two or three times the number that usually leads from full stick to a state. Only 4 of
  /// 1e4 states needed more.
  int steps = 25;
  /// Largest number of steps of an iteration that continues because its residual halves within `halving` steps.
  int max_steps = 60;
  /// Number of steps within which the residual must halve for an iteration to continue. Tried: half costs 1 % in
  /// operator applications, twice makes no difference.
  int halving = 12;
  /// Largest number of floating-point operations in the operator applications of a search (some seconds).
  double max_operations = 1e10;
  /// Number of operator applications up to which a search may exceed `max_operations`: eight times that of most states.
  double operator_applications = 800;
  /// Largest factor by which a search may exceed `max_operations`.
  double excess_factor = 4.0;

  // Newton steps

  /// First steps of an iteration. The solver does not shorten them if they increase the residual, because the sets
  /// still change. Tried: with half as many, the longest path took 38 steps instead of 20; with twice as many, 22.
  /// Operator applications agree to 1 %.
  int full_steps = 8;
  /// Number of such steps from the state of a coarser mesh, whose sets are nearly correct.
  int full_steps_nearby = 3;
  /// Ratio of the residual to the least residual above which, after the full steps, the search returns to the state
  /// with the least residual. Without this, 79 cases of the friction grid, all at friction of at most 0.01, took 72
  /// steps on average instead of 23.
  double max_residual_growth = 2.0;
  /// Shortest fraction of a step; shorter ones do not end cycles of nodes either. Tried: 0.25 costs 30 % more operator
  /// applications, 0.01 makes no difference.
  double shortest_step = 0.05;
  /// Largest creepage [-]. Beyond it, the forces of a body that slides as a whole hardly change and steps diverge.
  double max_creepage = 1.0;
  /// Relative residual of a step with an iterative linear solver. Greater accuracy does not pay while the sets change;
  /// steps after the full ones use a tenth of it. Tried: 1e-3 to 0.1 agree within 6 % of the operator applications.
  /// With accurate steps only, contacts of up to 300 nodes took a fifth fewer steps but a fifth to a third more
  /// operator applications (657 randomized tests and 972 cases of the grid, each with a state).
  double rough_step = 1e-2;
  /// Relative residual of an accurate step. From 10 coarser meshes from which rough steps failed, accurate ones
  /// succeeded 8 times.
  double exact_step = 1e-6;

  // Starting points

  /// Traction per friction limit above which a node is assumed to slip as at the previous instant: a traction
  /// interpolated between two rows is below the limit.
  double likely_slip = 0.97;

  /// Steps towards full stick, as a starting point; further ones move nodes with tension back and forth. Tried: half
  /// costs 5 % less, twice 10 to 25 % more.
  int steps_of_full_stick = 6;
  /// Steps from a coarser mesh after which the residual must have halved.
  int patience_nearby = 8;
  /// Steps from a state interpolated between two creepages after which the residual must have halved. Tried: neither
  /// limit makes a difference, since both only end iterations that fail.
  int patience_between = 14;
  /// Coefficient of friction at which the path over coefficients starts. From it, the search found a state with given
  /// creepage at a coefficient of 4, where no other start succeeded.
  double easy_friction = 0.3;
  /// Shortest step of that path, as a fraction of its logarithmic length. It is reached after seven halvings and ends
  /// the search. Tried: 0.1 makes no difference.
  double shortest_stride = 0.01;
  /// Creepage above which the search steps in the logarithm of the creepage, and below which in the creepage [-].
  double small_creepage = 1e-5;
  /// Halvings of the interval of creepages, to a millionth of it.
  int halvings = 20;
};

inline constexpr FrictionSettings kFrictionSettings{};

}  // namespace viscoroll::detail

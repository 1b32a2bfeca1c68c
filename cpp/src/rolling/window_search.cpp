#include "rolling/window_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/adhesive_contact.hpp"
#include "contact/multilevel.hpp"
#include "rolling/input_checks.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// Overclosure outside the box of a contact, relative to the penetration, above which the contact extends beyond the
/// box.
constexpr double kOverclosure = 1e-8;

constexpr double kMarginOfEstimate = 1.1;  // of windows around an estimated contact; the estimate is rather too large
constexpr double kMarginOfCoarseContact = 1.2;  // of windows around a contact that was found on a coarser mesh

constexpr double kRoundOff = 1e-9;  // [nodes], of the extent of a contact that ends at nodes of a coarser mesh

constexpr int kRoughNodes = 16;  // from the lowest node to the edge of a window, on a mesh that shows its size

constexpr double kPressedThrough = 10.0;  // depth, in thicknesses, that no coating can support

constexpr Eigen::Index kFewNodes = 1024;    // enough to show whether a window contains a contact
constexpr Eigen::Index kManyNodes = 16384;  // enough to show whether a contact extends far beyond a window
// Fraction of a side that is in contact. A circle a twentieth larger than the window has this fraction.
constexpr double kOverrun = 1.0 / 3.0;

/// Nodes to either side of the lowest one.
struct HalfWidths {
  int phi;
  int theta;

  [[nodiscard]] Window window() const { return {{-phi, phi}, {-theta, theta}}; }
};

/// Smallest gap of the nodes outside a box.
double least_gap_outside(const Window& box, const Eigen::ArrayXd& gap, const Window& window) {
  const Eigen::Index columns = window.theta.count();
  const Eigen::Index left = box.theta.first - window.theta.first;
  const Eigen::Index right = window.theta.last - box.theta.last;
  double least = 0.0;  // gap of nodes in contact
  for (int i = window.phi.first; i <= window.phi.last; ++i) {
    const auto row = gap.segment(static_cast<Eigen::Index>(i - window.phi.first) * columns, columns);
    const bool beside = i < box.phi.first || i > box.phi.last;
    if (beside) least = std::min(least, row.minCoeff());
    if (left > 0) least = std::min(least, row.head(left).minCoeff());
    if (right > 0) least = std::min(least, row.tail(right).minCoeff());
  }
  return least;
}

/// Solve the contact without friction within a window, which may cut it off.
/// @param[in] max_nodes the mesh is coarsened to at most this number of nodes
LocatedContact press(const ContactSetup& setup, ContactProblem problem, Eigen::Index max_nodes) {
  problem.friction.reset();
  while (problem.initial_gap.size() > max_nodes) problem = coarsened(problem);
  LocatedContact pressed = solve_multilevel(problem, setup.contact_gap_limit(), setup.limits);
  pressed.contact = extended(pressed, problem);
  pressed.problem = std::move(problem);
  return pressed;
}

/// Whether a large part of one side of the window lies within the contact. A mesh that is too coarse to show which
/// nodes at the rim touch is fine enough to show that the contact extends far beyond the window.
bool is_cut_off(const LocatedContact& pressed) {
  const WindowShape shape = pressed.window().shape();
  Eigen::Array4d touching = Eigen::Array4d::Zero();
  for (const Eigen::Index node : pressed.contact.contact) {
    const Eigen::Index row = node / shape.theta_nodes;
    const Eigen::Index column = node % shape.theta_nodes;
    touching += Eigen::Array4d(row == 0, row == shape.phi_nodes - 1, column == 0, column == shape.theta_nodes - 1);
  }
  const bool goes_on = !pressed.window().is_line() && !pressed.problem.ends_at_sides;
  const double along = touching.head<2>().maxCoeff() / static_cast<double>(shape.theta_nodes);
  const double across = goes_on ? touching.tail<2>().maxCoeff() / static_cast<double>(shape.phi_nodes) : 0.0;
  return std::max(along, across) > kOverrun;
}

/// Whether a window contains the contact without friction, which is tested before stick and slip are computed. Loads
/// that press through to the core are rejected.
bool holds_pressed_contact(const ContactSetup& setup, const ContactProblem& problem, bool is_widest) {
  const auto holds = [&](const LocatedContact& pressed) {
    if (touches_edge(pressed, pressed.window())) return false;
    require_contact(setup, 0.0, pressed.contact.penetration);
    return true;
  };
  const Eigen::Index nodes = problem.initial_gap.size();
  if (holds(press(setup, problem, kFewNodes))) return true;
  if (!is_widest || (nodes > kManyNodes && is_cut_off(press(setup, problem, kManyNodes)))) return false;
  return nodes > kFewNodes && holds(press(setup, problem, nodes));
}

LocatedContact solve_contact(const ContactSetup& setup, const ContactProblem& problem) {
  try {
    return solve_multilevel(problem, setup.contact_gap_limit(), setup.limits);
  } catch (const LiftsOff& tension) {
    reject_tension(setup, tension.load(), tension.penetration());
  } catch (const ConvergenceError&) {
    require_reachable_drive(setup, problem);
    throw;
  }
}

/// @param[in] is_widest whether there is no wider window
/// @param[in] is_seen whether a coarser mesh has shown that the window contains the contact without friction
/// @return nothing if the contact reaches the edge of the window
std::optional<WindowContact> solve_in_window(const ContactSetup& setup, const Window& window, bool is_widest,
                                             bool is_seen) {
  require_node_limit(window, setup.model.mesh);
  const SurfaceWindow nodes(setup.nodes.grid, window);
  ContactProblem problem = setup.problem(nodes);
  const bool is_known = is_seen || (problem.friction && problem.friction->shared->pressed());
  if (!is_known && problem.friction && !holds_pressed_contact(setup, problem, is_widest)) return std::nullopt;
  LocatedContact located = solve_contact(setup, problem);
  for (;;) {
    if (touches_edge(located, window)) return std::nullopt;
    const bool boxed = located.window() != window;
    const bool at_edge = touches_edge(located, located.window());
    ContactSolution whole = extended(located, problem);
    const bool overclosed = least_gap_outside(located.window(), whole.gap, window) < -kOverclosure * whole.penetration;
    if (!boxed || !(at_edge || overclosed)) {
      const Losses losses =
          setup.model.has_losses ? located.problem.surface->dissipation(located.contact.force) : Losses{};
      require_contact(setup, setup.load_case.friction, whole.penetration);
      return WindowContact{
          .nodes = nodes, .problem = std::move(problem), .contact = std::move(whole), .losses = losses};
    }
    // The box that was expected to contain the contact does not.
    located = solve_on_window(problem, whole, setup.limits);
  }
}

/// Whether a window contains the contact without friction, on a mesh with kRoughNodes nodes to each side of the window.
/// @param[in] simplified whether to use the radial compliance, flat patches, and the torus in place of the exact sphere
bool holds_contact_roughly(const ContactSetup& setup, const HalfWidths& half, bool simplified) {
  const double coarsening = static_cast<double>(half.phi) / kRoughNodes;
  const auto coarsened = [coarsening](int nodes) { return static_cast<int>(nodes / coarsening); };
  const Mesh& fine = setup.model.mesh;
  const Mesh mesh{.nodes_per_revolution = coarsened(fine.nodes_per_revolution),
                  .theta_nodes_per_revolution = coarsened(theta_nodes_per_revolution(fine))};
  Options options = setup.options;
  Curvature curvature = setup.model.curvature;
  if (simplified) {
    options.compliance = Compliance::radial;
    options.patch_load = PatchLoad::flat;
    if (curvature == Curvature::exact) curvature = Curvature::sphere;
  }
  const MeshModel rough = make_model(setup.pair, mesh, curvature, setup.execution, {.has_losses = false});
  LoadCase pressed = setup.load_case;
  pressed.friction = 0.0;
  pressed.drive = {};
  if (pressed.adhesion) {
    pressed.adhesion.reset();
    pressed.pulls_off = false;
    pressed.penetration.reset();
    pressed.load = setup.equivalent_load;
  }
  const ContactSetup roughly = assemble(rough, with_same_estimate(setup, setup.pair, pressed, options));
  const int to_side = setup.has_sides() ? roughly.nodes.widest.theta.last : std::numeric_limits<int>::max();
  const HalfWidths width{.phi = coarsened(half.phi) + 1, .theta = std::min(coarsened(half.theta) + 1, to_side)};
  return solve_in_window(roughly, width.window(), false, true).has_value();
}

/// Whether a window contains the contact according to a much coarser mesh. For absurd loads, or loads far beyond the
/// estimate, fine meshes on one window after another would take long.
bool holds_rough_contact(const ContactSetup& setup, const HalfWidths& half, bool is_widest) {
  if (half.phi < 3 * kRoughNodes) return true;
  const SurfaceGrid& grid = setup.nodes.grid;
  const bool to_sides = setup.has_sides() && half.theta == setup.nodes.widest.theta.last;
  const double along = half.phi * grid.phi_spacing;
  const double angle = to_sides ? along : std::min(along, half.theta * grid.theta_spacing);
  const double depth_at_edge = grid.radius * (1.0 - std::cos(angle));
  const double bearable_depth = kPressedThrough * thickness(setup.pair);
  const auto reject_if_beyond = [&](double depth) {
    if (depth > bearable_depth) reject_load(setup.pair, setup.load_case, "would be pressed through it");
  };
  // The simplified equations may require a larger window than the given ones, which costs little. In the widest window
  // they might reject a load that the given equations support, so that the given ones decide.
  const bool is_decisive = is_widest && depth_at_edge <= bearable_depth;
  try {
    if (holds_contact_roughly(setup, half, !is_decisive)) return true;
  } catch (const ConvergenceError&) {
    reject_if_beyond(setup.estimated_depth);  // estimates are too large, but not by such a factor
    throw;
  }
  reject_if_beyond(depth_at_edge);
  return false;
}

}  // namespace

WindowContact find_contact_in_window(const ContactSetup& setup, const std::optional<ContactReach>& coarse_contact) {
  const SurfaceGrid& grid = setup.nodes.grid;
  const ContactReach likely = coarse_contact.value_or(setup.contact);
  const double margin = coarse_contact ? kMarginOfCoarseContact : kMarginOfEstimate;
  const auto half_width = [&](double reach, double spacing) {
    return static_cast<int>(std::ceil(margin * reach / (grid.radius * spacing) - kRoundOff)) + 2;
  };
  const Window& widest = setup.nodes.widest;
  const auto at_most_widest = [&widest](int phi, int theta) {
    return HalfWidths{.phi = std::min(phi, widest.phi.last), .theta = std::min(theta, widest.theta.last)};
  };
  HalfWidths half =
      at_most_widest(half_width(likely.along, grid.phi_spacing), half_width(likely.across, grid.theta_spacing));
  const bool is_shallow = setup.estimated_depth < 0.5 * thickness(setup.pair);
  const bool is_cheap = widest.is_line();
  bool is_seen = coarse_contact.has_value();
  for (bool is_likely = is_cheap || is_shallow || is_seen;; is_likely = is_cheap) {
    const Window window = half.window();
    const bool is_widest = window == widest;
    if (is_likely || holds_rough_contact(setup, half, is_widest)) {
      if (auto solved = solve_in_window(setup, window, is_widest, is_seen)) return *std::move(solved);
    }
    is_seen = false;
    if (is_widest) {
      reject_contact_over_60_degrees(setup.pair, setup.load_case);
    }
    half = at_most_widest(half.phi + half.phi / 2 + 1, half.theta + half.theta / 2 + 1);
  }
}

}  // namespace viscoroll::detail

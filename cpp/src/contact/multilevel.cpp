#include "contact/multilevel.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr Index kSmallWindow = 4096;            // nodes
constexpr Index kSmallFrictionalWindow = 2500;  // where forces along the plane come on top
constexpr double kCoarseTolerance = 1e-4;       // of a contact that is to be interpolated

ContactOptions rough(ContactOptions options) {
  options.tolerance = kCoarseTolerance;
  return options;
}

/// Nodes within a distance of the lowest point, itself included, and no forces.
NormalContactGuess guess_within(const SurfaceWindow& window, double distance) {
  NormalContactGuess guess{.contact = {}, .pressing = ArrayXd::Zero(window.shape().size()), .penetration = 0.0};
  for (Index node = 0; node < window.shape().size(); ++node) {
    const bool lowest = window.height()[node] == 0.0;
    if (lowest || std::hypot(window.x()[node], window.z()[node]) <= distance) guess.contact.push_back(node);
  }
  return guess;
}

NormalContactGuess prolonged_guess(const LocatedContact& coarse, const SurfaceWindow& fine) {
  return {.contact = prolonged_contact(coarse, fine),
          .pressing = -prolonged_force(coarse, fine).col(kDown),
          .penetration = coarse.contact.penetration};
}

/// The state of a contact as a guess on a window that encloses its own.
NormalContactGuess guess_from(const LocatedContact& located, const SurfaceWindow& window) {
  NormalContactGuess guess{
      .contact = {}, .pressing = ArrayXd::Zero(window.shape().size()), .penetration = located.contact.penetration};
  const ArrayXd pressing = pressing_force(located.contact);
  for (const Index node : located.contact.contact) {
    guess.contact.push_back(window.number_of(located.window, node));
    guess.pressing[guess.contact.back()] = pressing[node];
  }
  return guess;
}

LocatedContact solve_on(const SurfaceWindow& window, const CandidateSurface& surface, double load,
                        const NormalContactGuess& guess, const ContactOptions& options, const Execution& execution) {
  CoatingCompliance coating(surface.formulation, window, surface.tables, execution);
  const NormalContactProblem problem{.coating = coating, .drop = drop(surface, window), .load = load};
  ContactSolution contact = solve_normal_contact(problem, guess, options);
  return {.window = window, .coating = std::move(coating), .contact = std::move(contact)};
}

FrictionalContactProblem frictional_problem(const LocatedContact& at, const CandidateSurface& surface,
                                            const FrictionalLoad& load) {
  const SurfaceWindow& window = at.window;
  const WindowShape shape = window.shape();
  const double step = window.grid().radius * window.grid().phi_spacing;
  ArrayXd ways = ArrayXd::Constant(shape.size(), -step);
  if (load.slip_kinematics == SlipKinematics::exact) {
    const Index rest = shape.size() - shape.theta_nodes;
    ways.tail(rest) = surface.swelling * (window.x().tail(rest) - window.x().head(rest));
  }
  const bool vertical = surface.formulation.compliance == Compliance::vertical;
  return {.normal = {.coating = at.coating, .drop = drop(surface, window), .load = load.load_case.load},
          .shape = shape,
          .x = surface.swelling * window.x(),
          .y = surface.swelling * window.y(),
          .ways = std::move(ways),
          .step = step,
          .friction = load.load_case.friction,
          .drive = load.load_case.drive,
          .lever_arm = vertical ? LeverArm::displaced : LeverArm::undisplaced};
}

/// Refuse a driving torque that is out of reach of the moments of a sphere that slides as a whole.
void require_rolling(FrictionalContactProblem problem, const ContactSolution& frictionless,
                     const ContactOptions& options) {
  const double torque = std::get<DriveTorque>(problem.drive).torque;
  std::array<double, 2> limits{};
  for (const std::size_t side : {0, 1}) {
    problem.drive = DriveCreepage{.creepage = side == 0 ? 1.0 : -1.0};
    limits[side] = contact_moment(problem, solve_frictional_contact(problem, frictionless, options));
  }
  if (torque > limits[0] && torque < limits[1]) return;
  reject("drive.torque",
         "between " + text(limits[0]) + " N m and " + text(limits[1]) + " N m, else the sphere slides without end",
         text(torque) + " N m");
}

/// A contact with friction from that of every other node, in a box around it that grows where it has to.
LocatedContact refine(const LocatedContact& coarse, const CandidateSurface& surface, const FrictionalLoad& load,
                      const ContactOptions& options, const Execution& execution) {
  const SurfaceWindow box = box_around(coarse, 2, surface.window);
  ContactSolution start{.force = prolonged_force(coarse, box), .penetration = coarse.contact.penetration};
  start.speed_ratio = coarse.contact.speed_ratio;
  return add_friction({.window = box,
                       .coating = CoatingCompliance(surface.formulation, box, surface.tables, execution),
                       .contact = std::move(start)},
                      surface, load, options);
}

}  // namespace

LocatedContact solve_multilevel(const CandidateSurface& surface, double load, double estimate,
                                const ContactOptions& options, const Execution& execution) {
  if (surface.window.shape().size() <= kSmallWindow) {
    return solve_on(surface.window, surface, load, guess_within(surface.window, 0.8 * estimate), options, execution);
  }
  const LocatedContact coarse = solve_multilevel(coarsened(surface), load, estimate, rough(options), execution);
  SurfaceWindow box = box_around(coarse, 2, surface.window);
  NormalContactGuess guess = prolonged_guess(coarse, box);
  for (;;) {
    LocatedContact located = solve_on(box, surface, load, guess, options, execution);
    const bool whole = box.covers_same(surface.window);
    if (whole || !touches_edge(located.contact, box.shape())) return located;
    box = box_around(located, 1, surface.window);
    guess = guess_from(located, box);
  }
}

LocatedContact solve_on_window(const ContactSolution& start, const CandidateSurface& surface, double load,
                               const ContactOptions& options, const Execution& execution) {
  const NormalContactGuess guess{
      .contact = start.contact, .pressing = pressing_force(start), .penetration = start.penetration};
  return solve_on(surface.window, surface, load, guess, options, execution);
}

LocatedContact add_friction(LocatedContact start, const CandidateSurface& surface, const FrictionalLoad& load,
                            const ContactOptions& options) {
  const FrictionalContactProblem problem = frictional_problem(start, surface, load);
  try {
    start.contact = solve_frictional_contact(problem, start.contact, options);
  } catch (const ConvergenceError&) {
    if (std::holds_alternative<DriveTorque>(problem.drive)) require_rolling(problem, start.contact, options);
    throw;
  }
  return start;
}

LocatedContact solve_multilevel(const CandidateSurface& surface, const FrictionalLoad& load, double estimate,
                                const ContactOptions& options, const Execution& execution) {
  if (surface.window.shape().size() > kSmallFrictionalWindow) {
    try {
      const LocatedContact coarse = solve_multilevel(coarsened(surface), load, estimate, rough(options), execution);
      return refine(coarse, surface, load, options, execution);
    } catch (const ConvergenceError&) {
      // From the frictionless contact then, by way of full stick.
    }
  }
  return add_friction(solve_multilevel(surface, load.load_case.load, estimate, options, execution), surface, load,
                      options);
}

}  // namespace viscoroll::detail

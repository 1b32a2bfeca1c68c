#include "contact/multilevel.hpp"

#include <algorithm>
#include <utility>

#include "contact/frictional_contact.hpp"
#include "contact/normal_contact.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Number of nodes up to which a window is solved as a whole, not in a box around the contact.
constexpr Index kSmallWindow = 4096;
// Number of nodes up to which a coarser mesh does not save time: 200 speeds by 10 loads took the same time with limits
// from 600 to 1200 nodes, and an eighth more with a limit of 4096.
constexpr Index kFewNodes = 600;
constexpr int kMinNodesPerDirection = 16;       // with fewer, the coarse mesh would have fewer than 8
constexpr Index kSmallFrictionalWindow = 2500;  // number of nodes up to which friction needs no coarser mesh
constexpr double kCoarseTolerance = 1e-4;       // residual on a mesh that only supplies a start
// Tangential forces may be a small part of the load, and the errors of the levels add up.
constexpr double kCoarseFrictionalTolerance = 1e-6;
constexpr double kCoarseUnsettled = 0.001;  // fraction of the coarse mesh's nodes that may still leave or join
// The same for periodic surfaces, most of whose nodes are at edges that the finer mesh moves. With the fraction above,
// the finest mesh takes up to a sixth more operator applications (python bench/rough.py 1024 --speed 1e-3).
constexpr double kCoarsePeriodicUnsettled = 0.01;

ContactOptions rough(ContactOptions options) {
  options.tolerance = kCoarseTolerance;
  options.unsettled = kCoarseUnsettled;
  options.is_start = true;
  return options;
}

/// Return a guess without forces that contains the nodes up to a depth, and at least the lowest ones. At a given
/// penetration, the guess contains the overlapping nodes instead: no load keeps a larger set pressed, and an
/// incompressible layer, which keeps its volume, would be in tension everywhere.
NormalContactGuess guess_within(const ContactProblem& problem, double depth) {
  depth = problem.penetration.value_or(depth);
  const ArrayXd& initial_gap = problem.initial_gap;
  NormalContactGuess guess{.contact = {}, .pressing = ArrayXd::Zero(initial_gap.size()), .penetration = 0.0};
  const double deepest = initial_gap.minCoeff();
  for (Index node = 0; node < initial_gap.size(); ++node) {
    if (initial_gap[node] <= std::max(depth, deepest)) guess.contact.push_back(node);
  }
  return guess;
}

NormalContactGuess prolonged_guess(const LocatedContact& coarse, const Window& fine) {
  return {.contact = prolonged_contact(coarse, fine),
          .pressing = prolonged_pressing(coarse, fine),
          .penetration = coarse.contact.penetration};
}

/// Return the state of a contact as a guess on a window that contains its own.
NormalContactGuess guess_from(const LocatedContact& located, const Window& window) {
  NormalContactGuess guess{
      .contact = {}, .pressing = ArrayXd::Zero(window.shape().size()), .penetration = located.contact.penetration};
  for (const Index node : located.contact.contact) {
    guess.contact.push_back(window.number_of(located.window(), node));
    guess.pressing[guess.contact.back()] = -located.contact.force(node, kDown);
  }
  return guess;
}

/// Smallest box that contains two boxes.
Window joined(const Window& one, const Window& other) {
  const auto join = [](const NodeRange& a, const NodeRange& b) {
    return NodeRange{std::min(a.first, b.first), std::max(a.last, b.last)};
  };
  return {join(one.phi, other.phi), join(one.theta, other.theta)};
}

/// Whether the window has enough nodes in both directions for a start from every other node to pay.
bool is_worth_coarsening(const Window& window) {
  const auto [rows, columns] = window.shape();
  return window.shape().size() > kFewNodes && rows >= kMinNodesPerDirection &&
         (window.is_line() || columns >= kMinNodesPerDirection);
}

LocatedContact press(ContactProblem problem, const NormalContactGuess& guess, const ContactOptions& options) {
  ContactSolution contact = solve_normal_contact(problem, guess, options);
  return {.problem = std::move(problem), .contact = std::move(contact)};
}

LocatedContact press_multilevel(const ContactProblem& problem, double contact_gap_limit,
                                const ContactOptions& options) {
  const Window& window = problem.surface->window();
  if (!is_worth_coarsening(window)) return press(problem, guess_within(problem, contact_gap_limit), options);
  ContactOptions start = rough(options);
  if (problem.surface->period()) start.unsettled = kCoarsePeriodicUnsettled;
  const LocatedContact coarse = press_multilevel(coarsened(problem), contact_gap_limit, start);
  // The contacts of a periodic surface are everywhere.
  const bool is_whole = window.shape().size() <= kSmallWindow || problem.surface->period();
  if (is_whole) return press(problem, prolonged_guess(coarse, window), options);
  Window box = box_around(coarse, 2, window);
  NormalContactGuess guess = prolonged_guess(coarse, box);
  for (;;) {
    LocatedContact located = press(within(problem, box), guess, options);
    const Window wider = joined(box, box_around(located, 1, window));
    if (wider == box || !touches_edge(located, box)) return located;
    box = wider;
    guess = guess_from(located, box);
  }
}

/// Return the frictionless contact, which another solution may have found already.
LocatedContact pressed(const ContactProblem& problem, double contact_gap_limit, const ContactOptions& options) {
  const auto& shared = problem.friction->shared;
  // A small window is solved as a whole, so the contact is on the window itself.
  const bool is_shared = shared && problem.initial_gap.size() <= kSmallFrictionalWindow;
  if (is_shared) {
    if (const auto kept = shared->pressed()) return {.problem = problem, .contact = *kept};
  }
  LocatedContact located = press_multilevel(problem, contact_gap_limit, options);
  if (is_shared) shared->keep(located.contact);
  return located;
}

/// Add friction on the window of `start`, a frictionless contact or a state with friction.
LocatedContact add_friction(LocatedContact start, const ContactOptions& options) {
  scale_by(start.contact, start.problem);
  start.contact = solve_frictional_contact(start.problem, start.contact, options);
  return start;
}

/// Solve a contact with friction, starting from that of every other node, in a box around it.
LocatedContact refine(const LocatedContact& coarse, const ContactProblem& problem, const ContactOptions& options) {
  const Window box = box_around(coarse, 2, problem.surface->window());
  ContactProblem inside = within(problem, box);
  ContactSolution start = prolonged(coarse, inside);
  return add_friction({.problem = std::move(inside), .contact = std::move(start)}, options);
}

}  // namespace

LocatedContact solve_multilevel(const ContactProblem& problem, double contact_gap_limit,
                                const ContactOptions& options) {
  if (!problem.friction) return press_multilevel(problem, contact_gap_limit, options);
  const auto from_full_stick = [&] { return add_friction(pressed(problem, contact_gap_limit, options), options); };
  if (problem.initial_gap.size() <= kSmallFrictionalWindow) return from_full_stick();
  const ContactProblem coarse = coarsened(problem);
  const auto from_coarse = [&] {
    ContactOptions settled = rough(options);
    settled.tolerance = kCoarseFrictionalTolerance;
    return refine(solve_multilevel(coarse, contact_gap_limit, settled), problem, options);
  };
  // A problem that failed on two meshes is not tried on finer ones.
  if (coarse.initial_gap.size() > kSmallFrictionalWindow) return from_coarse();
  try {
    return from_coarse();
  } catch (const ConvergenceError&) {
    return from_full_stick();
  }
}

LocatedContact solve_on_window(const ContactProblem& problem, const ContactSolution& start,
                               const ContactOptions& options) {
  if (problem.friction) return add_friction({.problem = problem, .contact = start}, options);
  return press(problem, {.contact = start.contact, .pressing = pressing_force(start), .penetration = start.penetration},
               options);
}

}  // namespace viscoroll::detail

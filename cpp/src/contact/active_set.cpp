#include "contact/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Stiffness of the prediction, relative to that of a node. A small value predicts too many nodes rather than too few:
/// superfluous nodes leave in every pass, but after the first passes nodes join only if none leaves.
constexpr double kPredictionStiffness = 0.3;
constexpr double kOverclosureFactor = 10.0;  // overclosure that counts as such, relative to the tolerance
/// If at most this fraction of the nodes changes, the next pass has the final tolerance. Windows of 1024 and 2048 nodes
/// per side (`fine_rolling` of bench_solve) take 24 and 25 operator applications with a fraction of 0, 22 and 25 with
/// 1e-5, 22 and 23 with 1e-4, 26 and 28 with 1e-3.
constexpr double kFewChanges = 1e-4;
constexpr int kExchanges = 8;  // passes in which nodes may leave and join at once

void find_gap(PressedSurface& surface, PressedNodes& contact) {
  contact.gap = surface.height(contact) - *contact.penetration * surface.weights();
  contact.is_gap_current = true;
}

/// Predict the nodes in contact from the forces of the guess and the gaps under these forces.
void predict_nodes(PressedSurface& surface, PressedNodes& contact) {
  const ArrayXd height = surface.height(contact);
  if (!contact.penetration) {
    contact.penetration = (height * contact.pressing).sum() / (surface.weights() * contact.pressing).sum();
  }
  const ArrayXd gap = height - *contact.penetration * surface.weights();
  const ArrayXd predicted = contact.pressing - kPredictionStiffness * surface.stiffness() * gap;
  std::vector<Index> nodes;
  for (Index node = 0; node < predicted.size(); ++node) {
    if (predicted[node] > 0.0) nodes.push_back(node);
  }
  contact.pressing = (predicted > 0.0).select(contact.pressing, 0.0);
  if (!nodes.empty()) contact.nodes = std::move(nodes);
}

/// @param[in] slack tension below which a node that leaves does not count [N]
/// @return number of nodes that left
std::size_t drop_tensile(PressedNodes& contact, double slack) {
  const auto is_tensile = [&](Index node) { return !(contact.pressing[node] > 0.0); };
  std::size_t counted = 0;
  for (const Index node : contact.nodes) {
    if (!is_tensile(node)) continue;
    if (!(contact.pressing[node] > -slack)) ++counted;
    contact.pressing[node] = 0.0;
    contact.is_gap_current = false;
  }
  std::erase_if(contact.nodes, is_tensile);
  return counted;
}

/// Add the overclosed nodes. Nodes that are in contact or have just left have no gap yet and are skipped.
/// @param[in] slack overclosure below which a node does not join [m]
/// @return number of nodes that joined
std::size_t add_overclosed(PressedNodes& contact, double slack) {
  std::vector<Index> added;
  for (Index node = 0; node < contact.gap.size(); ++node) {
    if (contact.gap[node] < -slack && contact.pressing[node] == 0.0) added.push_back(node);
  }
  std::vector<Index> nodes;
  nodes.reserve(contact.nodes.size() + added.size());
  std::ranges::merge(contact.nodes, added, std::back_inserter(nodes));
  contact.nodes = std::move(nodes);
  return added.size();
}

}  // namespace

PressedNodes find_contact(PressedSurface& surface, PressedNodes contact, const ActiveSetOptions& options) {
  double tolerance = std::max(options.first_tolerance, options.tolerance);
  if (contact.penetration.value_or(1.0) > 0.0) predict_nodes(surface, contact);
  while (contact.passes < options.max_passes && !contact.converged) {
    ++contact.passes;
    surface.press(contact, tolerance);
    contact.is_gap_current = false;
    const bool rough = tolerance > options.tolerance;
    const bool exchange = contact.passes <= kExchanges;
    if (exchange) find_gap(surface, contact);
    const double least = kOverclosureFactor * tolerance * std::abs(*contact.penetration);
    const double slack = exchange ? least : std::max(least, contact.gap_error);
    std::size_t changes = drop_tensile(contact, exchange ? 0.0 : slack * surface.stiffness());
    if (contact.nodes.empty()) throw ConvergenceError("no node is in contact", contact.passes, 1.0);
    if (!exchange && changes == 0) find_gap(surface, contact);
    if (exchange || changes == 0) {
      changes += add_overclosed(contact, slack);
      const auto count = static_cast<double>(contact.nodes.size());
      contact.converged = !rough && static_cast<double>(changes) <= options.unsettled * count;
    }
    const bool is_settled =
        options.settling_tolerance > 0.0
            ? changes == 0 && tolerance <= options.settling_tolerance
            : static_cast<double>(changes) <= kFewChanges * static_cast<double>(contact.nodes.size());
    tolerance = is_settled ? options.tolerance
                           : std::min(tolerance, std::max({options.tightening * tolerance, options.settling_tolerance,
                                                           options.tolerance}));
  }
  return contact;
}

}  // namespace viscoroll::detail

#include "contact/transfer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Ranges of nodes in both directions that contain the contact.
std::pair<NodeRange, NodeRange> extent(const LocatedContact& located) {
  const Window& window = located.window();
  NodeRange phi{window.phi.last, window.phi.first};
  NodeRange theta{window.theta.last, window.theta.first};
  for (const Index node : located.contact.contact) {
    const int i = window.phi.first + static_cast<int>(node / window.theta.count());
    const int k = window.theta.first + static_cast<int>(node % window.theta.count());
    phi = {std::min(phi.first, i), std::max(phi.last, i)};
    theta = {std::min(theta.first, k), std::max(theta.last, k)};
  }
  return {phi, theta};
}

/// Range with a margin for nodes that join, which also contains the upstream neighbors of a contact with friction.
NodeRange padded(const NodeRange& range, int scale, const NodeRange& limits) {
  const int margin = 3 * scale + scale * range.count() / 50;
  return {std::max(scale * range.first - margin, limits.first), std::min(scale * range.last + margin, limits.last)};
}

/// Coarse nodes nearest to a node of the fine mesh, in one direction: the node itself, or its two neighbors.
struct Neighbors {
  explicit Neighbors(int place) : low(static_cast<int>(std::floor(0.5 * place))), count(place % 2 == 0 ? 1 : 2) {}
  int low;
  int count;
};

/// Call function(node, nearest, count) for every node of the fine window. `nearest` are the numbers of its nearest
/// coarse nodes inside the coarse window, `count` is their number including those outside.
template <class Function>
void for_nearest(const Window& coarse, const Window& fine, const Function& function) {
  const auto& [phi, theta] = coarse;
  std::vector<Index> nearest;
  Index node = 0;
  for (int i = fine.phi.first; i <= fine.phi.last; ++i) {
    const Neighbors rows(i);
    for (int k = fine.theta.first; k <= fine.theta.last; ++k, ++node) {
      const Neighbors columns(k);
      nearest.clear();
      for (int row = rows.low; row < rows.low + rows.count; ++row) {
        for (int column = columns.low; column < columns.low + columns.count; ++column) {
          if (row < phi.first || row > phi.last || column < theta.first || column > theta.last) continue;
          nearest.push_back(coarse.number_of(row, column));
        }
      }
      function(node, nearest, rows.count * columns.count);
    }
  }
}

/// @param[in] coarse forces of the nodes of the coarse window
/// @param[in] window,fine coarse and fine window
/// @param[in,out] forces forces of the fine window, initially 0
void prolong(const auto& coarse, const Window& window, const Window& fine, auto& forces) {
  const double patches = fine.is_line() ? 2.0 : 4.0;  // fine patches that share a coarse node's force
  for_nearest(window, fine, [&](Index node, const std::vector<Index>& nearest, int count) {
    for (const Index coarse_node : nearest) forces.row(node) += coarse.row(coarse_node);
    forces.row(node) /= patches * count;
  });
}

}  // namespace

Window box_around(const LocatedContact& located, int scale, const Window& limits) {
  const auto [phi, theta] = extent(located);
  const int half = std::max(-theta.first, theta.last);
  return {padded(phi, scale, limits.phi), padded({-half, half}, scale, limits.theta)};
}

VectorField prolonged_force(const LocatedContact& coarse, const Window& fine) {
  VectorField force = VectorField::Zero(fine.shape().size(), 3);
  prolong(coarse.contact.force, coarse.window(), fine, force);
  return force;
}

ArrayXd prolonged_pressing(const LocatedContact& coarse, const Window& fine) {
  ArrayXd pressing = ArrayXd::Zero(fine.shape().size());
  prolong(-coarse.contact.force.col(kDown), coarse.window(), fine, pressing);
  return pressing;
}

ContactSolution prolonged(const LocatedContact& coarse, const ContactProblem& fine) {
  const Window& window = fine.surface->window();
  SmoothFields fields{.gap = fine.initial_gap - coarse.contact.penetration,
                      .slip = Eigen::ArrayX2d::Zero(window.shape().size(), 2)};
  for_nearest(coarse.window(), window, [&](Index node, const std::vector<Index>& nearest, int count) {
    if (std::ssize(nearest) < count) return;
    fields.gap[node] = coarse.contact.gap(nearest).mean();
    fields.slip.row(node) = 0.5 * coarse.contact.slip(nearest, Eigen::all).colwise().mean();  // half of a coarse step
  });
  ContactSolution state{.force = prolonged_force(coarse, window), .penetration = coarse.contact.penetration};
  state.creepage = coarse.contact.creepage;
  state.prolonged = std::move(fields);
  return state;
}

std::vector<Index> prolonged_contact(const LocatedContact& coarse, const Window& fine) {
  std::vector<Index> contact;
  for_nearest(coarse.window(), fine, [&](Index node, const std::vector<Index>& nearest, int count) {
    const auto touching = std::count_if(nearest.begin(), nearest.end(), [&](Index coarse_node) {
      return coarse.contact.force(coarse_node, kDown) < 0.0;
    });
    if (touching > 0 && 2 * touching >= count) contact.push_back(node);
  });
  return contact;
}

std::vector<Index> loaded_nodes(const ContactSolution& contact) {
  if (!contact.adhesion) return contact.contact;
  std::vector<Index> nodes;
  std::ranges::merge(contact.contact, contact.adhesion->zone, std::back_inserter(nodes));
  return nodes;
}

bool touches_edge(const LocatedContact& located, const Window& window) {
  const WindowShape shape = window.shape();
  const bool goes_on = !window.is_line() && !located.problem.ends_at_sides;
  return std::ranges::any_of(loaded_nodes(located.contact), [&](Index node) {
    const Index number = window.number_of(located.window(), node);
    const Index i = number / shape.theta_nodes;
    const Index k = number % shape.theta_nodes;
    return i <= 1 || i == shape.phi_nodes - 1 || (goes_on && (k == 0 || k == shape.theta_nodes - 1));
  });
}

ContactSolution extended(const LocatedContact& located, const ContactProblem& whole) {
  const Window& outer = whole.surface->window();
  const ContactSolution& inside = located.contact;
  const Index size = outer.shape().size();
  ContactSolution contact{.force = VectorField::Zero(size, 3)};
  if (inside.slip.rows() > 0) contact.slip = Eigen::ArrayX2d::Zero(size, 2);
  for_nodes_within(outer, located.window(), [&](Index node, Index number) {
    contact.force.row(number) = inside.force.row(node);
    if (contact.slip.rows() > 0) contact.slip.row(number) = inside.slip.row(node);
  });
  const auto renumbered = [&](std::vector<Index> nodes) {
    for (Index& node : nodes) node = outer.number_of(located.window(), node);
    return nodes;
  };
  contact.contact = renumbered(inside.contact);
  contact.stick = renumbered(inside.stick);
  if (inside.adhesion) {
    contact.adhesion = inside.adhesion;
    contact.adhesion->zone = renumbered(inside.adhesion->zone);
  }
  contact.penetration = inside.penetration;
  contact.creepage = inside.creepage;
  contact.iterations = inside.iterations;
  contact.operator_applications = inside.operator_applications;
  contact.converged = inside.converged;
  contact.residual = inside.residual;
  find_displacements(*whole.surface, contact);
  contact.gap = whole.initial_gap - contact.displacement.col(kDown) - contact.penetration;
  return contact;
}

}  // namespace viscoroll::detail

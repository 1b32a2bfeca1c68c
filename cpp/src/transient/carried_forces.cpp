#include "transient/carried_forces.hpp"

#include <cmath>

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Fraction of the window that the first guess of the contact covers.
constexpr double kContactShare = 0.8;

/// Last forces, moved with the contact.
VectorField carried(Index half_nodes, const ContactPlace& place, const LastForces& last_window) {
  VectorField force = VectorField::Zero(half_nodes * place.count, 3);
  const double lowest =
      place.nodes.shift() - last_window.lowest + 0.5 * static_cast<double>(last_window.count - place.count);
  const auto whole = static_cast<Index>(std::floor(lowest));
  const double ahead = lowest - static_cast<double>(whole);
  const auto add = [&](Index row, Index last, double share) {
    if (last < 0 || last >= last_window.count) return;
    force.middleRows(half_nodes * row, half_nodes) +=
        share * last_window.force.middleRows(half_nodes * last, half_nodes);
  };
  for (Index row = 0; row < place.count; ++row) {
    add(row, row + whole, 1.0 - ahead);
    add(row, row + whole + 1, ahead);
  }
  return force;
}

}  // namespace

VectorField carried_forces(const ViscoelasticPair& pair, const ContactPlace& place, const LastForces& last,
                           double load) {
  VectorField guess = carried(pair.half_nodes(), place, last);
  if (!(guess.col(kDown) < 0.0).any()) {
    guess.col(kDown) = -(kContactShare * kContactShare * place.gap[0] - place.gap).max(0.0);
  }
  const ArrayXd weights = half_weights(pair.half_nodes()).replicate(place.count, 1);
  return load / -(weights * guess.col(kDown)).sum() * guess;
}

}  // namespace viscoroll::detail

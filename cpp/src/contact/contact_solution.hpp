/// @file
/// @brief State of a contact, with friction or without.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Gap and slip of a coarser mesh, between its nodes.
struct SmoothFields {
  Eigen::ArrayXd gap;
  Eigen::ArrayX2d slip;
};

/// @brief Forces and where they act.
struct ContactSolution {
  VectorField force;                     ///< on the surface at every node [N]: the pressing one along y is <= 0
  VectorField displacement;              ///< of every node [m]; empty where nobody has asked for it yet
  VectorField counterpart_displacement;  ///< the counterpart's share of it; no rows where it is rigid
  Eigen::ArrayXd gap;                    ///< of every node to the counterpart [m]
  std::vector<Eigen::Index> contact;     ///< nodes in contact
  double penetration = 0.0;              ///< of the lowest undeformed node, swollen as it turns [m]

  std::vector<Eigen::Index> stick;  ///< nodes in contact that stick; none without friction
  Eigen::ArrayX2d slip;  ///< way over it along x and z, from node to node or in a step [m]; empty without friction
  std::optional<double> creepage;  ///< [-], of a step in time the way of the center [m]; undetermined without friction
  std::optional<SmoothFields> prolonged;  ///< of the coarser mesh that a start is from

  int iterations = 0;             ///< linear systems solved
  int operator_applications = 0;  ///< by which they were solved
  bool converged = false;         ///< every condition holds
  double residual = 0.0;          ///< largest violation of the conditions [-], see the solver
};

/// @brief Note what the forces of a state do.
inline void find_displacements(const SurfaceOperator& surface, ContactSolution& state) {
  Displacements moved = surface.displacements(state.force);
  state.counterpart_displacement = moved.counterpart;
  state.displacement = std::move(moved).relative();
}

/// @return displacement of every node of what rolls by itself [m]
[[nodiscard]] inline VectorField own_displacement(const ContactSolution& state) {
  if (state.counterpart_displacement.rows() == 0) return state.displacement;
  return state.displacement - state.counterpart_displacement;
}

/// @return force that presses each node [N], >= 0
[[nodiscard]] inline Eigen::ArrayXd pressing_force(const ContactSolution& contact) { return -contact.force.col(kDown); }

}  // namespace viscoroll::detail

/// @file
/// @brief State of a contact, with or without friction.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "contact/traction_law.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Gap [m] and slip [m] of a coarser mesh, interpolated to the nodes of this mesh.
struct SmoothFields {
  Eigen::ArrayXd gap;
  Eigen::ArrayX2d slip;
};

/// @brief Edges of a contact with adhesion.
struct AdhesiveEdges {
  std::vector<Eigen::Index> zone;  ///< nodes of the cohesive zone, which are attracted but not in contact
  double zone_length;              ///< length of the cohesive zones from which the traction law follows [m]
  ContactSize size;                ///< size of the contact from which the traction law follows
  /// Difference of the works of opening and closing edges, integrated across the path [J/m]; in line contact [J/m^2].
  double lost_work;
};

/// @brief Nodal forces and the displacements, gaps and slips that belong to them.
struct ContactSolution {
  /// Force on the surface at every node [N]. Without adhesion, the pressing component, along y, is <= 0.
  VectorField force;
  VectorField displacement;              ///< displacement of every node [m]; empty until it is computed
  VectorField counterbody_displacement;  ///< part of the counterbody in it; no rows if the counterbody is rigid
  Eigen::ArrayXd gap;                    ///< gap between every node and the counterbody [m]
  std::vector<Eigen::Index> contact;     ///< nodes in contact
  double penetration = 0.0;  ///< penetration of the lowest undeformed node, including its centrifugal growth [m]

  std::vector<Eigen::Index> stick;  ///< sticking nodes; empty without friction
  Eigen::ArrayX2d slip;             ///< slip along x and z, per row or per time step [m]; empty without friction
  std::optional<double> creepage;   ///< [-], or displacement of the center in a time step [m]; empty if undetermined
  std::optional<AdhesiveEdges> adhesion;  ///< empty without adhesion
  std::optional<SmoothFields> prolonged;  ///< fields of the coarser mesh from which a start is interpolated

  int iterations = 0;             ///< number of linear systems solved
  int operator_applications = 0;  ///< number of operator applications used to solve them
  bool converged = false;         ///< whether all conditions hold
  double residual = 0.0;          ///< largest violation of the conditions [-], defined by each solver
};

/// @brief Compute the displacements caused by the forces of a state.
inline void find_displacements(const SurfaceOperator& surface, ContactSolution& state) {
  Displacements moved = surface.displacements(state.force);
  state.counterbody_displacement = moved.counterbody;
  state.displacement = std::move(moved).relative();
}

/// @return displacement of every node of the rolling body alone [m]
[[nodiscard]] inline VectorField own_displacement(const ContactSolution& state) {
  if (state.counterbody_displacement.rows() == 0) return state.displacement;
  return state.displacement - state.counterbody_displacement;
}

/// @return nodes with a force, ascending: those in contact and those of the cohesive zone
[[nodiscard]] std::vector<Eigen::Index> loaded_nodes(const ContactSolution& contact);

/// @return pressing force at each node [N]; without adhesion >= 0
[[nodiscard]] inline Eigen::ArrayXd pressing_force(const ContactSolution& contact) { return -contact.force.col(kDown); }

}  // namespace viscoroll::detail

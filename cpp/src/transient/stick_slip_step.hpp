/// @file
/// @brief One instant of a contact with Coulomb friction, docs/theory.md, transient rolling.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "transient/contact_stiffness.hpp"
#include "transient/mirrored_tables.hpp"

namespace viscoroll::detail {

/// @brief Directions in the plane's frame: forward, down, sideways, each by its components r, phi, theta at the nodes.
using Axes = std::array<std::array<HalfField, 3>, 3>;

/// @return a component of a vector field along a direction
[[nodiscard]] HalfField along(const std::array<HalfField, 3>& direction, const HalfField& field);
/// @return the vector field of that component along a direction
[[nodiscard]] HalfField spread(const std::array<HalfField, 3>& direction, const HalfField& scalar);

/// @brief Tractions of the plane on the coating, as nodal forces of a half: pressing, and along the plane.
struct PlaneForces {
  HalfField pressing;
  HalfField forward;
  HalfField sideways;
};

/// @return the forces of the body on the plane, by components
[[nodiscard]] HalfField on_plane(const Axes& axes, const PlaneForces& forces);

/// @brief What decides how far the center comes in a step: force * (sum of the forces along the plane) + way * (way of
/// the center) = value.
struct CenterCondition {
  double force = 1.0;
  double way = 0.0;
  double value = 0.0;
};

/// @brief An elastic problem in scaled forces, whose stick and slip belong to the way of this step.
struct StickSlipProblem {
  const MirroredTables& tables;
  const Axes& axes;
  HalfField gap;           ///< without these forces, up to a constant
  HalfField forward_way;   ///< of the nodes over the plane, without these forces and the way of the center
  HalfField sideways_way;  ///< likewise
  HalfField weights;       ///< of `half_weights`
  double load;             ///< sum of the pressing forces
  double friction;         ///< coefficient
  CenterCondition center;  ///< in scaled forces
};

/// @brief Who touches, who sticks, and how far the center has come.
struct StickSlip {
  PlaneForces forces;
  double penetration = 0.0;
  double way = 0.0;        ///< of the center [m]
  HalfField forward_slip;  ///< of the nodes over the plane in this step
  HalfField sideways_slip;
  HalfField displacement;           ///< by these forces, of all rows within reach
  std::vector<Eigen::Index> nodes;  ///< in contact, ascending
  Eigen::Index sticking = 0;        ///< number of these that stick
};

/// @brief Semismooth Newton method on forces, penetration and way together, whose linear systems have as unknowns how
/// far nodes have slipped, or moved away from the plane: all else follows from the stiffness.
/// @param[in] problem of this step
/// @param[in] guess forces to start from
/// @param[in,out] stiffness of an earlier contact
/// @throws ConvergenceError where the sets do not settle
[[nodiscard]] StickSlip solve_stick_slip(const StickSlipProblem& problem, const PlaneForces& guess,
                                         ContactStiffness& stiffness);

}  // namespace viscoroll::detail

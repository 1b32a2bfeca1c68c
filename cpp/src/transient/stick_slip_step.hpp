/// @file
/// @brief One instant of a contact with Coulomb friction, docs/theory/transient-friction.md.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "transient/contact_inverse.hpp"
#include "transient/stick_slip_problem.hpp"

namespace viscoroll::detail {

/// @brief Forces, sets of nodes, and the displacement of the center.
struct StickSlip {
  VectorField force;  ///< of the plane on the coating, row by row
  double penetration = 0.0;
  double center_displacement = 0.0;  ///< displacement of the center in the step [m]
  Eigen::ArrayX2d slip;              ///< of the nodes over the plane in this step, along x and z
  std::vector<Eigen::Index> nodes;   ///< in contact, ascending
  Eigen::Index sticking = 0;         ///< number of sticking nodes among them
};

/// @brief Solve by the semismooth Newton method for forces, penetration and displacement of the center together.
/// @param[in] problem problem of this step
/// @param[in] guess forces to start from
/// @param[in,out] stiffness of an earlier contact
/// @throws ConvergenceError if the sets do not settle
[[nodiscard]] StickSlip solve_stick_slip(const StickSlipProblem& problem, const VectorField& guess,
                                         ContactStiffness& stiffness);

}  // namespace viscoroll::detail

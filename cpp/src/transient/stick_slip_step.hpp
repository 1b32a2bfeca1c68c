/// @file
/// @brief One instant of a contact with Coulomb friction, docs/theory/transient-friction.md.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "transient/contact_inverse.hpp"
#include "transient/stick_slip_problem.hpp"

namespace viscoroll::detail {

/// @brief Who touches, who sticks, and how far the center has come.
struct StickSlip {
  VectorField force;  ///< of the plane on the coating, row by row
  double penetration = 0.0;
  double way = 0.0;                 ///< of the center [m]
  Eigen::ArrayX2d slip;             ///< of the nodes over the plane in this step, along x and z
  std::vector<Eigen::Index> nodes;  ///< in contact, ascending
  Eigen::Index sticking = 0;        ///< number of these that stick
};

/// @brief Semismooth Newton method on forces, penetration and way together.
/// @param[in] problem of this step
/// @param[in] guess forces to start from
/// @param[in,out] stiffness of an earlier contact
/// @throws ConvergenceError where the sets do not settle
[[nodiscard]] StickSlip solve_stick_slip(const StickSlipProblem& problem, const VectorField& guess,
                                         ContactStiffness& stiffness);

}  // namespace viscoroll::detail

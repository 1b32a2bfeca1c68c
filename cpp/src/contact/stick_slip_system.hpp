/// @file
/// @brief One Newton step of frictional contact: the linear system for given sets of sticking and slipping nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/frictional_contact.hpp"

namespace viscoroll::detail {

/// @brief What a node in contact does.
struct TangentialState {
  bool stick;
  Eigen::Array2d direction;  ///< of the traction of a slipping node, a unit vector
  double rigidity;           ///< kappa = mu p / |r| in [0, 1) of a slipping node: how much its direction may turn
};

/// @brief Sets of a step: a node for each state.
struct ContactSets {
  std::vector<Eigen::Index> contact;
  std::vector<TangentialState> states;
};

/// @brief Forces per displacement by which conditions on gaps and slips are weighed against forces [N/m].
struct ConditionScales {
  double normal;
  double tangential;
};

/// @return inverse of a node's own gap, and of its own slip, under a unit force
[[nodiscard]] ConditionScales condition_scales(const FrictionalContactProblem& problem);

/// @brief Solve the conditions linearized at `state` for the new forces, penetration and speed ratio.
///
/// Contact: gap = 0. Stick: S = 0. Slip: t . e = mu p, and along e', normal to e, (1 - kappa) t . e' + kappa c S . e' =
/// 0, which turns e towards -S. Unknowns are three forces for a sticking node but two for a slipping one, p and t . e'.
/// Without lateral creepage the mirror image of a node carries the same p and t_x and the opposite t_z: half of the
/// nodes do.
/// @param[in] problem coating, shape, load and drive
/// @param[in] friction mu [-], in place of the problem's
/// @param[in] scales weights of the conditions
/// @param[in] sets nodes in contact and what they do; symmetric where the problem is
/// @param[in] options limits
/// @param[in,out] state forces, penetration and speed ratio are replaced
void take_newton_step(const FrictionalContactProblem& problem, double friction, const ConditionScales& scales,
                      const ContactSets& sets, const ContactOptions& options, ContactSolution& state);

}  // namespace viscoroll::detail

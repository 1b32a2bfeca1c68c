/// @file
/// @brief From a solved contact to what a user asks for.
#pragma once

#include "contact/contact_solution.hpp"
#include "contact/lever_arms.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/formulation.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief The given quantities of a solve.
struct ContactConditions {
  LoadCase load_case;
  Mesh mesh;
  LeverArms arms;  ///< of the displaced nodes
  Curvature curvature;
  PatchLoad patch_load;
  double thickness;         ///< of all layers, without half-spaces [m]
  double half_space_share;  ///< of the contact's size, that a half-space adds to the thickness, by its softness [-]
  double centrifugal;       ///< d_R^(c) [m]
  bool approach_exists;     ///< whether displacements are those from a place that rests
  Eigen::ArrayXd height;    ///< above the lowest point of where displacements are taken, undeformed [m]
  Losses losses;            ///< in the layers of each body, per radian [N m]
  Eigen::ArrayXd lever;     ///< of the pressure: relative radius times slope of the undeformed gap [m]
  double counterpart_curvature;  ///< along the path [1/m]
  double drag;                   ///< of the pressure along the deformed surface of the counterpart, D_2 [N]
};

/// @brief Torques, powers and fields of a solved contact.
[[nodiscard]] Result make_result(const SurfaceWindow& window, const ContactSolution& contact,
                                 const ContactConditions& given);

}  // namespace viscoroll::detail

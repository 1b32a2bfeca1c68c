/// @file
/// @brief From a solved contact to what a user asks for.
#pragma once

#include "contact/coating_compliance.hpp"
#include "contact/contact_solution.hpp"
#include "contact/surface_window.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {

/// @brief A solved contact and what it was solved on.
struct SolvedContact {
  SurfaceWindow window;
  CoatingCompliance coating;
  ContactSolution contact;
};

/// @brief The given quantities of a solve.
struct ContactConditions {
  LoadCase load_case;
  Mesh mesh;
  Compliance compliance;
  PatchLoad patch_load;
  double centrifugal;  ///< d_R^(c) [m]
};

/// @brief Torques, powers and fields of a solved contact.
[[nodiscard]] Result make_result(const SolvedContact& solved, const ContactConditions& given);

}  // namespace viscoroll::detail

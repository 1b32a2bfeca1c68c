/// @file
/// @brief Results of a solved contact in the form that users read.
#pragma once

#include "rolling/window_search.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// Largest relative error of the torque per strain, compared with finite strain and the viscosities of Newton and
/// Jaumann for h/r_o = 1/84, 1/21 and 1/5 and Poisson's ratios 0.3 and 1/2 (tests/reference/finite_strain_table.py
/// gives 0.72).
inline constexpr double kErrorPerStrain = 0.75;

/// @return extent of the nodes in contact
[[nodiscard]] ContactReach contact_reach(const Result& result);

/// @return extent of the patches of the nodes in contact, which end half a spacing beyond these nodes
[[nodiscard]] ContactReach reach_of_patches(const Result& result, const SurfaceGrid& grid);

/// @brief Compute torques, powers and fields of a solved contact.
[[nodiscard]] Result make_result(const ContactSetup& given, const WindowContact& solved);

}  // namespace viscoroll::detail

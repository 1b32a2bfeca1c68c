/// @file
/// @brief From a solved contact to what a user asks for.
#pragma once

#include "rolling/window_search.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// Largest error of the torque, per strain, beside finite strain with the viscosities of Newton and of Jaumann: h/r_o =
/// 1/84, 1/21 and 1/5, Poisson's ratio 0.3 and 1/2 (tests/reference/finite_strain_table.py finds 0.72).
inline constexpr double kErrorPerStrain = 0.75;

/// @return how far the nodes in contact reach
[[nodiscard]] ContactReach contact_reach(const Result& result);

/// @brief Torques, powers and fields of a solved contact.
[[nodiscard]] Result make_result(const Assembly& given, const HeldContact& held);

}  // namespace viscoroll::detail

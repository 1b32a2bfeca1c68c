/// @file
/// @brief What a history may be asked for.
#pragma once

#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

inline constexpr int kMostLattices = 16;

/// @brief Check options.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const HistoryOptions& options);

/// @param[in] outer_radius,contact_radius of what rolls and of the contact at rest [m]
/// @param[in] is_line whether the contact is a line's
/// @return the mesh where none is given
[[nodiscard]] Mesh chosen_mesh(double outer_radius, double contact_radius, bool is_line);

}  // namespace viscoroll::detail

/// @file
/// @brief Input checks and the default mesh of a history.
#pragma once

#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

inline constexpr int kMaxAveragedMeshes = 16;

/// @brief Check options.
/// @throws InvalidInput with parameter, value, unit and range
void validate(const HistoryOptions& options);

/// @brief Default mesh.
/// @param[in] outer_radius,contact_radius of the rolling body and of the contact at rest [m]
/// @param[in] is_line whether the bodies are in line contact
[[nodiscard]] Mesh chosen_mesh(double outer_radius, double contact_radius, bool is_line);

}  // namespace viscoroll::detail

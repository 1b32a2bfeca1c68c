/// @file
/// @brief Results and fields as JSON.
#pragma once

#include <span>

#include "table.hpp"
#include "viscoroll/result.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::wasm {

/// @brief Scalar results by name, with mesh, state and warnings. Undetermined or infinite values are null.
/// @param[in] result result of a solve
[[nodiscard]] Json result_to_json(const Result& result);

/// @brief Fields over the nodes (x forward, z sideways) and heights in the middle plane.
/// @param[in] result result of a solve
/// @param[in] with_friction whether to return the state of each node (0 out of contact, 1 stick, 2 slip); null without
/// friction
[[nodiscard]] Json fields_to_json(const Result& result, bool with_friction);

/// @return table of scalar results: name, unit, description
[[nodiscard]] Json scalars_to_json();

/// @brief Time series of instants by name: the scalars of a history, and the distance. Undetermined values are null.
/// @param[in] instants instants of a history
/// @param[in] outer_radius radius of the rolling body [m]
[[nodiscard]] Json series_to_json(std::span<const RollingInstant> instants, double outer_radius);

[[nodiscard]] Json history_scalars_to_json();

}  // namespace viscoroll::wasm

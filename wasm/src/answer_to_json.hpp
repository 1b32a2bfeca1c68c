/// @file
/// @brief Results and fields as JSON.
#pragma once

#include "table.hpp"
#include "viscoroll/result.hpp"

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

}  // namespace viscoroll::wasm

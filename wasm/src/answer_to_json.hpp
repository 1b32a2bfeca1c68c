/// @file
/// @brief Answers as JSON: results with their fields, or what is wrong.
#pragma once

#include <string>

#include "table.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::wasm {

/// @brief Scalars by their names, with those of the mesh, state and warnings; what is undetermined or infinite is null.
/// @param[in] result of a solve
[[nodiscard]] Json result_to_json(const Result& result);

/// @brief Fields over the nodes, x forward, z sideways, and heights in the middle plane.
/// @param[in] result of a solve
/// @param[in] with_friction whether nodes stick and slip: 1 and 2, 0 out of contact; null without
[[nodiscard]] Json fields_to_json(const Result& result, bool with_friction);

/// @return the table of scalar results: name, unit, description
[[nodiscard]] Json scalars_to_json();

/// @param[in] message of an error
/// @return with the parameter that it begins with, by its place in the case, or null
[[nodiscard]] Json error_to_json(const std::string& message);

}  // namespace viscoroll::wasm

/// @file
/// @brief Warnings about a result.
#pragma once

#include <vector>

#include "rolling/contact_setup.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief Warnings of a finished solve.
/// @param[in] result complete except for the warnings
/// @param[in] given load case that was solved
/// @param[in] mesh_given whether the caller chose the mesh
[[nodiscard]] std::vector<Warning> warnings_of(const Result& result, const RollingCase& given, bool mesh_given);

}  // namespace viscoroll::detail

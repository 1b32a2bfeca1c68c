/// @file
/// @brief Warnings about a result.
#pragma once

#include <vector>

#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief Warnings of a finished solve.
/// @param[in] result complete, with the warnings of the bodies only
/// @param[in] options with which it was solved
/// @param[in] mesh_given whether the caller chose the mesh
[[nodiscard]] std::vector<Warning> warnings_of(const Result& result, const Options& options, bool mesh_given);

}  // namespace viscoroll::detail

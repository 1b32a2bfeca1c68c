/// @file
/// @brief What a user should know before relying on a result.
#pragma once

#include <vector>

#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief Warnings of a finished solve.
/// @param[in] result all but its warnings beside those of the body
/// @param[in] options with which it was solved
/// @param[in] mesh_given whether the mesh was the caller's
[[nodiscard]] std::vector<Warning> warnings_of(const Result& result, const Options& options, bool mesh_given);

}  // namespace viscoroll::detail

/// @file
/// @brief Choice of the mesh: refine until the error estimate is small enough.
#pragma once

#include "rolling/contact_setup.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief Solve on finer and finer meshes until the larger of the energy-balance error and the changes from the
/// previous mesh is below `options.accuracy`, or the finest mesh allowed is reached. If a finer mesh cannot be solved,
/// return the result of the finest mesh that was solved.
[[nodiscard]] Result solve_to_accuracy(const RollingCase& given);

}  // namespace viscoroll::detail

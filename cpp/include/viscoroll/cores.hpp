/// @file
/// @brief Number of cores that are available to this process.
#pragma once

namespace viscoroll {

/// @brief Number of cores that this process may use; `threads = 0` starts this many threads.
///
/// The count is the size of the affinity mask, or less where the control groups of Linux grant less processor time. It
/// is determined once; later changes of the mask or of the control group have no effect.
/// @return number of cores, at least 1
[[nodiscard]] int core_count();

}  // namespace viscoroll

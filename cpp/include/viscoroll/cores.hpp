/// @file
/// @brief How many cores there are to compute on.
#pragma once

namespace viscoroll {

/// @return cores that this process may use, which is what `threads = 0` asks for: those of its affinity mask, or fewer
/// where the control groups of Linux grant less time. Found once: a process that is moved later keeps its answer.
[[nodiscard]] int core_count();

}  // namespace viscoroll

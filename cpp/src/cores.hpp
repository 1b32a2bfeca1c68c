/// @file
/// @brief What `core_count` finds out.
#pragma once

#include <filesystem>

namespace viscoroll::detail {

/// @return cores that the calling thread may run on, at least 1
[[nodiscard]] int usable_cores();

/// @brief Time that the control groups of this process grant it, in cores.
/// @param[in] root where the folders `proc` and `sys` lie
/// @return the smallest quota of the process's group and of those above it, infinity where none is set
[[nodiscard]] double granted_cores(const std::filesystem::path& root);

}  // namespace viscoroll::detail

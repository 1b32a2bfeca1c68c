/// @file
/// @brief The two limits from which `core_count` determines the number of cores.
#pragma once

#include <filesystem>

namespace viscoroll::detail {

/// @return number of cores in the affinity mask of the calling thread, at least 1
[[nodiscard]] int usable_cores();

/// @brief Processor time that the control groups grant to this process, in cores.
/// @param[in] root folder that contains the folders `proc` and `sys`
/// @return smallest quota of the process's group and its parents; infinity without a quota
[[nodiscard]] double granted_cores(const std::filesystem::path& root);

}  // namespace viscoroll::detail

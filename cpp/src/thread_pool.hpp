/// @file
/// @brief The threads of the process that help those who compute. Only `parallel_for` asks them.
#pragma once

#include <cstddef>
#include <functional>

namespace viscoroll::detail {

/// @brief Run `work(0)` on the calling thread and, at the same time, `work(1)`, `work(2)`, ... on helping threads.
/// The helpers are shared by all callers of the process: those that are busy until `work(0)` has ended are not waited
/// for, so that calls within `work` and from several threads cannot wait for one another. All that began has ended when
/// this returns.
/// @param[in] helpers most helping threads
/// @param[in] work must not throw
/// @param[in] waiting called from time to time while the caller waits for helpers; must not throw
void run_together(std::size_t helpers, const std::function<void(std::size_t number)>& work,
                  const std::function<void()>& waiting);

}  // namespace viscoroll::detail

/// @file
/// @brief Pool of helper threads, shared by all computations of the process. Only `parallel_for` uses it.
#pragma once

#include <cstddef>
#include <functional>

namespace viscoroll::detail {

/// @brief Run `work(0)` on the calling thread and, at the same time, `work(1)`, `work(2)`, ... on helper threads.
///
/// All callers of the process share the helpers. A helper that is busy until `work(0)` has ended does not take part, so
/// that nested calls and calls from several threads cannot wait for one another. When this function returns, all calls
/// of `work` that began have ended.
/// @param[in] helpers largest number of helper threads
/// @param[in] work function that must not throw
/// @param[in] waiting function that is called about every 20 ms while the caller waits for helpers; must not throw
void run_together(std::size_t helpers, const std::function<void(std::size_t number)>& work,
                  const std::function<void()>& waiting);

}  // namespace viscoroll::detail

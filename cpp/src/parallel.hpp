/// @file
/// @brief The only place that starts threads, and the only one that calls an `Observer`.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string_view>

#include "viscoroll/observer.hpp"

namespace viscoroll::detail {

/// @brief Calls an `Observer` from the thread that owns the computation, at most every 20 ms.
class Watch {
 public:
  explicit Watch(const Observer& observer) : observer_(observer) {}

  /// @brief Report progress and look for a request to stop, if it is time again.
  /// @throws Cancelled where the observer asks for it
  void poll(std::string_view stage, double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  const Observer& observer_;
  Clock::time_point last_ = Clock::now();
};

/// @return number of threads meant by the option `threads` (0 = all cores)
[[nodiscard]] int thread_count(int threads);

/// @brief Run `body(index, worker)` for every index in [0, count) on `threads` threads, the caller's being worker 0.
/// The order of execution is free, so a body writes only to what belongs to its index. The first exception of any
/// body stops the others and is thrown again here.
/// @param[in] count number of indices
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch polled by worker 0 between indices
/// @param[in] stage what is being done, in words
/// @param[in] body work on one index; `worker` is in [0, thread_count(threads))
void parallel_for(std::size_t count, int threads, Watch& watch, std::string_view stage,
                  const std::function<void(std::size_t index, std::size_t worker)>& body);

}  // namespace viscoroll::detail

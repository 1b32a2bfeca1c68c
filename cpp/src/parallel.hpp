/// @file
/// @brief The only place that puts threads to work, and the only one that calls an `Observer`.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
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

/// @brief Lock a mutex that another thread may hold for long.
/// @throws Cancelled where the observer asks for it meanwhile
[[nodiscard]] std::unique_lock<std::timed_mutex> lock_watched(std::timed_mutex& mutex, Watch& watch,
                                                              std::string_view stage);

/// @brief Most threads that a caller may ask for.
constexpr int kMaxThreads = 1024;

/// @throws std::invalid_argument unless `threads` is in [0, kMaxThreads]
void require_thread_count(int threads);

/// @return number of threads that `parallel_for` uses: what the option `threads` means (0 = all cores), at most `count`
[[nodiscard]] std::size_t worker_count(std::size_t count, int threads);

/// @brief One of the threads of a `parallel_for`, as its body sees it.
struct Worker {
  std::size_t number;                ///< in [0, worker_count(count, threads))
  std::function<void()> checkpoint;  ///< to be called by bodies that take long, every few milliseconds
};

/// @brief Run `body(index, worker)` for every index in [0, count) on `threads` threads, the caller's being worker 0.
/// Callers may be many, also a body, and share the other threads: where those are busy, the caller does more itself.
/// The order of execution is free, so a body writes only to what belongs to its index. The first exception of any
/// body stops the others and is thrown again here.
/// @param[in] count number of indices
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch polled by worker 0 between indices, and while it waits for the others
/// @param[in] stage what is being done, in words
/// @param[in] body work on one index
/// @param[in] fraction of the stage that is done, from 0 to 1, where bodies know better than their number; asked for by
/// worker 0
void parallel_for(std::size_t count, int threads, Watch& watch, std::string_view stage,
                  const std::function<void(std::size_t index, const Worker& worker)>& body,
                  const std::function<double()>& fraction = {});

}  // namespace viscoroll::detail

/// @file
/// @brief Parallel loops and calls of an `Observer`. No other part of the library starts threads or calls an observer.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string_view>

#include "viscoroll/observer.hpp"

namespace viscoroll::detail {

/// @brief Calls an `Observer` on the thread that owns the computation, at most every 20 ms.
class Watch {
 public:
  explicit Watch(const Observer& observer) : observer_(observer) {}

  /// @brief Report the progress and check for cancellation, if 20 ms have passed since the last call.
  /// @throws Canceled if the observer canceled the computation
  void poll(std::string_view stage, double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  const Observer& observer_;
  Clock::time_point last_ = Clock::now();
};

/// @brief Lock a mutex that another thread may hold for a long time.
/// @throws Canceled if the observer cancels the computation meanwhile
[[nodiscard]] std::unique_lock<std::timed_mutex> lock_watched(std::timed_mutex& mutex, Watch& watch,
                                                              std::string_view stage);

/// @brief Largest number of threads that a caller may request.
constexpr int kMaxThreads = 1024;

/// @brief Check the option `threads`.
/// @throws InvalidInput unless `threads` is in [0, kMaxThreads]
void require_thread_count(int threads);

/// @return number of threads that `parallel_for` uses: `threads` (0 = all cores), but at most `count`
[[nodiscard]] std::size_t worker_count(std::size_t count, int threads);

/// @brief Thread of a `parallel_for`, an argument of the loop's body.
struct Worker {
  std::size_t number;                ///< in [0, worker_count(count, threads))
  std::function<void()> checkpoint;  ///< long bodies call it every few milliseconds; it throws if the loop must stop
};

/// @brief Run `body(index, worker)` for every index in [0, count) on `threads` threads; the calling thread is worker 0.
///
/// Several threads, and bodies of other loops, may call this function at the same time. They share the other threads; a
/// caller processes more indices itself while those are busy. The order of execution is arbitrary, so that a body may
/// only write to the data of its index. The first exception of a body stops the others and is rethrown here.
/// @param[in] count number of indices
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch polled by worker 0 between indices and while it waits for the others
/// @param[in] stage description of the stage
/// @param[in] body work on one index
/// @param[in] fraction returns the completed fraction of the stage, in [0, 1], and is called by worker 0; empty: the
/// fraction of indices
void parallel_for(std::size_t count, int threads, Watch& watch, std::string_view stage,
                  const std::function<void(std::size_t index, const Worker& worker)>& body,
                  const std::function<double()>& fraction = {});

}  // namespace viscoroll::detail

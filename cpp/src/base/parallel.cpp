#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>

#include "base/thread_pool.hpp"
#include "base/validate.hpp"
#include "viscoroll/cores.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {

void Watch::poll(std::string_view stage, double fraction) {
  constexpr auto period = std::chrono::milliseconds(20);
  const auto now = Clock::now();
  if (now - last_ < period) return;
  last_ = now;
  if (observer_.progress) observer_.progress({.stage = stage, .fraction = fraction});
  if (observer_.cancelled && observer_.cancelled()) throw Canceled();
}

std::unique_lock<std::timed_mutex> lock_watched(std::timed_mutex& mutex, Watch& watch, std::string_view stage) {
  using Clock = std::chrono::system_clock;  // the thread sanitizer of GCC 12 does not detect locks by the steady clock
  std::unique_lock lock(mutex, std::defer_lock);
  while (!lock.try_lock_until(Clock::now() + std::chrono::milliseconds(20))) watch.poll(stage, 0.0);
  return lock;
}

void require_thread_count(int threads) {
  if (threads >= 0 && threads <= kMaxThreads) return;
  reject("threads", "in [0, " + std::to_string(kMaxThreads) + "]", std::to_string(threads));
}

std::size_t worker_count(std::size_t count, int threads) {
  const auto wanted = static_cast<std::size_t>(threads > 0 ? threads : core_count());
  return std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(count, 1));
}

void parallel_for(std::size_t count, int threads, Watch& watch, std::string_view stage,
                  const std::function<void(std::size_t, const Worker&)>& body,
                  const std::function<double()>& fraction) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex failure_mutex;

  const auto guarded = [&](const auto& action) {
    try {
      action();
    } catch (...) {
      const std::scoped_lock lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      stop = true;  // after the failure is stored, since the checkpoints of the other workers then throw as well
    }
  };
  const auto poll = [&] {
    watch.poll(stage, fraction ? fraction()
                               : static_cast<double>(std::min<std::size_t>(next, count)) / static_cast<double>(count));
  };
  const auto run = [&](std::size_t number) {
    const Worker worker{.number = number, .checkpoint = [&, number] {
                          if (number == 0) poll();
                          if (stop) throw Canceled();
                        }};
    guarded([&] {
      for (std::size_t index = next++; index < count && !stop; index = next++) {
        body(index, worker);
        worker.checkpoint();
      }
    });
  };

  if (const std::size_t workers = worker_count(count, threads); workers > 1) {
    run_together(workers - 1, run, [&] {
      if (!stop) guarded(poll);
    });
  } else {
    run(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace viscoroll::detail

#include "parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {

void Watch::poll(std::string_view stage, double fraction) {
  constexpr auto period = std::chrono::milliseconds(20);
  const auto now = Clock::now();
  if (now - last_ < period) return;
  last_ = now;
  if (observer_.progress) observer_.progress({.stage = stage, .fraction = fraction});
  if (observer_.cancelled && observer_.cancelled()) throw Cancelled();
}

void require_thread_count(int threads) {
  if (threads >= 0 && threads <= kMaxThreads) return;
  reject("threads", "in [0, " + std::to_string(kMaxThreads) + "]", std::to_string(threads));
}

std::size_t worker_count(std::size_t count, int threads) {
  const std::size_t wanted = threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
  return std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(count, 1));
}

void parallel_for(std::size_t count, int threads, Watch& watch, std::string_view stage,
                  const std::function<void(std::size_t, const Worker&)>& body) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex failure_mutex;

  const auto run = [&](std::size_t number) {
    const Worker worker{
        .number = number, .checkpoint = [&, number] {
          if (number == 0) {
            watch.poll(stage, static_cast<double>(std::min<std::size_t>(next, count)) / static_cast<double>(count));
          }
          if (stop) throw Cancelled();
        }};
    try {
      for (std::size_t index = next++; index < count && !stop; index = next++) {
        body(index, worker);
        worker.checkpoint();
      }
    } catch (...) {
      const std::scoped_lock lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      stop = true;  // after the failure is stored, for the checkpoints of the others throw too
    }
  };

  {
    const std::size_t workers = worker_count(count, threads);
    std::vector<std::jthread> others;
    others.reserve(workers);
    try {
      for (std::size_t worker = 1; worker < workers; ++worker) others.emplace_back(run, worker);
    } catch (const std::system_error&) {
      // The system grants no more threads: those that run share the work.
    }
    run(0);
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace viscoroll::detail

#include "parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

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

int thread_count(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(std::size_t count, int threads, Watch& watch, std::string_view stage,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex failure_mutex;

  const auto run = [&](std::size_t worker) {
    try {
      for (std::size_t index = next++; index < count && !stop; index = next++) {
        body(index, worker);
        if (worker == 0) watch.poll(stage, static_cast<double>(index + 1) / static_cast<double>(count));
      }
    } catch (...) {
      stop = true;
      const std::scoped_lock lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };

  {
    const std::size_t workers = std::min(count, static_cast<std::size_t>(thread_count(threads)));
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

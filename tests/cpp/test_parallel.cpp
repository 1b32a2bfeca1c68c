#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/parallel.hpp"
#include "joined_thread.hpp"
#include "viscoroll/cores.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using namespace std::chrono_literals;

/// Calls `parallel_for` without an observer.
void run(std::size_t count, int threads, const std::function<void(std::size_t, const Worker&)>& body) {
  const Observer observer;
  Watch watch(observer);
  parallel_for(count, threads, watch, "", body);
}

/// Replacement of std::latch. On systems without futex (Windows), that of GCC 12 reads its count before it locks, so
/// that it can miss the last arrival and wait forever.
class Latch {
 public:
  explicit Latch(int expected) : expected_(expected) {}
  void arrive_and_wait() {
    std::unique_lock lock(mutex_);
    if (--expected_ == 0) all_here_.notify_all();
    all_here_.wait(lock, [this] { return expected_ == 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable all_here_;
  int expected_;
};

/// Calls `parallel_for` so that all its threads work at the same time.
void run_at_once(int threads, const std::function<void(std::size_t, const Worker&)>& body) {
  Latch all_here(threads);
  run(static_cast<std::size_t>(threads), threads, [&](std::size_t i, const Worker& worker) {
    all_here.arrive_and_wait();
    body(i, worker);
  });
}

/// Counts the threads that access it.
struct ThreadCounter {
  static inline std::atomic<int> threads = 0;
  ThreadCounter() noexcept { ++threads; }
  void touch() {}
};
thread_local ThreadCounter thread_counter;

TEST(ParallelFor, VisitsEveryIndexOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> visits(1000);
    run(visits.size(), threads, [&](std::size_t i, const Worker& worker) {
      ++visits[i];
      EXPECT_LT(worker.number, worker_count(visits.size(), threads));
    });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, UsesTheGivenNumberOfThreadsEachWithItsNumber) {
  std::vector<std::atomic<int>> numbers(7);
  run_at_once(7, [&](std::size_t, const Worker& worker) { ++numbers[worker.number]; });
  for (const auto& count : numbers) EXPECT_EQ(count, 1);
}

TEST(ParallelFor, ReusesItsThreads) {
  constexpr int kThreads = 3;
  ThreadCounter::threads = 0;
  for (int call = 0; call < 50; ++call) {
    run_at_once(kThreads, [](std::size_t, const Worker&) { thread_counter.touch(); });
  }
  // Other tests have started at most ten threads. If each call started new ones, there would be 100.
  EXPECT_LE(ThreadCounter::threads, 10);
}

TEST(ParallelFor, RethrowsTheFirstExceptionAndStopsTheRest) {
  std::atomic<int> visits = 0;
  EXPECT_THROW(run(1'000'000, 2,
                   [&](std::size_t i, const Worker&) {
                     ++visits;
                     if (i == 3) throw std::out_of_range("three");
                   }),
               std::out_of_range);
  EXPECT_LT(visits, 1'000'000);
}

TEST(ParallelFor, RethrowsTheExceptionOfAHelperAndStaysUsable) {
  for (int call = 0; call < 20; ++call) {
    EXPECT_THROW(run_at_once(2,
                             [](std::size_t, const Worker& worker) {
                               if (worker.number == 1) throw std::out_of_range("helper");
                             }),
                 std::out_of_range);
  }
}

TEST(ParallelFor, DoesNothingForNoIndex) {
  run(0, 2, [](std::size_t, const Worker&) { FAIL(); });
}

TEST(ParallelFor, CanBeNested) {
  std::vector<std::atomic<int>> visits(512);
  run(8, 3, [&](std::size_t i, const Worker&) {
    run(8, 3, [&](std::size_t j, const Worker&) {
      run(8, 3, [&](std::size_t k, const Worker&) { ++visits[64 * i + 8 * j + k]; });
    });
  });
  for (const auto& count : visits) EXPECT_EQ(count, 1);
}

TEST(ParallelFor, CanBeCalledByManyThreads) {
  std::vector<long> sums(8);
  {
    std::vector<JoinedThread> callers;
    callers.reserve(sums.size());
    for (long& sum : sums) {
      callers.emplace_back([&sum] {
        for (int call = 0; call < 200; ++call) {
          std::vector<long> squares(100);
          run(squares.size(), 1 + call % 4,
              [&](std::size_t i, const Worker&) { squares[i] = static_cast<long>(i * i); });
          sum += std::accumulate(squares.begin(), squares.end(), 0L);
        }
      });
    }
  }
  for (const long sum : sums) EXPECT_EQ(sum, 200 * 328350);  // n (n + 1) (2 n + 1) / 6 up to 99
}

TEST(ParallelFor, IsCancelledWhileItWaitsForAHelper) {
  std::atomic<bool> helping = false;
  const Observer observer{.cancelled = [&] { return helping.load(); }};
  Watch watch(observer);
  const auto body = [&](std::size_t, const Worker& worker) {
    while (worker.number == 0 && !helping) std::this_thread::yield();
    while (worker.number == 1) {
      helping = true;
      std::this_thread::sleep_for(1ms);
      worker.checkpoint();
    }
  };
  EXPECT_THROW(parallel_for(2, 2, watch, "", body), Canceled);
}

TEST(LockWatched, IsCancelledWhileAnotherThreadHoldsTheMutex) {
  std::timed_mutex mutex;
  std::unique_lock lock_of_test(mutex);
  std::atomic<int> polls = 0;
  const Observer observer{.cancelled = [&] { return ++polls == 2; }};
  std::thread([&] {
    Watch watch(observer);
    EXPECT_THROW((void)lock_watched(mutex, watch, ""), Canceled);
    EXPECT_EQ(polls, 2);
  }).join();
  lock_of_test.unlock();
  Watch watch(observer);
  EXPECT_TRUE(lock_watched(mutex, watch, "").owns_lock());
}

TEST(WorkerCount, IsTheNumberOfCoresUnlessGivenAndAtMostThatOfTasks) {
  EXPECT_EQ(worker_count(1000, 0), static_cast<std::size_t>(core_count()));
  EXPECT_EQ(worker_count(1000, 7), 7U);
  EXPECT_EQ(worker_count(3, 7), 3U);
  EXPECT_EQ(worker_count(0, 7), 1U);
}

TEST(Watch, StopsOnRequestAndReportsFromTheCallingThread) {
  std::vector<double> fractions;
  const auto caller = std::this_thread::get_id();
  const Observer observer{.cancelled = [&] { return fractions.size() >= 3; },
                          .progress =
                              [&](const Progress& report) {
                                EXPECT_EQ(std::this_thread::get_id(), caller);
                                EXPECT_EQ(report.stage, "waiting");
                                fractions.push_back(report.fraction);
                              }};
  Watch watch(observer);
  const auto wait = [](std::size_t, const Worker&) { std::this_thread::sleep_for(2ms); };
  EXPECT_THROW(parallel_for(100'000, 2, watch, "waiting", wait), Canceled);
  ASSERT_EQ(fractions.size(), 3U);
  EXPECT_LT(fractions[0], fractions[2]);
}

}  // namespace
}  // namespace viscoroll::detail

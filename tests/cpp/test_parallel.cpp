#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "parallel.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnceOnAnyNumberOfThreads) {
  const Observer observer;
  Watch watch(observer);
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<std::atomic<int>> visits(1000);
    parallel_for(visits.size(), threads, watch, "", [&](std::size_t i, const Worker& worker) {
      ++visits[i];
      EXPECT_LT(worker.number, worker_count(visits.size(), threads));
    });
    for (const auto& count : visits) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, ThrowsTheFirstExceptionAgainAndStopsTheRest) {
  const Observer observer;
  Watch watch(observer);
  std::atomic<int> visits = 0;
  EXPECT_THROW(parallel_for(1'000'000, 2, watch, "",
                            [&](std::size_t i, const Worker&) {
                              ++visits;
                              if (i == 3) throw std::out_of_range("three");
                            }),
               std::out_of_range);
  EXPECT_LT(visits, 1'000'000);
}

TEST(ParallelFor, DoesNothingForNoIndex) {
  const Observer observer;
  Watch watch(observer);
  parallel_for(0, 2, watch, "", [](std::size_t, const Worker&) { FAIL(); });
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
  const auto wait = [](std::size_t, const Worker&) { std::this_thread::sleep_for(std::chrono::milliseconds(2)); };
  EXPECT_THROW(parallel_for(100'000, 2, watch, "waiting", wait), Cancelled);
  ASSERT_EQ(fractions.size(), 3U);
  EXPECT_LT(fractions[0], fractions[2]);
}

}  // namespace
}  // namespace viscoroll::detail

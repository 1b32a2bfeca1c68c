/// Threads when their process forks, ends, or may use few cores: POSIX, and partly Linux.
#if defined(__unix__) || defined(__APPLE__)

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sched.h>
#endif

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <latch>
#include <limits>
#include <string>
#include <thread>

#include "base/cores.hpp"
#include "base/parallel.hpp"
#include "joined_thread.hpp"
#include "viscoroll/cores.hpp"

namespace viscoroll::detail {
namespace {

constexpr unsigned kPatience = 60;  // time after which a process counts as hanging [s]

/// @return 0 if the sum of 0 to 999 is correct
int sum(const std::function<void(std::size_t)>& before_each) {
  const Observer observer;
  Watch watch(observer);
  std::atomic<long> sum = 0;
  parallel_for(1000, 2, watch, "", [&](std::size_t i, const Worker&) {
    before_each(i);
    sum += static_cast<long>(i);
  });
  return sum == 499500 ? 0 : 1;
}

int sum_alone_or_together() {
  return sum([](std::size_t) {});
}

int sum_together() {
  std::latch both_here(2);
  return sum([&](std::size_t i) {
    if (i < 2) both_here.arrive_and_wait();
  });
}

/// @return result of `work` in a forked process, or -1 if the process ended differently
int in_child(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(kPatience);
    _exit(work());
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Fork, BothProcessesCanUseThreads) {
  ASSERT_EQ(sum_together(), 0);
  EXPECT_EQ(in_child([] { return sum_together() + in_child(sum_together); }), 0);  // a child and a grandchild
  EXPECT_EQ(sum_together(), 0);
}

TEST(Fork, BothProcessesCanUseThreadsWhileOthersCompute) {
  std::atomic<bool> stop = false;
  {
    const JoinedThread other([&] {
      while (!stop) EXPECT_EQ(sum_alone_or_together(), 0);
    });
    for (int child = 0; child < 20; ++child) EXPECT_EQ(in_child(sum_together), 0);
    stop = true;
  }
  EXPECT_EQ(sum_together(), 0);
}

#ifdef __linux__
TEST(Fork, FindsNoThreadWithoutWork) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the sanitizer has a thread of its own";
#endif
  // After a fork, Python counts the threads of the parent and warns if it finds any.
  const auto threads = [] { return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}); };
  EXPECT_EQ(in_child([&] {
              const auto before = threads();
              const int failure = sum_together();
              return failure + in_child([] { return 0; }) + (threads() == before ? 0 : 1);
            }),
            0);
}
#endif

TEST(Exit, DoesNotWaitForThreads) {
  EXPECT_EXIT(
      {
        alarm(kPatience);
        std::latch busy(2);
        std::thread([&] {
          const Observer observer;
          Watch watch(observer);
          parallel_for(2, 2, watch, "", [&](std::size_t, const Worker&) {
            busy.count_down();
            std::this_thread::sleep_for(std::chrono::hours(1));
          });
        }).detach();
        busy.wait();
        std::exit(sum_alone_or_together());
      },
      testing::ExitedWithCode(0), "");
}

#ifdef __linux__
TEST(Cores, AreThoseOfTheAffinityMask) {
  int before = 0;
  int bound = 0;
  std::thread([&] {
    before = usable_cores();
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(sched_getcpu()), &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);  // 0 is the calling thread
    bound = usable_cores();
  }).join();
  EXPECT_GE(before, core_count());
  EXPECT_EQ(bound, 1);
}

/// A folder with Linux's files about control groups.
class ControlGroups : public testing::Test {
 protected:
  ~ControlGroups() override { std::filesystem::remove_all(root_); }

  void write(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  const std::filesystem::path root_ =
      std::filesystem::path(testing::TempDir()) / ("viscoroll_groups_" + std::to_string(getpid()));
};

TEST_F(ControlGroups, GrantNoMoreThanTheSmallestQuotaOfVersion2) {
  write("proc/self/cgroup", "0::/user.slice/job\n");
  write("sys/fs/cgroup/user.slice/job/cpu.max", "max 100000\n");
  EXPECT_EQ(granted_cores(root_), std::numeric_limits<double>::infinity());
  write("sys/fs/cgroup/user.slice/cpu.max", "250000 100000\n");
  EXPECT_EQ(granted_cores(root_), 2.5);
}

TEST_F(ControlGroups, GrantTheQuotaOfAContainer) {
  write("proc/self/cgroup", "12:memory:/docker/a1\n4:cpu,cpuacct:/docker/a1\n0::/\n");
  EXPECT_EQ(granted_cores(root_), std::numeric_limits<double>::infinity());
  write("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "150000\n");
  write("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(granted_cores(root_), 1.5);
  write("sys/fs/cgroup/cpu,cpuacct/cpu.cfs_quota_us", "-1\n");
  EXPECT_EQ(granted_cores(root_), std::numeric_limits<double>::infinity());
}
#endif

}  // namespace
}  // namespace viscoroll::detail

#endif

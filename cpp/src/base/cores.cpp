#include "base/cores.hpp"

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "viscoroll/cores.hpp"

namespace viscoroll {
namespace detail {
namespace {

namespace fs = std::filesystem;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Quota in version 2 of control groups: "200000 100000", the processor time in each period, both in microseconds, or
/// "max 100000" without a limit.
double quota_2(const fs::path& group) {
  double time = 0.0;
  double period = 0.0;
  std::ifstream(group / "cpu.max") >> time >> period;
  return time > 0.0 && period > 0.0 ? time / period : kNoLimit;
}

/// Quota in version 1 of control groups: the same two numbers in two files; without a limit the first contains -1.
double quota_1(const fs::path& group) {
  double time = 0.0;
  double period = 0.0;
  std::ifstream(group / "cpu.cfs_quota_us") >> time;
  std::ifstream(group / "cpu.cfs_period_us") >> period;
  return time > 0.0 && period > 0.0 ? time / period : kNoLimit;
}

/// Smallest quota of a group and its parents. In a container the path may be that of the host, of which only the root
/// is visible.
template <class Quota>
double smallest_quota(const fs::path& hierarchy, fs::path group, const Quota& quota) {
  for (double smallest = kNoLimit;; group = group.parent_path()) {
    smallest = std::min(smallest, quota(hierarchy / group.relative_path()));
    if (!group.has_relative_path()) return smallest;
  }
}

}  // namespace

int usable_cores() {
#ifdef __linux__
  // The first mask has 1024 cores. The system call fails if the mask is too short for the machine.
  for (std::vector<cpu_set_t> mask(1); mask.size() <= 64; mask.resize(2 * mask.size())) {
    const std::size_t bytes = mask.size() * sizeof(cpu_set_t);
    if (sched_getaffinity(0, bytes, mask.data()) == 0) return CPU_COUNT_S(bytes, mask.data());
  }
#endif
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

double granted_cores(const fs::path& root) {
  const fs::path mounts = root / "sys/fs/cgroup";
  double granted = kNoLimit;
  // Each hierarchy has a line "number:controllers:group"; that of version 2 has no controllers.
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = line.substr(second + 1);
    if (controllers.empty()) granted = std::min(granted, smallest_quota(mounts, group, quota_2));
    if (("," + controllers + ",").find(",cpu,") != std::string::npos) {
      granted = std::min(granted, smallest_quota(mounts / controllers, group, quota_1));
    }
  }
  return granted;
}

}  // namespace detail

int core_count() {
  static const int count = [] {
    const int usable = detail::usable_cores();
#ifdef __linux__
    return static_cast<int>(std::ceil(std::min<double>(usable, detail::granted_cores("/"))));
#else
    return usable;
#endif
  }();
  return count;
}

}  // namespace viscoroll

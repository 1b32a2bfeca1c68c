#include "rolling/shared_starts.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "rolling/drives.hpp"

namespace viscoroll::detail {
namespace {

/// Number of starts that are kept: as many loads and drives as a study alternates between.
constexpr std::size_t kMaxStarts = 16;

std::vector<double> numbers_of(const GivenMotion& motion) {
  std::vector<double> numbers{motion.lateral_creepage, motion.spin};
  for (const std::optional<double>& given : {motion.force, motion.torque, motion.creepage}) {
    numbers.push_back(given.has_value() ? 1.0 : 0.0);
    numbers.push_back(given.value_or(0.0));
  }
  return numbers;
}

}  // namespace

std::shared_ptr<SharedStart> SharedStarts::of(const LoadCase& load_case, const Options& options, const Window& window) {
  Key key = numbers_of(given_motion(load_case));
  for (const double number : {load_case.load.value_or(0.0), load_case.penetration.value_or(0.0),
                              static_cast<double>(options.compliance), static_cast<double>(options.patch_load),
                              static_cast<double>(options.slip_kinematics), static_cast<double>(options.max_iterations),
                              static_cast<double>(window.phi.first), static_cast<double>(window.phi.last),
                              static_cast<double>(window.theta.first), static_cast<double>(window.theta.last)}) {
    key.push_back(number);
  }
  const std::scoped_lock lock(mutex_);
  const auto found = std::ranges::find(starts_, key, [](const auto& entry) { return entry.first; });
  if (found != starts_.end()) return found->second;
  starts_.emplace_front(std::move(key), std::make_shared<SharedStart>());
  if (starts_.size() > kMaxStarts) starts_.pop_back();
  return starts_.front().second;
}

}  // namespace viscoroll::detail

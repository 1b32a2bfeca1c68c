#include "base/invalid_speed.hpp"

#include "base/validate.hpp"

namespace viscoroll::detail {
namespace {

InvalidInput error_about(const GivenSpeed& given, double angular_speed, const SpeedRule& rule) {
  const auto with_unit = [&](double speed) { return text(speed).append(" ").append(given.unit); };
  std::string stated = "must be " + rule.before;
  std::optional<Range> allowed;
  if (rule.limit) {
    const double limit = *rule.limit * (given.value / angular_speed);
    stated += with_unit(limit) + rule.after;
    if (rule.bound == SpeedRule::Bound::minimum) allowed = {.unit = std::string(given.unit), .minimum = limit};
    if (rule.bound == SpeedRule::Bound::excluded_maximum) {
      allowed = {.unit = std::string(given.unit), .maximum = limit, .excludes_maximum = true};
    }
  }
  return {std::string(given.parameter), stated, with_unit(given.value) + rule.remark, "", allowed};
}

}  // namespace

InvalidSpeed::InvalidSpeed(double angular_speed, const SpeedRule& rule)
    : InvalidInput(error_about({"angular_speed", angular_speed, "rad/s"}, angular_speed, rule)),
      angular_speed_(angular_speed),
      rule_(rule) {}

InvalidInput InvalidSpeed::stated_for(const GivenSpeed& given) const {
  return error_about(given, angular_speed_, rule_);
}

}  // namespace viscoroll::detail

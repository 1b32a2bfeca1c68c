/// @file
/// @brief Errors about the speed of a body, stated for the speed that the user gave.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {

/// @brief Speed that the user gave: the angular speed of a body, or the speed of the ground.
struct GivenSpeed {
  std::string_view parameter;
  double value;
  std::string_view unit;
};

/// @brief Rule that a speed violates: "<before><limit> <unit><after>", or only "<before>" without a limit.
struct SpeedRule {
  /// Whether the limit ends the range of the allowed speeds.
  enum class Bound { none, minimum, excluded_maximum };

  std::string before;
  Bound bound = Bound::none;
  std::optional<double> limit = {};  ///< angular speed [rad/s]
  std::string after = {};
  std::string remark = {};  ///< consequence of the given value; may be empty
};

/// @brief The angular speed of a body is invalid. Functions that derive it from a given speed state the error for that
/// speed, see `with_given_speed`.
class InvalidSpeed : public InvalidInput {
 public:
  /// @param[in] angular_speed invalid angular speed [rad/s]
  /// @param[in] rule rule that it violates
  InvalidSpeed(double angular_speed, const SpeedRule& rule);

  /// @return the same error for a speed that is proportional to the angular speed, and from which it was derived
  [[nodiscard]] InvalidInput stated_for(const GivenSpeed& given) const;

 private:
  double angular_speed_;
  SpeedRule rule_;
};

/// @return result of a computation whose errors about the angular speed of a body name the given speed
template <class Compute>
auto with_given_speed(const GivenSpeed& given, const Compute& compute) {
  try {
    return compute();
  } catch (const InvalidSpeed& error) {
    throw error.stated_for(given);
  }
}

}  // namespace viscoroll::detail

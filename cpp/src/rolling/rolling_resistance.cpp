#include "viscoroll/rolling_resistance.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "base/validate.hpp"

namespace viscoroll {
namespace {

using detail::reject;
using detail::text;

/// Relative tolerance of the range check: loads and speeds at the ends of the fitted range may contain round-off.
constexpr double kRangeTolerance = 1e-12;

/// Coordinate in [-1, 1] in which the polynomials are evaluated, linear in the logarithm of the value.
double chebyshev_coordinate(double value, const std::array<double, 2>& range) {
  return 2.0 * std::log(value / range[0]) / std::log(range[1] / range[0]) - 1.0;
}

/// Sum of coefficient(i) T_i(x) by Clenshaw's recurrence.
template <class Coefficient>
double chebyshev_sum(std::size_t count, const Coefficient& coefficient, double x) {
  double next = 0.0;
  double after_next = 0.0;
  for (std::size_t i = count; i-- > 1;) {
    const double here = coefficient(i) + 2.0 * x * next - after_next;
    after_next = next;
    next = here;
  }
  return coefficient(0) + x * next - after_next;
}

void require_fitted_range(std::string_view name, double value, double from, double to, std::string_view unit) {
  if (value >= from - kRangeTolerance * std::abs(from) && value <= to + kRangeTolerance * std::abs(to)) return;
  reject(name, Range{.unit = std::string(unit), .minimum = from, .maximum = to}, value, ", the fitted range");
}

void require_range(const std::string& name, const std::array<double, 2>& range, std::string_view unit) {
  detail::require_positive(name + "[0]", range[0], unit);
  if (!(std::isfinite(range[1]) && range[1] > range[0])) {
    reject(name + "[1]", "> " + name + "[0] = " + text(range[0]) + " " + std::string(unit), range[1],
           Range{.unit = std::string(unit), .minimum = range[0], .excludes_minimum = true});
  }
}

}  // namespace

void validate(const RollingResistance& surface) {
  require_range("load", surface.load, "N");
  require_range("angular_speed", surface.angular_speed, "rad/s");
  detail::require_positive("radius", surface.radius, "m");
  const auto& rows = surface.coefficients;
  if (rows.empty() || rows.front().empty())
    reject("coefficients", "a matrix of at least one row and one column", "none");
  for (const std::vector<double>& row : rows) {
    if (row.size() != rows.front().size())
      reject("coefficients", "a matrix with rows of equal length (" + std::to_string(rows.front().size()) + ")",
             std::to_string(row.size()));
    for (const double coefficient : row) detail::require_finite("coefficients", coefficient);
  }
  detail::require_nonnegative("error", surface.error, "");
  detail::require_nonnegative("largest_error", surface.largest_error, "");
}

double resisting_torque(const RollingResistance& surface, double load, double angular_speed, Extrapolation outside) {
  validate(surface);
  detail::require_nonnegative("load", load, "N");
  detail::require_finite("angular_speed", angular_speed);
  const double speed = std::abs(angular_speed);
  if (outside == Extrapolation::error) {
    require_fitted_range("load", load, surface.load[0], surface.load[1], "N");
    require_fitted_range("angular_speed", angular_speed, -surface.angular_speed[1], surface.angular_speed[1], "rad/s");
  }
  const double fitted_load = std::clamp(load, surface.load[0], surface.load[1]);
  const double fitted_speed = std::clamp(speed, surface.angular_speed[0], surface.angular_speed[1]);
  const double x = chebyshev_coordinate(fitted_load, surface.load);
  const double y = chebyshev_coordinate(fitted_speed, surface.angular_speed);
  const auto& rows = surface.coefficients;
  const auto row_sum = [&](std::size_t i) {
    return chebyshev_sum(rows[i].size(), [&](std::size_t j) { return rows[i][j]; }, y);
  };
  // Outside of the fitted loads, the torque is proportional to the load; below the fitted speeds, to the speed.
  const double load_ratio = load / fitted_load;
  const double speed_ratio = std::min(speed / surface.angular_speed[0], 1.0);
  const double torque = load_ratio * speed_ratio * std::exp(chebyshev_sum(rows.size(), row_sum, x));
  return std::copysign(torque, angular_speed);
}

}  // namespace viscoroll

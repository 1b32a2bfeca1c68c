#include "materials/master_curve.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/validate.hpp"

namespace viscoroll::detail {
namespace {

void require_column(std::string_view prefix, std::string_view name, const std::vector<double>& column,
                    std::size_t length) {
  if (column.size() != length) {
    reject(std::string(prefix) + std::string(name), "as long as frequency (" + std::to_string(length) + ")",
           std::to_string(column.size()));
  }
}

/// Index of the lowest entry at a frequency above zero.
std::size_t first_dynamic(const MasterCurve& curve) { return curve.frequency.front() == 0.0 ? 1 : 0; }

}  // namespace

void validate_table(const MasterCurve& curve, std::string_view prefix) {
  const std::size_t length = curve.frequency.size();
  require_column(prefix, "storage", curve.storage, length);
  require_column(prefix, "loss", curve.loss, length);
  for (std::size_t i = 0; i < length; ++i) {
    const auto entry = [&](std::string_view column) {
      return std::string(prefix).append(column).append("[").append(std::to_string(i)).append("]");
    };
    require_nonnegative(entry("frequency"), curve.frequency[i], "rad/s");
    if (i > 0 && !(curve.frequency[i] > curve.frequency[i - 1])) {
      reject(entry("frequency"),
             "> frequency[" + std::to_string(i - 1) + "] = " + text(curve.frequency[i - 1]) +
                 " rad/s (sort the table by frequency)",
             curve.frequency[i]);
    }
    require_positive(entry("storage"), curve.storage[i], "Pa");
    require_nonnegative(entry("loss"), curve.loss[i], "Pa");
  }
  if (length < 2 || length - first_dynamic(curve) < 2) {
    reject(std::string(prefix) + "frequency", "a table of at least two entries above 0 rad/s",
           std::to_string(length) + " entries");
  }
}

std::complex<double> interpolate(const MasterCurve& curve, double omega) {
  const auto entry = [&](std::size_t i) { return std::complex<double>(curve.storage[i], curve.loss[i]); };
  if (omega == curve.frequency.front()) return entry(0);

  const std::size_t low = first_dynamic(curve);
  const std::size_t high = curve.frequency.size() - 1;
  if (omega < curve.frequency[low] || omega > curve.frequency[high]) {
    if (curve.extrapolation == Extrapolation::error) {
      // The static modulus is valid at 0 rad/s only. The continuous orders of a plane come close to that frequency.
      const std::string at_rest = low == 0 ? ", give the static modulus as a first entry at 0 rad/s," : "";
      reject("frequency",
             "within the master curve's table, " + text(curve.frequency[low]) + " to " + text(curve.frequency[high]) +
                 " rad/s (widen the table" + at_rest + " or set extrapolation to HOLD)",
             text(omega) + " rad/s");
    }
    return entry(omega < curve.frequency[low] ? low : high);
  }
  const auto above = std::upper_bound(curve.frequency.begin() + static_cast<std::ptrdiff_t>(low) + 1,
                                      curve.frequency.end() - 1, omega);
  const auto i = static_cast<std::size_t>(above - curve.frequency.begin());
  const double t = std::log(omega / curve.frequency[i - 1]) / std::log(curve.frequency[i] / curve.frequency[i - 1]);
  return (1.0 - t) * entry(i - 1) + t * entry(i);
}

}  // namespace viscoroll::detail

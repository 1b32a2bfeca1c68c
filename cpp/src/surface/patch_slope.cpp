#include "surface/patch_slope.hpp"

#include <array>
#include <cstddef>

namespace viscoroll::detail {

Eigen::ArrayXd patch_slope(const Eigen::ArrayXd& values, Eigen::Index row, double distance) {
  const auto difference = [&](Eigen::Index rows) {
    const Eigen::Index count = values.size() - 2 * rows * row;
    return Eigen::ArrayXd((values.tail(count) - values.head(count)) / (2.0 * static_cast<double>(rows) * distance));
  };
  Eigen::ArrayXd slope = Eigen::ArrayXd::Zero(values.size());
  slope.segment(row, values.size() - 2 * row) = difference(1);
  const Eigen::Index inner = values.size() - 4 * row;
  if (inner <= 0) return slope;
  slope.segment(2 * row, inner) = 1.25 * slope.segment(2 * row, inner) - 0.25 * difference(2);
  return slope;
}

Eigen::ArrayXd at_nodes(const Eigen::ArrayXd& values, Eigen::Index row, double downstream) {
  const Eigen::Index inner = values.size() - 3 * row;
  if (downstream == 0.0 || inner <= 0) return values;
  constexpr std::array<double, 4> kRows{-2.0, -1.0, 0.0, 1.0};
  Eigen::ArrayXd result = values;
  result.segment(2 * row, inner).setZero();
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    double share = 1.0;
    for (std::size_t k = 0; k < kRows.size(); ++k) {
      if (k != i) share *= (kRows[k] + downstream) / (kRows[k] - kRows[i]);
    }
    result.segment(2 * row, inner) += share * values.segment(static_cast<Eigen::Index>(i) * row, inner);
  }
  return result;
}

}  // namespace viscoroll::detail

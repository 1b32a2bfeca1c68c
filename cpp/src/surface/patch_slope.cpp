#include "surface/patch_slope.hpp"

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

}  // namespace viscoroll::detail

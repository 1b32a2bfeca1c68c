#include "contact/contact_extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscoroll::detail {
namespace {

/// Half length of the ellipse with the second moment of `weights` along `coordinate`.
double semi_axis(const Eigen::ArrayXd& coordinate, const Eigen::ArrayXd& weights) {
  const double sum = std::max(weights.sum(), std::numeric_limits<double>::min());
  const double center = (coordinate * weights).sum() / sum;
  return 2.0 * std::sqrt(((coordinate - center).square() * weights).sum() / sum);
}

}  // namespace

ContactExtent contact_extent(const SurfaceWindow& nodes, const Eigen::ArrayXd& touching) {
  const double area = touching.sum();
  if (nodes.window().is_line()) return {.area = area, .semi_axis_x = 0.5 * area, .semi_axis_z = std::nullopt};
  return {.area = area, .semi_axis_x = semi_axis(nodes.x(), touching), .semi_axis_z = semi_axis(nodes.z(), touching)};
}

}  // namespace viscoroll::detail

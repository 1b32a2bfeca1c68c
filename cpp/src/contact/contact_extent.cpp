#include "contact/contact_extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscoroll::detail {
namespace {

/// Half length of the ellipse with the second moment of `weights` along `coordinate`, about their mean or a `center`.
double semi_axis(const Eigen::ArrayXd& coordinate, const Eigen::ArrayXd& weights, std::optional<double> center) {
  const double sum = std::max(weights.sum(), std::numeric_limits<double>::min());
  const double middle = center ? *center : (coordinate * weights).sum() / sum;
  return 2.0 * std::sqrt(((coordinate - middle).square() * weights).sum() / sum);
}

/// From one of the outermost patches to the other.
double width(const SurfaceWindow& nodes, const Eigen::ArrayXd& touching) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  const double first = (touching > 0.0).select(nodes.z(), kNowhere).minCoeff();
  const double last = (touching > 0.0).select(nodes.z(), -kNowhere).maxCoeff();
  return last - first + nodes.grid().radius * nodes.grid().theta_spacing;
}

}  // namespace

ContactExtent contact_extent(const SurfaceWindow& nodes, const Eigen::ArrayXd& touching,
                             std::optional<double> center_z) {
  const double area = touching.sum();
  if (nodes.window().is_line()) {
    return {.area = area, .semi_axis_x = 0.5 * area, .semi_axis_z = std::nullopt, .width = std::nullopt};
  }
  return {.area = area,
          .semi_axis_x = semi_axis(nodes.x(), touching, std::nullopt),
          .semi_axis_z = semi_axis(nodes.z(), touching, center_z),
          .width = width(nodes, touching)};
}

}  // namespace viscoroll::detail

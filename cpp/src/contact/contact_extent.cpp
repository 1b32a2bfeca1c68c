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

/// Distance between the outer sides of the outermost patches [m]; 0 without contact.
double width(const SurfaceGrid& grid, const Eigen::ArrayXd& z) {
  if (z.size() == 0) return 0.0;
  return z.maxCoeff() - z.minCoeff() + grid.radius * grid.theta_spacing;
}

}  // namespace

ContactExtent contact_extent(const SurfaceWindow& nodes, const std::vector<Eigen::Index>& contact,
                             const Eigen::ArrayXd& touching, const Eigen::ArrayXd& pressure,
                             std::optional<double> center_z) {
  const double area = touching.sum();
  const double max_pressure = contact.empty() ? 0.0 : pressure.maxCoeff();
  if (nodes.window().is_line()) {
    return {.contact_area = area,
            .semi_axis_x = 0.5 * area,
            .semi_axis_z = std::nullopt,
            .contact_width = std::nullopt,
            .max_pressure = max_pressure};
  }
  const Eigen::ArrayXd z = nodes.z()(contact);
  return {.contact_area = area,
          .semi_axis_x = semi_axis(nodes.x()(contact), touching, std::nullopt),
          .semi_axis_z = semi_axis(z, touching, center_z),
          .contact_width = width(nodes.grid(), z),
          .max_pressure = max_pressure};
}

}  // namespace viscoroll::detail

#include "rolling/body.hpp"

namespace viscoroll::detail {
namespace {

/// Of a circle below its highest point, 1/k - sqrt(1/k^2 - x^2), without the round-off of small curvatures.
Eigen::ArrayXd drop_of_circle(const Eigen::ArrayXd& x, double curvature) {
  return curvature * x.square() / (1.0 + (1.0 - (curvature * x).square()).max(0.0).sqrt());
}

}  // namespace

std::vector<NamedLayer> named(const std::vector<Layer>& layers) {
  std::vector<NamedLayer> named;
  named.reserve(layers.size());
  for (const Layer& layer : layers) {
    named.push_back({.name = "layers[" + std::to_string(named.size()) + "]", .layer = layer});
  }
  return named;
}

std::function<Profile(const SurfaceWindow&)> circles(const Curvatures& curvatures) {
  return [curvatures](const SurfaceWindow& points) -> Profile {
    const auto& [along, across] = curvatures;
    const Eigen::ArrayXd& x = points.x();
    const Eigen::ArrayXd& z = points.z();
    if (points.grid().is_paraboloid) {
      return {.drop = 0.5 * (along * x.square() + across * z.square()), .slope = along * x};
    }
    return {.drop = drop_of_circle(x, along) + drop_of_circle(z, across), .slope = along * x};
  };
}

}  // namespace viscoroll::detail

#include "rolling/body.hpp"

#include "modal/circle.hpp"

namespace viscoroll::detail {
namespace {

Eigen::ArrayXd drops(const Eigen::ArrayXd& x, double curvature) {
  return x.unaryExpr([curvature](double at) { return drop_of_circle(at, curvature); });
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

Profile circles(const Curvatures& curvatures, const SurfaceWindow& points) {
  const auto& [along, across] = curvatures;
  if (along == 0.0 && across == 0.0) return {};
  const Eigen::ArrayXd& x = points.x();
  const Eigen::ArrayXd& z = points.z();
  if (points.grid().is_paraboloid) {
    return {.drop = 0.5 * (along * x.square() + across * z.square()), .slope = along * x};
  }
  return {.drop = drops(x, along) + drops(z, across), .slope = along * x};
}

}  // namespace viscoroll::detail

#include "rolling/body.hpp"

#include <utility>

#include "modal/layered_body.hpp"

namespace viscoroll::detail {
namespace {

Eigen::ArrayXd drops(const Eigen::ArrayXd& x, double curvature) {
  return x.unaryExpr([curvature](double at) { return drop_of_circle(at, curvature); });
}

/// Height of every node above the lowest node of its column [m]. Its derivative with respect to r_o phi is the
/// undeformed x / r_o, so that the moment of the pressure is the derivative of the gap. The depth of a circle as a
/// function of x has another derivative, since the nodes are equally spaced along the arc. In a closely conforming
/// groove, where the gap is a small difference of two depths, this would violate the energy balance.
Eigen::ArrayXd height_along(const SurfaceWindow& points) {
  const SurfaceWindow middle(points.grid(), {{0, 0}, points.window().theta});
  return points.height() - middle.height().replicate(points.shape().phi_nodes, 1);
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
  const Eigen::ArrayXd& z = points.z();
  const bool is_paraboloid = points.grid().is_paraboloid;
  Eigen::ArrayXd drop = is_paraboloid ? Eigen::ArrayXd(0.5 * across * z.square()) : drops(z, across);
  if (along != 0.0) drop += along * points.grid().radius * height_along(points);
  return {.drop = std::move(drop), .slope = along * points.x()};
}

}  // namespace viscoroll::detail

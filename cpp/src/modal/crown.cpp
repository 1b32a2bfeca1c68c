#include "modal/crown.hpp"

#include <map>
#include <vector>

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Stack = LayerStack<cplx>;

/// Thicknesses of the crown's radius up to which the difference is linear enough in the curvature; closer ones, down to
/// those whose cylinder would have no core, are taken at kLinearRadius in proportion.
constexpr double kLeastRadius = 3.0;
constexpr double kLinearRadius = 20.0;

/// The layers without inertia, in another metric.
/// @param[in] surface place of the surface there
Stack moved(const Stack& layers, const Metric& metric, double surface) {
  Stack moved{.metric = metric, .within = layers.within, .media = layers.media};
  const double shift = surface - layers.media.back().outer;
  for (Medium<cplx>& medium : moved.media) {
    medium.inner += shift;
    medium.outer += shift;
    medium.inertia = 0.0;
  }
  return moved;
}

/// Orders of wave numbers in the layers of each, which are kept.
class MovedOrders {
 public:
  /// @param[in] metric where they are seen; a wheel's is turned, so that m and n change places
  MovedOrders(std::span<const OrderInLayers<cplx>> orders, const Metric& metric) {
    const double scale = metric.radius / orders.front().layers.metric.radius;
    for (const OrderInLayers<cplx>& order : orders) {
      auto stack = stacks_.find(&order.layers);
      if (stack == stacks_.end()) {
        stack = stacks_.emplace(&order.layers, moved(order.layers, metric, metric.surface())).first;
      }
      const double m = metric.is_wheel() ? order.n : order.m;
      const double n = metric.is_wheel() ? order.m : order.n;
      orders_.push_back({.layers = stack->second, .m = scale * m, .n = scale * n});
    }
  }

  [[nodiscard]] std::vector<Matrix3<cplx>> compliances() const {
    std::vector<Matrix3<cplx>> compliances(orders_.size());
    surface_compliances<cplx>(orders_, compliances);
    return compliances;
  }

 private:
  std::map<const Stack*, Stack> stacks_;
  std::vector<OrderInLayers<cplx>> orders_;
};

}  // namespace

void add_crown(std::span<const OrderInLayers<cplx>> orders, double crown_radius, std::span<Matrix3<cplx>> compliances) {
  if (orders.empty()) return;
  const Stack& layers = orders.front().layers;
  const double thickness = layers.media.back().outer - layers.media.front().inner;
  const bool is_close = crown_radius <= kLeastRadius * thickness;
  const double radius = is_close ? kLinearRadius * thickness : crown_radius;
  const auto crowned = MovedOrders(orders, {.radius = radius, .across = Way::line}).compliances();
  const auto plane =
      MovedOrders(orders, {.radius = layers.metric.radius, .along = Way::line, .across = Way::line}).compliances();
  const Eigen::PermutationMatrix<3> turned(Eigen::Vector3i(0, 2, 1));
  for (std::size_t i = 0; i < orders.size(); ++i) {
    compliances[i] += radius / crown_radius * (turned * crowned[i] * turned - plane[i]);
  }
}

}  // namespace viscoroll::detail

#include "modal/crown.hpp"

#include <map>
#include <vector>

namespace viscoroll::detail {
namespace {

/// Layers without inertia in another metric.
/// @param[in] surface position of the surface in that metric
template <class Scalar>
LayerStack<Scalar> moved(const LayerStack<Scalar>& layers, const Metric& metric, double surface) {
  LayerStack<Scalar> moved{.metric = metric, .inner_boundary = layers.inner_boundary, .media = layers.media};
  const double shift = surface - layers.media.back().outer;
  for (Medium<Scalar>& medium : moved.media) {
    medium.inner += shift;
    medium.outer += shift;
    medium.inertia = 0.0;
  }
  return moved;
}

/// Orders with the same wave numbers in another metric, and their layers.
template <class Scalar>
class MovedOrders {
 public:
  /// @param[in] metric the other metric; that of a wheel is rotated, so that m and n are exchanged
  MovedOrders(std::span<const OrderInLayers<Scalar>> orders, const Metric& metric) {
    const double scale = metric.radius / orders.front().layers.metric.radius;
    for (const OrderInLayers<Scalar>& order : orders) {
      auto stack = stacks_.find(&order.layers);
      if (stack == stacks_.end()) {
        stack = stacks_.emplace(&order.layers, moved(order.layers, metric, metric.surface())).first;
      }
      const double m = metric.is_wheel() ? order.n : order.m;
      const double n = metric.is_wheel() ? order.m : order.n;
      orders_.push_back({.layers = stack->second, .m = scale * m, .n = scale * n});
    }
  }

  [[nodiscard]] std::vector<Matrix3<Scalar>> compliances() const {
    std::vector<Matrix3<Scalar>> compliances(orders_.size());
    surface_compliances<Scalar>(orders_, compliances);
    return compliances;
  }

 private:
  std::map<const LayerStack<Scalar>*, LayerStack<Scalar>> stacks_;
  std::vector<OrderInLayers<Scalar>> orders_;
};

}  // namespace

template <class Scalar>
void add_crown(std::span<const OrderInLayers<Scalar>> orders, const Crown& crown,
               std::span<Matrix3<Scalar>> compliances) {
  if (orders.empty()) return;
  const LayerStack<Scalar>& layers = orders.front().layers;
  const auto crowned = MovedOrders<Scalar>(orders, {.radius = crown.radius, .across = AxisKind::line}).compliances();
  const auto plane =
      MovedOrders<Scalar>(orders, {.radius = layers.metric.radius, .along = AxisKind::line, .across = AxisKind::line})
          .compliances();
  const Eigen::PermutationMatrix<3> turned(Eigen::Vector3i(0, 2, 1));
  for (std::size_t i = 0; i < orders.size(); ++i) {
    compliances[i] += crown.proportion * (turned * crowned[i] * turned - plane[i]);
  }
}

template void add_crown(std::span<const OrderInLayers<double>>, const Crown&, std::span<Matrix3<double>>);
template void add_crown(std::span<const OrderInLayers<std::complex<double>>>, const Crown&,
                        std::span<Matrix3<std::complex<double>>>);

}  // namespace viscoroll::detail

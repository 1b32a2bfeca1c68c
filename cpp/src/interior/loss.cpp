// Energy dissipated inside the layers under the window of a contact.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "influence/fft.hpp"
#include "influence/legendre.hpp"
#include "influence/order_bands.hpp"
#include "interior/inside.hpp"
#include "interior/load_spectrum.hpp"
#include "interior/loss_sum.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll {
namespace detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using std::numbers::pi;

ArrayXd whole_numbers(int highest) { return ArrayXd::LinSpaced(highest + 1, 0.0, highest); }

/// Orders m along the path, with the weights of an integral over them. In a periodic direction they are whole numbers,
/// of which 0 dissipates nothing; on a plane, Gauss points on panels.
struct OrdersAlong {
  std::vector<double> orders;
  std::vector<double> weights;

  OrdersAlong(const Metric& metric, int highest) {
    if (metric.is_curved()) {
      for (int m = 0; m <= highest; ++m) orders.push_back(m);
      weights.assign(orders.size(), 1.0);
      weights.front() = 0.0;
      return;
    }
    // The wavelength is 1e4 revolutions. Lower orders together contribute at most this fraction of one order's
    // dissipation.
    constexpr double kLowest = 1e-4;
    constexpr double kLossPanelRatio = 1.5;  // the response of layers is smooth in ln(m)
    const double widest = 0.05 * highest;    // tractions vary on the scale r / a in m, typically up to 40 r / a
    const auto [points, gauss] = gauss_legendre(8);
    for (double low = kLowest; low < highest;) {
      const double high = std::min({kLossPanelRatio * low, low + widest, static_cast<double>(highest)});
      for (Index i = 0; i < points.size(); ++i) {
        orders.push_back(low + 0.5 * (high - low) * (1.0 + points[i]));
        weights.push_back(0.5 * (high - low) * gauss[i]);
      }
      low = high;
    }
  }
};

/// Orders n across the path. They are whole numbers; if the surface is straight across, parallel tracks are assumed at
/// a distance of some circumferences.
struct OrdersAcross {
  ArrayXd orders;
  int circumferences = 1;  ///< distance between tracks; half of the surface is free of tractions

  /// @param[in] metric metric of the body
  /// @param[in] width width of the tractions [rad]
  /// @param[in] highest highest order
  OrdersAcross(const Metric& metric, double width, int highest)
      : circumferences(metric.across == AxisKind::line ? std::max(1, static_cast<int>(std::ceil(width / pi))) : 1) {
    if (metric.across == AxisKind::nothing) highest = 0;
    orders = whole_numbers(highest * circumferences) / circumferences;
  }
};

double width_of(const Tractions& tractions, double radius) {
  return tractions.theta_nodes * grid_of(tractions, radius).theta_spacing;
}

LossOrders loss_orders(const Inside& inside, const Tractions& tractions, int max_order) {
  const Metric& metric = inside.body.metric;
  OrdersAlong along(metric, max_order);
  OrdersAcross across(metric, width_of(tractions, metric.radius), max_order);
  const auto count = static_cast<int>(across.orders.size());
  // The orders are denser than whole numbers, so the sum is an integral over them.
  const double spacing = 1.0 / across.circumferences;
  return {.m = std::move(along.orders),
          .weights = std::move(along.weights),
          .n = std::move(across.orders),
          .spacing = spacing,
          .share = spacing,
          .theta_nodes = count == 1 ? 1 : ComplexFft::fast_length(2 * count),
          .highest = std::numbers::sqrt2 * max_order,
          .measured_order = measured_order(tractions.mesh) * metric.radius / tractions.radius};
}

}  // namespace
}  // namespace detail

LossDensity loss_density(const LayeredShape& shape, double angular_speed, const Tractions& tractions,
                         std::span<const Place> places, int max_order, int threads, const Observer& observer) {
  const detail::Inside inside = detail::inside_of(shape, angular_speed, tractions);
  detail::require_layers_and_speed(inside.body, inside.angular_speed);
  detail::require_thread_count(threads);
  detail::require_count("max_order", max_order, 1, detail::kHighestLossOrder);
  detail::LossOrders orders = detail::loss_orders(inside, tractions, max_order);
  auto nodes = detail::volume_nodes(inside.body, orders.m.front(), max_order);
  detail::LoadSpectrum loads(tractions, inside.body.metric,
                             Eigen::Map<const Eigen::ArrayXd>(orders.m.data(), std::ssize(orders.m)), orders.n);
  detail::Watch watch(observer);
  return detail::density_at(inside, std::move(orders), std::move(nodes), places, std::move(loads), threads, watch);
}

}  // namespace viscoroll

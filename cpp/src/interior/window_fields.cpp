// Fields on surfaces r = const inside the layers under the window of a contact.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "influence/order_bands.hpp"
#include "interior/field_sum.hpp"
#include "interior/inside.hpp"
#include "interior/load_spectrum.hpp"
#include "modal/depth_cut.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll {
namespace detail {
namespace {

/// Exponent of the decay with depth at which sums end smoothly. The tractions contain little of these orders, so that
/// the omitted part is 1e-6 of the field.
constexpr double kEnd = 9.0;
constexpr double kFieldDecay = 12.0;

/// Largest distance from the lowest point at which fields are evaluated, in one direction.
struct Extent {
  double largest;    // [rad]
  const char* name;  // in messages

  static Extent along(AxisKind kind) {
    using std::numbers::pi;
    if (kind == AxisKind::ring) return {pi, "within half a revolution of pi/2 rad"};
    return {2.0 * pi / 3.0, "within a third of a revolution of pi/2 rad"};  // beyond, the low orders are inaccurate
  }

  static Extent across(AxisKind kind) {
    using std::numbers::pi;
    switch (kind) {
      case AxisKind::ring:
        return along(kind);
      case AxisKind::line:  // a wheel twelve times as wide as its radius
        return {2.0 * pi, "within a revolution of pi/2 rad"};
      default:
        return {1e-12, "pi/2 rad in line contact"};
    }
  }
};

std::vector<double> from_lowest_point(const char* name, std::span<const double> angles, const Extent& extent) {
  constexpr double kLowest = 0.5 * std::numbers::pi;
  std::vector<double> offsets;
  for (const double angle : angles) {
    if (!(std::abs(angle - kLowest) <= extent.largest)) reject(name, extent.name, text(angle) + " rad");
    offsets.push_back(angle - kLowest);
  }
  return offsets;
}

/// Largest offset of points from loads; in a periodic direction at most half a revolution.
double largest_offset(std::span<const double> offsets, int nodes, double spacing, AxisKind kind) {
  double largest = 0.0;
  for (const double offset : offsets) largest = std::max(largest, std::abs(offset));
  largest += 0.5 * (nodes + 1) * spacing;
  return kind == AxisKind::ring ? std::min(largest, std::numbers::pi) : largest;
}

/// Orders of the sum over the window of a contact.
class WindowOrders {
 public:
  WindowOrders(const Inside& inside, const Tractions& tractions, const Offsets& offsets, double highest_order)
      : inside_(inside), tractions_(tractions), offsets_(offsets), highest_order_(highest_order) {}

  [[nodiscard]] SummedOrders all() const {
    return {.m = WeightedOrders(phi_bands()),
            .n = WeightedOrders(theta_bands()),
            .measured_order = measured_order(tractions_.mesh) * metric().radius / tractions_.radius,
            .decay = kFieldDecay};
  }

 private:
  [[nodiscard]] const Metric& metric() const { return inside_.body.metric; }

  [[nodiscard]] std::vector<OrderBand> bands(double spacing, double largest, double rough) const {
    const Mesh& mesh = tractions_.mesh;
    if (mesh.max_order) {
      return whole_orders(
          static_cast<int>(std::min<double>(*mesh.max_order, std::ceil(kFieldDecay / kEnd * highest_order_))),
          mesh.nodes_per_revolution);
    }
    return octaves_within(spacing, highest_order_, largest, rough);
  }

  [[nodiscard]] std::vector<OrderBand> phi_bands() const {
    const double spacing = grid_of(tractions_, metric().radius).phi_spacing;
    const double largest = largest_offset(offsets_.phi, tractions_.phi_nodes, spacing, metric().along);
    if (!metric().is_curved()) {
      // In sums that also run across the path, the waves below an order contribute in proportion to it: here 1e-6 of an
      // octave. This also holds for a line contact on a rigid base. The displacement of a half-plane has no longest
      // wave.
      const bool is_unbounded = !std::isfinite(inside_.body.boundaries.front());
      const LowestOrder lowest = metric().across == AxisKind::nothing && is_unbounded
                                     ? LowestOrder{}
                                     : LowestOrder{.share = 1e-6, .represents_longer_waves = true};
      return unbounded_octaves_within(spacing, highest_order_, largest, lowest, refinement_of(inside_.body.layers));
    }
    return bands(spacing, largest, material_rough_orders(inside_.body, inside_.angular_speed, tractions_.mesh));
  }

  [[nodiscard]] std::vector<OrderBand> theta_bands() const {
    const double spacing = grid_of(tractions_, metric().radius).theta_spacing;
    if (metric().across == AxisKind::nothing) return whole_orders(0, 1);
    const double largest = largest_offset(offsets_.theta, tractions_.theta_nodes, spacing, metric().across);
    if (metric().across == AxisKind::line) {
      // The material has no memory across the path. On a rigid base the lowest order therefore differs from longer
      // waves only by its square.
      const bool is_held = std::isfinite(inside_.body.boundaries.front());
      const LowestOrder lowest{.share = metric().is_wheel() ? 1e-9
                                        : is_held           ? 1e-4
                                                            : 1e-6,
                               .represents_longer_waves = true};
      return unbounded_octaves_within(spacing, highest_order_, largest, lowest);
    }
    return bands(spacing, largest, 0.0);
  }

  const Inside& inside_;
  const Tractions& tractions_;
  const Offsets& offsets_;
  double highest_order_;
};

/// Order at which the sum ends smoothly.
double highest_order(const Inside& inside, std::span<const Place> places, double max_order) {
  const DepthLimit limit(inside.body, inside.angular_speed);
  double highest = 0.0;
  for (const Place& place : places) highest = std::max(highest, limit(place.position, kEnd));
  return std::min(highest, max_order);
}

}  // namespace
}  // namespace detail

InteriorFields interior_fields(const LayeredShape& shape, double angular_speed, const Tractions& tractions,
                               std::span<const Place> places, std::span<const double> phi,
                               std::span<const double> theta, std::optional<double> max_order, int threads,
                               const Observer& observer) {
  using detail::Extent;
  const detail::Inside inside = detail::inside_of(shape, angular_speed, tractions);
  const detail::Metric& metric = inside.body.metric;
  if (max_order) detail::require_positive("max_order", *max_order, "");
  detail::require_thread_count(threads);
  InteriorFields fields{.places = {places.begin(), places.end()},
                        .phi = {phi.begin(), phi.end()},
                        .theta = {theta.begin(), theta.end()},
                        .values = std::vector<double>(places.size() * kFieldComponents * phi.size() * theta.size())};
  if (fields.values.empty()) return fields;
  detail::Watch watch(observer);
  const detail::Offsets offsets{.phi = detail::from_lowest_point("phi", phi, Extent::along(metric.along)),
                                .theta = detail::from_lowest_point("theta", theta, Extent::across(metric.across))};
  const double highest =
      detail::highest_order(inside, places, max_order.value_or(std::numeric_limits<double>::infinity()));
  detail::SummedOrders orders = detail::WindowOrders(inside, tractions, offsets, highest).all();
  detail::LoadSpectrum loads(tractions, metric, orders.m.orders, orders.n.orders);
  detail::FieldSum(inside, places, offsets, std::move(orders), std::move(loads))
      .sum(fields.values.data(), threads, watch);
  return fields;
}

}  // namespace viscoroll

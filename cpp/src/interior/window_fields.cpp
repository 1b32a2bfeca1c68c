// Fields on surfaces r = const inside the layers: sum over orders along theta, then along phi.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "base/dense_products.hpp"
#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "influence/order_bands.hpp"
#include "interior/depth_transfer.hpp"
#include "interior/inside.hpp"
#include "interior/load_spectrum.hpp"
#include "modal/centrifugal.hpp"
#include "modal/depth_cut.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll {
namespace detail {
namespace {

using cplx = std::complex<double>;
using Eigen::ArrayXd;
using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Exponent of the decay with depth at which sums end smoothly. The tractions contain little of these orders, so that
/// the omitted part is 1e-6 of the field.
constexpr double kEnd = 9.0;
constexpr double kFieldDecay = 12.0;
constexpr DepthTransfers::Accuracy kFieldAccuracy{.tolerance = 1e-8, .inertia = 1e-6};

constexpr auto kComponents = static_cast<Index>(kFieldComponents);

/// Orders of one direction, ascending, with their weights in the sum.
struct WeightedOrders {
  ArrayXd orders;
  ArrayXd weights;

  explicit WeightedOrders(const std::vector<OrderBand>& bands) {
    std::vector<std::pair<double, double>> all;
    for (const OrderBand& band : bands) {
      for (Index i = 0; i < band.orders.size(); ++i) all.emplace_back(band.orders[i], band.weights[i]);
    }
    std::ranges::sort(all);
    orders.resize(static_cast<Index>(all.size()));
    weights.resize(orders.size());
    for (Index i = 0; i < orders.size(); ++i) {
      std::tie(orders[i], weights[i]) = all[static_cast<std::size_t>(i)];
    }
  }

  [[nodiscard]] Index count_up_to(double highest) const {
    return std::ranges::upper_bound(orders, highest) - orders.begin();
  }
};

/// Angles from the lowest point as magnitude and sign, since cosines and sines depend on the magnitude up to a sign.
struct Angles {
  ArrayXd magnitudes;             // ascending
  std::vector<Index> number;      // index of the magnitude of each angle
  std::vector<bool> is_negative;  // whether each angle is negative

  explicit Angles(std::span<const double> angles) {
    std::vector<double> unique;
    constexpr double kSame = 1e-12;  // angles of mesh nodes have round-off
    for (const double angle : angles) unique.push_back(std::abs(angle));
    std::ranges::sort(unique);
    const auto repeated = std::ranges::unique(unique, [](double a, double b) { return b - a < kSame; });
    unique.erase(repeated.begin(), repeated.end());
    magnitudes = Eigen::Map<const ArrayXd>(unique.data(), static_cast<Index>(unique.size()));
    for (const double angle : angles) {
      number.push_back(std::ranges::upper_bound(unique, std::abs(angle) + kSame) - unique.begin() - 1);
      is_negative.push_back(angle < 0.0);
    }
  }
};

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

/// Fields at given places and angles, summed over the orders n and then over the orders m.
class WindowSum {
 public:
  WindowSum(const Inside& inside, const Tractions& tractions, std::span<const Place> places,
            std::span<const double> phi, std::span<const double> theta, std::optional<double> max_order)
      : places_(places),
        max_order_(max_order.value_or(std::numeric_limits<double>::infinity())),
        cuts_(inside.body, places),
        limit_(inside.body, inside.angular_speed),
        phi_(from_lowest_point("phi", phi, Extent::along(inside.body.metric.along))),
        theta_(from_lowest_point("theta", theta, Extent::across(inside.body.metric.across))),
        along_(phi_),
        across_(theta_),
        m_(phi_bands(inside, tractions)),
        n_(theta_bands(inside.body, tractions)),
        body_(inside.body, inside.angular_speed, {m_.orders.begin(), m_.orders.end()},
              measured_order(tractions.mesh) * inside.body.metric.radius / tractions.radius),
        loads_(tractions, inside.body.metric, m_.orders, n_.orders) {}

  void sum(double* values, int threads, Watch& watch) const {
    const auto columns = static_cast<double>(kFieldComponents * mirrors().size()) *
                         static_cast<double>(across_.magnitudes.size() * 2 * m_.orders.size());
    constexpr double kMaxNumbers = 3e7;
    const auto share = std::max<std::size_t>(1, static_cast<std::size_t>(kMaxNumbers / std::max(columns, 1.0)));
    const auto field = kFieldComponents * phi_.size() * theta_.size();
    for (std::size_t first = 0; first < places_.size(); first += share) {
      const std::size_t last = std::min(first + share, places_.size());
      const auto waves = sum_along_theta(first, last, threads, watch);
      parallel_for(last - first, threads, watch, "fields inside", [&](std::size_t i, const Worker& worker) {
        sum_along_phi(waves[i], values + (first + i) * field, worker);
      });
    }
    add_centrifugal(values);
  }

 private:
  [[nodiscard]] double highest_order() const {
    double highest = 0.0;
    for (const Place& place : places_) highest = std::max(highest, limit_(place.position, kEnd));
    return std::min(highest, max_order_);
  }

  [[nodiscard]] std::vector<OrderBand> bands(double spacing, double largest, double rough, const Mesh& mesh) const {
    if (mesh.max_order) {
      return whole_orders(
          static_cast<int>(std::min<double>(*mesh.max_order, std::ceil(kFieldDecay / kEnd * highest_order()))),
          mesh.nodes_per_revolution);
    }
    return octaves_within(spacing, highest_order(), largest, rough);
  }

  [[nodiscard]] std::vector<OrderBand> phi_bands(const Inside& inside, const Tractions& tractions) const {
    const double spacing = grid_of(tractions, inside.body.metric.radius).phi_spacing;
    const double largest = largest_offset(phi_, tractions.phi_nodes, spacing, inside.body.metric.along);
    if (!inside.body.metric.is_curved()) {
      // In sums that also run across the path, the waves below an order contribute in proportion to it: here 1e-6 of an
      // octave. This also holds for a line contact on a rigid base. The displacement of a half-plane has no longest
      // wave.
      const bool is_unbounded = !std::isfinite(inside.body.boundaries.front());
      const LowestOrder lowest = inside.body.metric.across == AxisKind::nothing && is_unbounded
                                     ? LowestOrder{}
                                     : LowestOrder{.share = 1e-6, .represents_longer_waves = true};
      return unbounded_octaves_within(spacing, highest_order(), largest, lowest, refinement_of(inside.body.layers));
    }
    return bands(spacing, largest, material_rough_orders(inside.body, inside.angular_speed, tractions.mesh),
                 tractions.mesh);
  }

  [[nodiscard]] std::vector<OrderBand> theta_bands(const LayeredBody& body, const Tractions& tractions) const {
    const Metric& metric = body.metric;
    const double spacing = grid_of(tractions, metric.radius).theta_spacing;
    if (metric.across == AxisKind::nothing) return whole_orders(0, 1);
    const double largest = largest_offset(theta_, tractions.theta_nodes, spacing, metric.across);
    if (metric.across == AxisKind::line) {
      // The material has no memory across the path. On a rigid base the lowest order therefore differs from longer
      // waves only by its square.
      const bool is_held = std::isfinite(body.boundaries.front());
      const LowestOrder lowest{.share = body.metric.is_wheel() ? 1e-9
                                        : is_held              ? 1e-4
                                                               : 1e-6,
                               .represents_longer_waves = true};
      return unbounded_octaves_within(spacing, highest_order(), largest, lowest);
    }
    return bands(spacing, largest, 0.0, tractions.mesh);
  }

  [[nodiscard]] std::vector<Mirror> mirrors() const {
    std::vector<Mirror> kinds;
    for (const Mirror mirror : {Mirror::same, Mirror::opposite}) {
      if (loads_.has(mirror)) kinds.push_back(mirror);
    }
    return kinds;
  }

  /// For each place, a row for the real and one for the imaginary part of every order m that matters there; columns are
  /// [mirror][component][magnitude of theta].
  [[nodiscard]] std::vector<RowMajor> sum_along_theta(std::size_t first, std::size_t last, int threads,
                                                      Watch& watch) const {
    std::vector<RowMajor> sums(last - first);
    double highest = 0.0;
    for (std::size_t place = first; place < last; ++place) {
      const double limit = limit_(places_[place].position, kFieldDecay);
      highest = std::max(highest, limit);
      sums[place - first].setZero(2 * m_.count_up_to(limit),
                                  static_cast<Index>(mirrors().size()) * kComponents * across_.magnitudes.size());
    }
    std::vector<std::size_t> boundaries;
    for (std::size_t place = first; place < last; ++place) boundaries.push_back(cuts_.boundary(place));
    const double most = std::hypot(m_.orders[m_.orders.size() - 1], n_.orders[n_.orders.size() - 1]);
    const DepthTransfers transfers(body_, cuts_, boundaries, std::min(most, highest), loads_.loaded(), kFieldAccuracy);
    const RowMajor phase = n_.orders.matrix() * across_.magnitudes.matrix().transpose();
    const Waves waves{.cosines = phase.array().cos(), .sines = phase.array().sin()};
    const auto count = static_cast<std::size_t>(m_.count_up_to(highest));
    const std::size_t group = transfers.at_once();
    parallel_for((count + group - 1) / group, threads, watch, "fields inside",
                 [&](std::size_t i, const Worker& worker) {
                   const std::size_t begin = i * group;
                   const double m = m_.orders[static_cast<Index>(begin)];
                   const ArrayXd n = n_.orders.head(reach(m, highest));
                   auto order = static_cast<Index>(begin);
                   for (const DepthTransfer& transfer : transfers.at(begin, std::min(group, count - begin), n)) {
                     worker.checkpoint();
                     add_order(order++, first, transfer, waves, sums, worker);
                   }
                 });
    return sums;
  }

  /// Waves of every order n at every magnitude of theta.
  struct Waves {
    RowMajor cosines;
    RowMajor sines;
  };

  [[nodiscard]] bool is_line() const { return body_.metric().across == AxisKind::nothing; }

  /// Number of orders n up to k = `limit`.
  [[nodiscard]] Index reach(double m, double limit) const { return n_.count_up_to(std::sqrt(limit * limit - m * m)); }

  void add_order(Index i, std::size_t first, const DepthTransfer& transfer, const Waves& waves,
                 std::vector<RowMajor>& sums, const Worker& worker) const {
    const double m = m_.orders[i];
    const auto layers = body_.layers_at(static_cast<std::size_t>(i));
    const auto kinds = mirrors();
    ComponentRows state;
    ComponentRows basis;
    ComponentRows fields;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const LoadRows loads = loads_.loads(kinds[k], i);
      for (std::size_t p = 0; p < sums.size(); ++p) {
        const Place& place = places_[first + p];
        const double limit = limit_(place.position, kFieldDecay);
        if (m > limit) continue;
        const Index count = reach(m, limit);
        transfer.state(p, count, loads, state);
        field_basis(layers.metric, place.position, m, n_.orders.head(count), state, basis);
        components_of(layers.media[static_cast<std::size_t>(place.layer)], layers.metric.length(place.position),
                      sum_over_n(basis, kinds[k], waves), fields);
        const auto width = across_.magnitudes.size();
        for (Index c = 0; c < kComponents; ++c) {
          auto sum = sums[p].block(2 * i, (static_cast<Index>(k) * kComponents + c) * width, 2, width);
          sum.row(0) = fields.row(c).real();
          sum.row(1) = fields.row(c).imag();
        }
        worker.checkpoint();
      }
    }
  }

  /// Sum over n: one column per magnitude of theta instead of one per n.
  [[nodiscard]] ComponentRows sum_over_n(const ComponentRows& basis, Mirror mirror, const Waves& waves) const {
    const Index count = basis.cols();
    ComponentRows sums(kBasisRows, across_.magnitudes.size());
    if (is_line()) {  // n = 0, theta = 0
      for (Index row = 0; row < kBasisRows; ++row) {
        const cplx value = n_.weights[0] * basis(row, 0);
        const bool odd = is_odd_in_theta(static_cast<Basis>(row)) != (mirror == Mirror::opposite);
        sums(row, 0) = odd ? 0.0 : is_imaginary(static_cast<Basis>(row)) ? cplx(-value.imag(), value.real()) : value;
      }
      return sums;
    }
    const Eigen::Array<double, 1, Eigen::Dynamic> weights = n_.weights.head(count).transpose();
    for (const bool odd : {false, true}) {
      // Under antisymmetric loads the even components have the sine.
      std::vector<Index> rows;
      for (Index row = 0; row < kBasisRows; ++row) {
        if ((is_odd_in_theta(static_cast<Basis>(row)) != (mirror == Mirror::opposite)) == odd) rows.push_back(row);
      }
      const auto size = static_cast<Index>(rows.size());
      RowMajor parts(2 * size, count);
      for (Index i = 0; i < size; ++i) {
        const Index row = rows[static_cast<std::size_t>(i)];
        // One factor i belongs to the component, another to the sine.
        const int quarters = (is_imaginary(static_cast<Basis>(row)) ? 1 : 0) + (odd ? 1 : 0);
        const Eigen::Array<double, 1, Eigen::Dynamic> real = weights * basis.row(row).real();
        const Eigen::Array<double, 1, Eigen::Dynamic> imaginary = weights * basis.row(row).imag();
        parts.row(2 * i) = quarters == 0 ? real : quarters == 1 ? -imaginary : -real;
        parts.row(2 * i + 1) = quarters == 0 ? imaginary : quarters == 1 ? real : -imaginary;
      }
      const Eigen::MatrixXd along_theta = product(parts, (odd ? waves.sines : waves.cosines).topRows(count));
      for (Index i = 0; i < size; ++i) {
        auto sum = sums.row(rows[static_cast<std::size_t>(i)]);
        sum.real() = along_theta.row(2 * i);
        sum.imag() = along_theta.row(2 * i + 1);
      }
    }
    return sums;
  }

  /// Sum over m of Re[(cos + i sin)(a + i b)] = a cos - b sin, whose two terms are even and odd in phi.
  void sum_along_phi(const RowMajor& waves, double* values, const Worker& worker) const {
    using Part = Eigen::Map<const RowMajor, 0, Eigen::OuterStride<>>;
    const Index orders = waves.rows() / 2;
    const Index columns = waves.cols();
    const RowMajor phase = along_.magnitudes.matrix() * m_.orders.head(orders).matrix().transpose();
    const auto weights = m_.weights.head(orders).transpose();
    const RowMajor cosines = phase.array().cos().rowwise() * weights;
    const RowMajor sines = phase.array().sin().rowwise() * -weights;
    const Eigen::OuterStride<> pairs(2 * columns);
    const Eigen::MatrixXd even = product(cosines, Part(waves.data(), orders, columns, pairs));
    worker.checkpoint();
    const Eigen::MatrixXd odd = product(sines, Part(waves.data() + columns, orders, columns, pairs));
    worker.checkpoint();
    const auto kinds = mirrors();
    const Index width = across_.magnitudes.size();
    for (Index c = 0; c < kComponents; ++c) {
      for (std::size_t i = 0; i < phi_.size(); ++i) {
        const auto row = along_.number[i];
        const double side = along_.is_negative[i] ? -1.0 : 1.0;
        for (std::size_t j = 0; j < theta_.size(); ++j) {
          double value = 0.0;
          for (std::size_t k = 0; k < kinds.size(); ++k) {
            const bool mirrored = is_odd_in_theta(static_cast<std::size_t>(c)) != (kinds[k] == Mirror::opposite);
            const Index column = (static_cast<Index>(k) * kComponents + c) * width + across_.number[j];
            const double part = even(row, column) + side * odd(row, column);
            value += mirrored && across_.is_negative[j] ? -part : part;
          }
          *values++ = value;
        }
      }
    }
  }

  void add_centrifugal(double* values) const {
    const LayeredBody& body = body_.body();
    const bool is_light = std::ranges::all_of(body.layers, [](const Layer& layer) { return layer.density == 0.0; });
    if (is_light || !body.metric.is_curved()) return;
    const auto layers = body_at_order_zero(body, body_.angular_speed()).layers_at(0);
    const auto states = centrifugal_states(cuts_.pieces(layers));
    const auto size = phi_.size() * theta_.size();
    ComponentRows fields;
    for (std::size_t place = 0; place < places_.size(); ++place) {
      ComponentRows state = ComponentRows::Zero(6, 1);
      state(0, 0) = states[cuts_.boundary(place)](0);
      state(3, 0) = states[cuts_.boundary(place)](1);
      field_components(layers, places_[place], 0.0, ArrayXd::Zero(1), state, fields);
      for (std::size_t c = 0; c < kFieldComponents; ++c) {
        const double share = fields(static_cast<Index>(c), 0).real();
        double* field = values + (place * kFieldComponents + c) * size;
        for (std::size_t i = 0; i < size; ++i) field[i] += share;
      }
    }
  }

  std::span<const Place> places_;
  double max_order_;
  LayerCuts cuts_;
  DepthLimit limit_;
  std::vector<double> phi_;
  std::vector<double> theta_;
  Angles along_;
  Angles across_;
  WeightedOrders m_;
  WeightedOrders n_;
  HarmonicBody body_;
  LoadSpectrum loads_;
};

}  // namespace
}  // namespace detail

InteriorFields interior_fields(const LayeredShape& shape, double angular_speed, const Tractions& tractions,
                               std::span<const Place> places, std::span<const double> phi,
                               std::span<const double> theta, std::optional<double> max_order, int threads,
                               const Observer& observer) {
  const detail::Inside inside = detail::inside_of(shape, angular_speed, tractions);
  if (max_order) detail::require_positive("max_order", *max_order, "");
  detail::require_thread_count(threads);
  InteriorFields fields{.places = {places.begin(), places.end()},
                        .phi = {phi.begin(), phi.end()},
                        .theta = {theta.begin(), theta.end()},
                        .values = std::vector<double>(places.size() * kFieldComponents * phi.size() * theta.size())};
  if (fields.values.empty()) return fields;
  detail::Watch watch(observer);
  detail::WindowSum(inside, tractions, places, phi, theta, max_order).sum(fields.values.data(), threads, watch);
  return fields;
}

}  // namespace viscoroll

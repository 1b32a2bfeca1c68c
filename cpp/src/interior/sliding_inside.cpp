// Fields and dissipation inside the layers under a sliding rough surface: docs/theory/inside.md.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/invalid_speed.hpp"
#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "interior/field_sum.hpp"
#include "interior/inside.hpp"
#include "interior/load_spectrum.hpp"
#include "interior/loss_sum.hpp"
#include "sliding/map_spectrum.hpp"
#include "sliding/sliding_input.hpp"
#include "sliding/sliding_symbol.hpp"
#include "viscoroll/sliding_interior.hpp"

namespace viscoroll {
namespace detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using std::numbers::pi;

/// Exponent of the decay with depth beyond which a wave is left out: that of `depth_states`.
constexpr double kPeriodicDecay = 36.0;

/// Circumference that converts wave numbers of a map without a period to orders, in units of its longer side.
constexpr double kCircumference = 4.0;

void validate_tractions(const SlidingTractions& tractions) {
  require_in({.minimum = 3.0}, "tractions.rows", tractions.rows);
  require_in({.minimum = 1.0}, "tractions.columns", tractions.columns);
  require_positive("tractions.spacing_x", tractions.spacing_x, "m");
  if (tractions.columns > 1) require_positive("tractions.spacing_z", tractions.spacing_z, "m");
  require_nonnegative("tractions.friction", tractions.friction, "");
  const auto count = static_cast<std::size_t>(tractions.rows) * static_cast<std::size_t>(tractions.columns);
  if (tractions.pressure.size() != count) {
    reject("tractions.pressure", "an array of " + std::to_string(count) + " values",
           std::to_string(tractions.pressure.size()) + " values");
  }
  for (const double pressure : tractions.pressure) require_finite("tractions.pressure", pressure);
}

void validate_inside(const CoatedPlane& on, double speed, const SlidingTractions& tractions, int threads) {
  validate_tractions(tractions);
  validate_below(on);
  require_nonnegative("speed", speed, "m/s");
  require_thread_count(threads);
}

/// Layers as they meet the tractions.
struct SlidingLayers {
  CoatedPlane plane;
  double angular_speed;  ///< of a body of the radius that converts wave numbers to orders
  double radius;         ///< that radius [m]
  double rate;           ///< sliding speed per `angular_speed` times `radius`: 1, or 0 at rest
};

SlidingLayers layers_under(const CoatedPlane& on, double speed, double radius) {
  if (speed > 0.0) return {.plane = on, .angular_speed = speed / radius, .radius = radius, .rate = 1.0};
  CoatedPlane relaxed = on;
  for (Layer& layer : relaxed.layers) relax_layer(layer);
  if (relaxed.base) {
    relaxed.base->shear_modulus = Elastic{relaxed_modulus(relaxed.base->shear_modulus)};
    relaxed.base->density = 0.0;
  }
  return {.plane = std::move(relaxed), .angular_speed = kAnySpeed, .radius = radius, .rate = 0.0};
}

/// Waves of periodic tractions. In the frame of the fields, phi = -x / r and theta = -z / r, so that the coefficient of
/// a wave is the complex conjugate of that of the map.
class PeriodicWaves {
 public:
  explicit PeriodicWaves(const SlidingTractions& tractions)
      : tractions_(tractions), length_x_(tractions.rows * tractions.spacing_x) {
    if (!is_line()) length_z_ = tractions.columns * tractions.spacing_z;
  }

  [[nodiscard]] bool is_line() const { return tractions_.columns == 1; }
  /// @return radius with which the lowest order of either direction is at least 1 [m]
  [[nodiscard]] double radius() const { return std::max(length_x_, length_z_) / (2.0 * pi); }
  /// @return period along z [m]; 0 in line contact
  [[nodiscard]] double length_z() const { return length_z_; }
  /// @return distance of the orders across
  [[nodiscard]] double spacing_across() const { return is_line() ? 1.0 : 2.0 * pi / length_z_ * radius(); }

  /// @param[in] first,last range of the waves along x
  [[nodiscard]] Eigen::ArrayXd along(int first, int last) const {
    return 2.0 * pi / length_x_ * radius() * Eigen::ArrayXd::LinSpaced(last - first + 1, first, last);
  }
  [[nodiscard]] Eigen::ArrayXd across() const {
    const int last = tractions_.columns / 2;
    return spacing_across() * Eigen::ArrayXd::LinSpaced(last + 1, 0.0, last);
  }
  /// @return number of the highest wave along x
  [[nodiscard]] int highest() const { return tractions_.rows / 2; }
  /// @return number of the highest wave along x that has a direction
  [[nodiscard]] int highest_with_direction() const { return (tractions_.rows - 1) / 2; }

  /// @return offset of a position from the origin, at most half a period
  [[nodiscard]] std::vector<double> offsets(std::span<const double> positions, double period) const {
    std::vector<double> offsets;
    offsets.reserve(positions.size());
    for (const double position : positions) offsets.push_back(-std::remainder(position, period) / radius());
    return offsets;
  }
  [[nodiscard]] Offsets offsets(std::span<const double> x, std::span<const double> z) const {
    return {.phi = offsets(x, length_x_),
            .theta = is_line() ? std::vector<double>(z.size(), 0.0) : offsets(z, length_z_)};
  }

  /// @brief Surface stresses of all waves.
  /// @param[in] first,last range of the waves along x
  /// @param[in] highest_across factor of the highest wave across of an even number of nodes. Its coefficient is that of
  /// the sum of two waves of opposite direction.
  [[nodiscard]] LoadSpectrum loads(int first, int last, double highest_across) const {
    const MapSpectrum pressure(tractions_.pressure, {tractions_.rows, tractions_.columns});
    const int last_j = tractions_.columns / 2;
    LoadSpectrum::Orders even(last - first + 1, last_j + 1);
    LoadSpectrum::Orders odd(even.rows(), even.cols());
    for (int i = first; i <= last; ++i) {
      for (int j = 0; j <= last_j; ++j) {
        // Coefficients of the waves (i, j) and (i, -j)
        const cplx forward = std::conj(pressure(i, j));
        const bool is_own_opposite = j == 0 || 2 * j == tractions_.columns;
        const cplx backward = is_own_opposite ? forward : pressure(-i, j);
        const double factor = radius() * (j > 0 && is_own_opposite ? highest_across : 1.0);
        even(i - first, j) = 0.5 * factor * (forward + backward);
        odd(i - first, j) = 0.5 * factor * (forward - backward);
      }
    }
    // sigma_rr = -p, and sigma_rphi = -friction p, which is i times its real form.
    const cplx along = cplx(0.0, 1.0) * tractions_.friction;
    LoadSpectrum::Stresses stresses;
    auto& [same, opposite] = stresses;
    same[0] = -even;
    opposite[0] = -odd;
    if (tractions_.friction > 0.0) {
      same[1] = along * even;
      opposite[1] = along * odd;
    }
    return LoadSpectrum{std::move(stresses)};
  }

 private:
  const SlidingTractions& tractions_;
  double length_x_;
  double length_z_ = 0.0;
};

WeightedOrders weighted(Eigen::ArrayXd orders) {
  Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(orders.size(), 2.0);
  weights[0] = 1.0;
  return {std::move(orders), std::move(weights)};
}

void add_periodic_fields(const SlidingLayers& layers, const PeriodicWaves& waves, SlidingFields& fields, int threads,
                         Watch& watch) {
  const Inside inside =
      inside_of(layers.plane, layers.angular_speed, layers.radius, waves.is_line(), Curvature::sphere);
  SummedOrders orders{.m = weighted(waves.along(0, waves.highest())),
                      .n = weighted(waves.across()),
                      .measured_order = std::numeric_limits<double>::infinity(),
                      .decay = kPeriodicDecay};
  // The highest wave along x of an even number of nodes is its own opposite.
  if (waves.highest() != waves.highest_with_direction()) orders.m.weights[waves.highest()] = 1.0;
  constexpr double kOfTwoWaves = 0.5;
  FieldSum(inside, fields.places, waves.offsets(fields.x, fields.z), std::move(orders),
           waves.loads(0, waves.highest(), kOfTwoWaves))
      .sum(fields.values.data(), threads, watch);
}

/// Loss at some of the places theta. At rest, the power and the frequencies of all waves are 0.
SlidingLoss loss_at(const LossDensity& lost, std::vector<double> z, const std::vector<std::size_t>& columns,
                    double track_distance, const SlidingLayers& layers) {
  SlidingLoss loss{.places = lost.places,
                   .z = std::move(z),
                   .density = {},
                   .frequency = {},
                   .wave_power = {},
                   .track_distance = track_distance,
                   .volume_power = layers.rate * lost.volume_power,
                   .surface_power = layers.rate * lost.surface_power};
  for (std::size_t place = 0; place < loss.places.size(); ++place) {
    for (const std::size_t column : columns) loss.density.push_back(lost.density[place * lost.theta.size() + column]);
  }
  for (const double order : lost.orders) loss.frequency.push_back(layers.rate * order * layers.angular_speed);
  for (const double power : lost.order_power) loss.wave_power.push_back(layers.rate * power);
  return loss;
}

SlidingLoss periodic_loss(const SlidingLayers& layers, const PeriodicWaves& waves, const SlidingTractions& tractions,
                          std::span<const Place> places, int threads, Watch& watch) {
  const Inside inside =
      inside_of(layers.plane, layers.angular_speed, layers.radius, waves.is_line(), Curvature::sphere);
  const Eigen::ArrayXd m = waves.along(1, waves.highest_with_direction());
  LossOrders orders{.m = {m.begin(), m.end()},
                    .weights = std::vector<double>(static_cast<std::size_t>(m.size()), 1.0),
                    .n = waves.across(),
                    .spacing = waves.spacing_across(),
                    .share = 1.0,
                    .theta_nodes = waves.is_line() ? 1 : 2 * tractions.columns,
                    .highest = std::hypot(m[m.size() - 1], waves.across().tail(1)[0]),
                    .measured_order = std::numeric_limits<double>::infinity()};
  // `SlidingResult` counts the highest wave across by its values at the nodes, whose mean square is twice that of a
  // cosine.
  const double of_nodes = std::sqrt(0.5);
  LoadSpectrum loads = waves.loads(1, waves.highest_with_direction(), of_nodes);
  WeightedPlaces nodes = volume_nodes(inside.body, orders.m.front(), orders.highest);
  const LossDensity lost =
      density_at(inside, std::move(orders), std::move(nodes), places, std::move(loads), threads, watch);
  // Every second place theta is at a node; theta falls with z.
  const std::size_t around = lost.theta.size();
  std::vector<double> z;
  std::vector<std::size_t> columns;
  for (int j = 0; j < tractions.columns; ++j) {
    z.push_back(waves.is_line() ? 0.0 : j * tractions.spacing_z);
    columns.push_back((around / 2 + 2 * around - 2 * static_cast<std::size_t>(j)) % around);
  }
  return loss_at(lost, std::move(z), columns, waves.length_z(), layers);
}

/// Tractions of a map without a period in the form of a contact of a rolling body, whose window has odd numbers of
/// nodes. Its middle is at the node (rows / 2, columns / 2) of the map.
struct MapWindow {
  Tractions tractions;
  double middle_x;
  double middle_z;
  double reach;  ///< largest distance from the middle at which fields are computed [m]
};

/// Number of the node in the middle.
double middle_of(int nodes) {
  const int middle = nodes / 2;
  return middle;
}

MapWindow window_of_map(const SlidingTractions& map) {
  const bool is_line = map.columns == 1;
  const int rows = map.rows + 1 - map.rows % 2;
  const int columns = map.columns + 1 - map.columns % 2;
  const double longer = std::max(rows * map.spacing_x, is_line ? 0.0 : columns * map.spacing_z);
  const double wanted = std::ceil(kCircumference * longer / map.spacing_x);
  const int nodes = static_cast<int>(std::min<double>(wanted, kMaxNodesPerRevolution));
  const double radius = nodes * map.spacing_x / (2.0 * pi);
  const auto count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
  MapWindow window{.tractions = {.mesh = Mesh{.nodes_per_revolution = nodes},
                                 .radius = radius,
                                 .theta_spacing = {},
                                 .crown_radius = {},
                                 .line = is_line,
                                 .phi_nodes = rows,
                                 .theta_nodes = columns,
                                 .pressure = std::vector<double>(count),
                                 .shear_traction = std::vector<double>(2 * count),
                                 .friction = map.friction > 0.0,
                                 .counterbody = true},
                   .middle_x = middle_of(map.rows) * map.spacing_x,
                   .middle_z = is_line ? 0.0 : middle_of(map.columns) * map.spacing_z,
                   .reach = radius * 2.0 * pi / 3.0};
  if (!is_line) window.tractions.theta_spacing = map.spacing_z / radius;
  for (int i = 0; i < map.rows; ++i) {
    for (int j = 0; j < map.columns; ++j) {
      const auto from =
          static_cast<std::size_t>(i) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(j);
      const auto to = static_cast<std::size_t>(rows - 1 - i) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(columns - 1 - j);
      window.tractions.pressure[to] = map.pressure[from];
      // The traction on the rough surface is opposite to that on the layers.
      window.tractions.shear_traction[to] = -map.friction * map.pressure[from];
    }
  }
  return window;
}

std::vector<double> angles_of(const char* name, std::span<const double> positions, double middle, double reach,
                              double radius) {
  const Range range{.unit = "m", .minimum = middle - reach, .maximum = middle + reach};
  std::vector<double> angles;
  angles.reserve(positions.size());
  for (const double position : positions) {
    require_in(range, name, position);
    angles.push_back(0.5 * pi - (position - middle) / radius);
  }
  return angles;
}

SlidingLoss finite_loss(const SlidingLayers& layers, const MapWindow& window, std::span<const Place> places,
                        double shortest_wave, int threads, const Observer& observer) {
  const double longest = 2.0 * pi * layers.radius;
  require_in({.unit = "m", .minimum = longest / kHighestLossOrder, .maximum = longest}, "shortest_wave", shortest_wave);
  const LossDensity lost = loss_density(layers.plane, layers.angular_speed, window.tractions, places,
                                        static_cast<int>(longest / shortest_wave), threads, observer);
  // The places theta go around a period between two tracks, of which the middle half contains the map; theta falls
  // with z.
  const std::size_t around = lost.theta.size();
  std::vector<double> z;
  std::vector<std::size_t> columns;
  for (std::size_t column = 3 * around / 4 + 1; column-- > around / 4;) {
    z.push_back(around == 1 ? 0.0 : window.middle_z + layers.radius * (0.5 * pi - lost.theta[column]));
    columns.push_back(column);
  }
  const double turn = around == 1 ? 0.0 : static_cast<double>(around) * (lost.theta[1] - lost.theta[0]);
  return loss_at(lost, std::move(z), columns, layers.radius * turn, layers);
}

}  // namespace
}  // namespace detail

SlidingTractions tractions_of(const HeightMap& map, const SlidingResult& result, double friction) {
  return {.rows = map.rows,
          .columns = map.columns,
          .spacing_x = map.spacing_x,
          .spacing_z = map.spacing_z,
          .periodic = map.periodic,
          .pressure = result.pressure,
          .friction = friction};
}

SlidingFields sliding_fields(const CoatedPlane& on, double speed, const SlidingTractions& tractions,
                             std::span<const Place> places, std::span<const double> x, std::span<const double> z,
                             int threads, const Observer& observer) {
  detail::validate_inside(on, speed, tractions, threads);
  for (const double position : x) detail::require_finite("x", position);
  for (const double position : z) detail::require_finite("z", position);
  SlidingFields fields{.places = {places.begin(), places.end()},
                       .x = {x.begin(), x.end()},
                       .z = {z.begin(), z.end()},
                       .values = std::vector<double>(places.size() * kFieldComponents * x.size() * z.size())};
  return detail::with_given_speed({.parameter = "speed", .value = speed, .unit = "m/s"}, [&] {
    if (tractions.periodic) {
      const detail::PeriodicWaves waves(tractions);
      const auto layers = detail::layers_under(on, speed, waves.radius());
      detail::Watch watch(observer);
      if (!fields.values.empty()) detail::add_periodic_fields(layers, waves, fields, threads, watch);
      return std::move(fields);
    }
    const auto window = detail::window_of_map(tractions);
    const double radius = window.tractions.radius;
    const auto layers = detail::layers_under(on, speed, radius);
    const auto phi = detail::angles_of("x", x, window.middle_x, window.reach, radius);
    const auto theta = window.tractions.line ? std::vector<double>(z.size(), 0.5 * std::numbers::pi)
                                             : detail::angles_of("z", z, window.middle_z, window.reach, radius);
    fields.values = interior_fields(layers.plane, layers.angular_speed, window.tractions, places, phi, theta,
                                    std::nullopt, threads, observer)
                        .values;
    return std::move(fields);
  });
}

SlidingLoss sliding_loss(const CoatedPlane& on, double speed, const SlidingTractions& tractions,
                         std::span<const Place> places, double shortest_wave, int threads, const Observer& observer) {
  detail::validate_inside(on, speed, tractions, threads);
  return detail::with_given_speed({.parameter = "speed", .value = speed, .unit = "m/s"}, [&] {
    if (tractions.periodic) {
      const detail::PeriodicWaves waves(tractions);
      const auto layers = detail::layers_under(on, speed, waves.radius());
      detail::Watch watch(observer);
      return detail::periodic_loss(layers, waves, tractions, places, threads, watch);
    }
    detail::require_positive("shortest_wave", shortest_wave, "m");
    const auto window = detail::window_of_map(tractions);
    const auto layers = detail::layers_under(on, speed, window.tractions.radius);
    return detail::finite_loss(layers, window, places, shortest_wave, threads, observer);
  });
}

}  // namespace viscoroll

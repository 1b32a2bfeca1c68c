#include "interior/loss_sum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "influence/legendre.hpp"
#include "interior/field_components.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::ArrayXd;
using Eigen::Index;
using std::numbers::pi;

constexpr double kLossDecay =
    14.0;  // exponent of the decay with depth beyond which the square of an order is negligible
/// Accuracy of the fields, whose squares are summed.
constexpr DepthTransfers::Accuracy kLossAccuracy{.tolerance = 1e-10, .inertia = 1e-9};
constexpr std::size_t kBlock = 8;  // orders summed consecutively, for any number of threads

/// Number of nodes of the volume integral through one layer: Gauss points in the square root of the depth, in which the
/// dissipation decays like a Gaussian at all orders.
/// @param[in] exponents exponent of the fastest decay through the layer
int radial_nodes(double exponents) { return 8 + static_cast<int>(std::ceil(1.6 * std::sqrt(exponents))); }

/// @param[in] outer,inner boundaries of a layer, or of a part of it
/// @param[in] layer index of the layer
/// @param[in] exponents exponent of the fastest decay from `outer` to `inner`
/// @param[in,out] nodes nodes are appended
void append_nodes(double outer, double inner, int layer, double exponents, WeightedPlaces& nodes) {
  const auto [points, weights] = gauss_legendre(radial_nodes(exponents));
  for (Index i = 0; i < points.size(); ++i) {
    const double y = 0.5 * (1.0 + points[i]);
    nodes.places.push_back({.position = outer - (outer - inner) * y * y, .layer = layer});
    nodes.weights.push_back((outer - inner) * y * weights[i]);
  }
}

/// Boundaries at all places, followed by the surface, where the tractions do work.
std::vector<std::size_t> boundaries_of(const LayerCuts& cuts, std::size_t places) {
  std::vector<std::size_t> boundaries;
  boundaries.reserve(places + 1);
  for (std::size_t place = 0; place < places; ++place) boundaries.push_back(cuts.boundary(place));
  boundaries.push_back(cuts.boundaries() - 1);
  return boundaries;
}

}  // namespace

WeightedPlaces volume_nodes(const LayeredBody& body, double lowest, double max_order) {
  // Exponent at the top of a layer up to which an order matters: 1e-10 of the dissipation.
  constexpr double kSeen = 12.0;
  constexpr double kCenter = 6.907755278982137;  // ln(1000): deep enough for a solid ball
  constexpr double kPart = 8.0;                  // ratio of the depths of successive parts of a half-space
  const Metric& metric = body.metric;
  WeightedPlaces nodes;
  for (std::size_t j = body.layers.size(); j-- > 0;) {
    const auto layer = static_cast<int>(j);
    const double outer = body.boundaries[j + 1];
    const double above = metric.depth(metric.surface(), outer);
    const double highest = above > 0.0 ? std::min(max_order, kSeen / above) : max_order;
    if (std::isfinite(body.boundaries[j])) {
      const double inner = body.boundaries[j];
      const double extent = metric.depth(outer, std::max(inner, metric.deeper_position(outer, kCenter)));
      append_nodes(outer, inner, layer, 2.0 * highest * extent, nodes);
      continue;
    }
    // Each order decays over its own wavelength; the growing parts cover all orders, down to the lowest.
    double from = 0.0;
    for (double to = kPart / highest; from < kSeen / lowest; from = to, to *= kPart) {
      append_nodes(metric.deeper_position(outer, from), metric.deeper_position(outer, to), layer, 2.0 * kSeen * kPart,
                   nodes);
    }
  }
  return nodes;
}

LossSum::LossSum(const Inside& inside, LossOrders orders, WeightedPlaces nodes, LoadSpectrum loads)
    : places_(std::move(nodes.places)),
      weights_(std::move(nodes.weights)),
      cuts_(inside.body, places_),
      limit_(inside.body, inside.angular_speed),
      orders_(std::move(orders)),
      body_(inside.body, inside.angular_speed, orders_.m, orders_.measured_order),
      loads_(std::move(loads)),
      transfers_(body_, cuts_, boundaries_of(cuts_, places_.size()), orders_.highest, loads_.loaded(), kLossAccuracy),
      transform_(orders_.theta_nodes) {}

LossDensity LossSum::sum(int threads, Watch& watch) const {
  const std::size_t count = orders_.m.size();
  std::vector<BlockLosses> blocks((count + kBlock - 1) / kBlock);
  parallel_for(blocks.size(), threads, watch, "loss inside", [&](std::size_t block, const Worker& worker) {
    BlockLosses& losses = blocks[block];
    losses.density.setZero(orders_.theta_nodes, static_cast<Index>(places_.size()));
    losses.by_order.setZero(static_cast<Index>(body_.body().layers.size()), kBlock);
    const std::size_t first = block * kBlock;
    const std::size_t last = std::min(first + kBlock, count);
    for (std::size_t order = first; order < last;) {
      const std::size_t group = std::min(transfers_.at_once(), last - order);
      for (const DepthTransfer& transfer : transfers_.at(order, group, orders_.n)) {
        if (orders_.weights[order] > 0.0) add_order(order, static_cast<Index>(order - first), transfer, losses);
        ++order;
        worker.checkpoint();
      }
    }
  });
  return collect(blocks, count);
}

void LossSum::add_order(std::size_t order, Index in_block, const DepthTransfer& transfer, BlockLosses& losses) const {
  const double m = orders_.m[order];
  const double weight = orders_.weights[order];
  const auto layers = body_.layers_at(order);
  const OrderLoads loads{.same = loads_.loads(Mirror::same, static_cast<Index>(order)),
                         .opposite = loads_.loads(Mirror::opposite, static_cast<Index>(order))};
  const double once_around = orders_.n.size() == 1 ? 1.0 : 2.0 * pi / orders_.spacing;
  ComplexBuffer line(static_cast<std::size_t>(orders_.theta_nodes));
  for (std::size_t p = 0; p < places_.size(); ++p) {
    const Place& place = places_[p];
    const double limit = limit_(place.position, kLossDecay);
    if (m > limit) continue;
    const double highest = std::min(std::sqrt(limit * limit - m * m), orders_.n[orders_.n.size() - 1]);
    const Index orders = std::ranges::upper_bound(orders_.n, highest) - orders_.n.begin();
    const ArrayXd density = weight * density_of(transfer, p, layers, m, orders, loads, line);
    losses.density.col(static_cast<Index>(p)) += density;
    const double measure = layers.metric.measure(place.position);
    losses.by_order(place.layer, in_block) += weights_[p] * measure * density.sum() * once_around / orders_.theta_nodes;
  }
  losses.surface += weight * surface_loss(transfer, places_.size(), m, loads);
}

/// Density w of order m at a place, over theta.
ArrayXd LossSum::density_of(const DepthTransfer& transfer, std::size_t p, const LayerStack<cplx>& layers, double m,
                            Index count, const OrderLoads& loads, ComplexBuffer& line) const {
  const Medium<cplx>& medium = layers.media[static_cast<std::size_t>(places_[p].layer)];
  const ArrayXd n = orders_.n.head(count);
  std::array<ComponentRows, 2> fields;
  for (const Mirror mirror : {Mirror::same, Mirror::opposite}) {
    if (!loads_.has(mirror)) continue;
    ComponentRows state;
    transfer.state(p, count, mirror == Mirror::same ? loads.same : loads.opposite, state);
    field_components(layers, places_[p], m, n, state, fields[static_cast<std::size_t>(mirror)]);
  }
  // Off-diagonal tensor components count twice.
  constexpr std::array kTimes{1.0, 1.0, 1.0, 2.0, 2.0, 2.0};
  ArrayXd square = ArrayXd::Zero(orders_.theta_nodes);
  Eigen::ArrayXcd trace = Eigen::ArrayXcd::Zero(orders_.theta_nodes);
  for (std::size_t c = 0; c < kTimes.size(); ++c) {
    to_theta(fields, kStrain + c, line);
    const Eigen::Map<const Eigen::ArrayXcd> strain(line.data(), orders_.theta_nodes);
    square += kTimes[c] * strain.abs2();
    if (c < 3) trace += strain;
  }
  const cplx b = medium.b;
  // K = mu (a + 2b/3) / b; an incompressible layer has no change of volume, hence no such dissipation.
  const double bulk = b == 0.0 ? 0.0 : (medium.mu * (1.0 - 4.0 / 3.0 * b) / b).imag();
  return 4.0 * pi * m * orders_.share * orders_.share *
         (2.0 * medium.mu.imag() * (square - trace.abs2() / 3.0) + bulk * trace.abs2());
}

/// Sum the fields of both symmetries over n of both signs, by a Fourier transform.
void LossSum::to_theta(const std::array<ComponentRows, 2>& fields, std::size_t component, ComplexBuffer& line) const {
  std::ranges::fill(line, 0.0);
  const auto row = static_cast<Index>(component);
  const double mirrored = is_odd_in_theta(component) ? -1.0 : 1.0;
  for (std::size_t kind = 0; kind < fields.size(); ++kind) {
    const double of_negative = kind == 0 ? mirrored : -mirrored;
    for (Index n = 0; n < fields[kind].cols(); ++n) {
      line[static_cast<std::size_t>(n)] += fields[kind](row, n);
      if (n > 0) line[static_cast<std::size_t>(orders_.theta_nodes - n)] += of_negative * fields[kind](row, n);
    }
  }
  transform_.backward(line.data());
}

/// Work of the tractions at order m: -A / r m Im(conj(f)^T u), with A the area of waves, (2 pi r)^2 on a sphere, over
/// orders of both signs. Times Omega it is a power.
double LossSum::surface_loss(const DepthTransfer& transfer, std::size_t boundary, double m,
                             const OrderLoads& loads) const {
  double sum = 0.0;
  for (const LoadRows* part : {&loads.same, &loads.opposite}) {
    ComponentRows state;
    transfer.state(boundary, orders_.n.size(), *part, state);
    // The two symmetries do no work on each other; order n = 0 occurs once.
    const ArrayXd work = (part->conjugate() * state.topRows(3)).imag().colwise().sum().transpose();
    sum += 2.0 * work.sum() - work[0];
  }
  return -2.0 * body_.metric().area_of_waves() / body_.radius() * (orders_.share * orders_.share / orders_.spacing) *
         m * sum;
}

LossDensity LossSum::collect(const std::vector<BlockLosses>& blocks, std::size_t count) const {
  const double speed = body_.angular_speed();
  const auto layers = body_.body().layers.size();
  Eigen::ArrayXXd density = Eigen::ArrayXXd::Zero(orders_.theta_nodes, static_cast<Index>(places_.size()));
  LossDensity loss{
      .places = places_, .weights = weights_, .theta = {}, .density = {}, .orders = orders_.m, .order_power = {}};
  loss.order_power.assign(layers * count, 0.0);
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    density += blocks[block].density;
    loss.surface_power += speed * blocks[block].surface;
    for (std::size_t layer = 0; layer < layers; ++layer) {
      for (std::size_t i = 0; i < kBlock && block * kBlock + i < count; ++i) {
        const double power = speed * blocks[block].by_order(static_cast<Index>(layer), static_cast<Index>(i));
        loss.order_power[layer * count + block * kBlock + i] = power;
        loss.volume_power += power;
      }
    }
  }
  // Transforms begin at the middle plane; results go around from -pi/2.
  const int half = orders_.theta_nodes / 2;
  const double around = 2.0 * pi / orders_.spacing;
  for (int j = 0; j < orders_.theta_nodes; ++j)
    loss.theta.push_back(0.5 * pi + around * (j - half) / orders_.theta_nodes);
  for (Index place = 0; place < density.cols(); ++place) {
    for (int j = 0; j < orders_.theta_nodes; ++j) {
      loss.density.push_back(density((j - half + orders_.theta_nodes) % orders_.theta_nodes, place));
    }
  }
  return loss;
}

LossDensity density_at(const Inside& inside, LossOrders orders, WeightedPlaces nodes, std::span<const Place> places,
                       LoadSpectrum loads, int threads, Watch& watch) {
  const std::size_t integrated = nodes.places.size();
  nodes.places.insert(nodes.places.end(), places.begin(), places.end());
  nodes.weights.resize(nodes.places.size(), 0.0);
  LossDensity loss = LossSum(inside, std::move(orders), std::move(nodes), std::move(loads)).sum(threads, watch);
  if (!places.empty()) {
    const auto size = static_cast<std::ptrdiff_t>(integrated);
    loss.places.erase(loss.places.begin(), loss.places.begin() + size);
    loss.weights.erase(loss.weights.begin(), loss.weights.begin() + size);
    loss.density.erase(loss.density.begin(),
                       loss.density.begin() + size * static_cast<std::ptrdiff_t>(loss.theta.size()));
  }
  return loss;
}

}  // namespace viscoroll::detail

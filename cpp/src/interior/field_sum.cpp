#include "interior/field_sum.hpp"

#include <cmath>
#include <complex>
#include <utility>

#include "base/dense_products.hpp"
#include "interior/field_components.hpp"
#include "modal/centrifugal.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::ArrayXd;

constexpr DepthTransfers::Accuracy kFieldAccuracy{.tolerance = 1e-8, .inertia = 1e-6};

constexpr auto kComponents = static_cast<Eigen::Index>(kFieldComponents);

}  // namespace

FieldSum::FieldSum(const Inside& inside, std::span<const Place> places, Offsets offsets, SummedOrders orders,
                   LoadSpectrum loads)
    : places_(places),
      cuts_(inside.body, places),
      limit_(inside.body, inside.angular_speed),
      offsets_(std::move(offsets)),
      along_(offsets_.phi),
      across_(offsets_.theta),
      m_(std::move(orders.m)),
      n_(std::move(orders.n)),
      decay_(orders.decay),
      body_(inside.body, inside.angular_speed, {m_.orders.begin(), m_.orders.end()}, orders.measured_order),
      loads_(std::move(loads)) {}

void FieldSum::sum(double* values, int threads, Watch& watch) const {
  const auto columns = static_cast<double>(kFieldComponents * mirrors().size()) *
                       static_cast<double>(across_.magnitudes.size() * 2 * m_.orders.size());
  constexpr double kMaxNumbers = 3e7;
  const auto share = std::max<std::size_t>(1, static_cast<std::size_t>(kMaxNumbers / std::max(columns, 1.0)));
  const auto field = kFieldComponents * offsets_.phi.size() * offsets_.theta.size();
  for (std::size_t first = 0; first < places_.size(); first += share) {
    const std::size_t last = std::min(first + share, places_.size());
    const auto waves = sum_along_theta(first, last, threads, watch);
    parallel_for(last - first, threads, watch, "fields inside", [&](std::size_t i, const Worker& worker) {
      sum_along_phi(waves[i], values + (first + i) * field, worker);
    });
  }
  add_centrifugal(values);
}

std::vector<Mirror> FieldSum::mirrors() const {
  std::vector<Mirror> kinds;
  for (const Mirror mirror : {Mirror::same, Mirror::opposite}) {
    if (loads_.has(mirror)) kinds.push_back(mirror);
  }
  return kinds;
}

/// For each place, a row for the real and one for the imaginary part of every order m that matters there; columns are
/// [mirror][component][magnitude of theta].
std::vector<FieldSum::RowMajor> FieldSum::sum_along_theta(std::size_t first, std::size_t last, int threads,
                                                          Watch& watch) const {
  std::vector<RowMajor> sums(last - first);
  double highest = 0.0;
  for (std::size_t place = first; place < last; ++place) {
    const double limit = limit_(places_[place].position, decay_);
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
  parallel_for((count + group - 1) / group, threads, watch, "fields inside", [&](std::size_t i, const Worker& worker) {
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

/// Number of orders n up to k = `limit`.
FieldSum::Index FieldSum::reach(double m, double limit) const {
  return n_.count_up_to(std::sqrt(limit * limit - m * m));
}

void FieldSum::add_order(Index i, std::size_t first, const DepthTransfer& transfer, const Waves& waves,
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
      const double limit = limit_(place.position, decay_);
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
ComponentRows FieldSum::sum_over_n(const ComponentRows& basis, Mirror mirror, const Waves& waves) const {
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
void FieldSum::sum_along_phi(const RowMajor& waves, double* values, const Worker& worker) const {
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
    for (std::size_t i = 0; i < offsets_.phi.size(); ++i) {
      const auto row = along_.number[i];
      const double side = along_.is_negative[i] ? -1.0 : 1.0;
      for (std::size_t j = 0; j < offsets_.theta.size(); ++j) {
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

void FieldSum::add_centrifugal(double* values) const {
  const LayeredBody& body = body_.body();
  const bool is_light = std::ranges::all_of(body.layers, [](const Layer& layer) { return layer.density == 0.0; });
  if (is_light || !body.metric.is_curved()) return;
  const auto layers = body_at_order_zero(body, body_.angular_speed()).layers_at(0);
  const auto states = centrifugal_states(cuts_.pieces(layers));
  const auto size = offsets_.phi.size() * offsets_.theta.size();
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

}  // namespace viscoroll::detail

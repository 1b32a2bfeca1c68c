#include "sliding/sliding_symbol.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/invalid_speed.hpp"
#include "influence/fft.hpp"
#include "modal/harmonic_body.hpp"
#include "modal/layered_body.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

std::vector<double> counted(int last) {
  std::vector<double> orders;
  for (int i = 1; i <= last; ++i) orders.push_back(i);
  return orders;
}

}  // namespace

LayeredBody relaxed_layers(LayeredBody body) {
  for (Layer& layer : body.layers) relax_layer(layer);
  return body;
}

double SlidingPeriod::patch_area() const {
  const double along = length_x / nodes.phi_nodes;
  return is_line() ? along : along * length_z / nodes.theta_nodes;
}

double SlidingPeriod::k_x(int i) const { return 2.0 * std::numbers::pi * i / length_x; }

double SlidingPeriod::k_z(int j) const { return 2.0 * std::numbers::pi * j / length_z; }

SlidingSymbol::SlidingSymbol(const CoatedPlane& on, const SlidingPeriod& period, double speed, double friction,
                             int threads, Watch& watch)
    : period_(period),
      values_(static_cast<std::size_t>(period.nodes.phi_nodes / 2 + 1) *
              static_cast<std::size_t>(period.nodes.theta_nodes / 2 + 1)) {
  if (friction > 0.0) losses_.resize(values_.size());
  const int last_i = period.nodes.phi_nodes / 2;
  const int last_j = period.nodes.theta_nodes / 2;
  // With this radius, the orders along the path are the numbers of the waves.
  const double radius = period.length_x / (2.0 * std::numbers::pi);
  const LayeredBody layers = layered_body(on, radius);
  const bool at_rest = speed == 0.0;
  const HarmonicBody body = with_given_speed({.parameter = "speed", .value = speed, .unit = "m/s"}, [&] {
    return at_rest ? HarmonicBody(relaxed_layers(layers), kAnySpeed, counted(last_i))
                   : HarmonicBody(layers, speed / radius, counted(last_i));
  });
  const Eigen::ArrayXd across = Eigen::ArrayXd::NullaryExpr(
      last_j + 1, [&](Eigen::Index j) { return period_.k_z(static_cast<int>(j)) * radius; });
  // The series of a profile, which has the order 0 only, also need an interval.
  constexpr double kFirstOrder = 1.0;
  const auto spectrum = make_spectrum(body, std::max(across[last_j], kFirstOrder), threads, watch);
  parallel_for(static_cast<std::size_t>(last_i), threads, watch, "solving layers",
               [&](std::size_t index, const Worker&) {
                 OrderSeries series;
                 spectrum->series(index, series);
                 const OrderValues values(body.orders()[index], across, series);
                 const auto first = static_cast<std::ptrdiff_t>(place(static_cast<int>(index) + 1, 0));
                 Eigen::ArrayXcd row;
                 values.evaluate(Entry::rr, row);
                 if (friction > 0.0) {
                   // The friction on the layers points along x, against xi, and the pressure inwards: the signs cancel.
                   Eigen::ArrayXcd along;
                   values.evaluate(Entry::phiphi, along);
                   std::ranges::copy(row + friction * friction * along, losses_.begin() + first);
                   values.evaluate(Entry::rphi, along);
                   row += friction * along;
                 }
                 std::ranges::copy(row, values_.begin() + first);
               });
  // The highest wave of an even number of nodes is its own negative.
  if (period.nodes.phi_nodes % 2 == 0) {
    for (int j = 0; j <= last_j; ++j) values_[place(last_i, j)] = values_[place(last_i, j)].real();
  }
  // Relaxed layers are isotropic: a wave along z has the compliance of an equally long wave along x.
  std::vector<double> orders(across.begin() + 1, across.end());
  orders.insert(orders.begin(), 1.0);
  const HarmonicBody resting(relaxed_layers(layers), kAnySpeed, orders);
  const auto relaxed = [&](std::size_t i) { return resting.compliance({.i = i, .n = 0.0})(0, 0).real(); };
  for (int j = 1; j <= last_j; ++j) values_[place(0, j)] = relaxed(static_cast<std::size_t>(j));
  values_[place(0, 0)] = last_j > 0 ? std::max(relaxed(0), relaxed(1)) : relaxed(0);
}

Table SlidingSymbol::table() const {
  const int rows = period_.nodes.phi_nodes;
  const int columns = period_.nodes.theta_nodes;
  const auto half_rows = static_cast<std::size_t>(rows / 2 + 1);
  const auto half_columns = static_cast<std::size_t>(columns / 2 + 1);
  const double normalization = 1.0 / (static_cast<double>(rows) * columns * period_.patch_area());
  std::vector<double> along(static_cast<std::size_t>(rows) * half_columns);  // [row][j]
  const RealFft phi_fft(rows);
  RealBuffer line(static_cast<std::size_t>(rows));
  ComplexBuffer half(half_rows);
  for (std::size_t j = 0; j < half_columns; ++j) {
    for (std::size_t i = 0; i < half_rows; ++i) half[i] = normalization * values_[i * half_columns + j];
    phi_fft.backward(half.data(), line.data());
    for (std::size_t row = 0; row < line.size(); ++row) along[row * half_columns + j] = line[row];
  }
  Table table(rows - 1, columns - 1, false);
  const RealFft theta_fft(columns);
  RealBuffer across(static_cast<std::size_t>(columns));
  ComplexBuffer half_row(half_columns);
  for (int row = 0; row < rows; ++row) {
    std::copy_n(along.begin() + row * static_cast<std::ptrdiff_t>(half_columns), half_columns, half_row.begin());
    theta_fft.backward(half_row.data(), across.data());
    std::ranges::copy(across, table.row(row).begin());
    if (row > 0) std::ranges::copy(across, table.row(row - rows).begin());
  }
  return table;
}

double memory_length(const CoatedPlane& on, double speed, double wavelength, double highest_frequency) {
  if (speed == 0.0) return 0.0;
  // With a single retardation time lambda, J(w) = J_g + (J_0 - J_g)/(1 + i w lambda), so that
  // |J(w) - J_0| / |J(w) - J_g| = w lambda.
  const std::array frequency{2.0 * std::numbers::pi * speed / wavelength};
  double longest = 0.0;
  for (const Layer& layer : layers_from_base(on)) {
    const cplx compliance = 1.0 / complex_modulus(layer.shear_modulus, frequency).front();
    const double recovered = 1.0 / relaxed_modulus(layer.shear_modulus);
    const double glassy = 1.0 / short_time_modulus(layer.shear_modulus, highest_frequency);
    const double missing = std::abs(compliance - recovered);
    if (missing > 1e-12 * recovered) longest = std::max(longest, missing / std::abs(compliance - glassy));
  }
  return longest * wavelength / (2.0 * std::numbers::pi);
}

}  // namespace viscoroll::detail

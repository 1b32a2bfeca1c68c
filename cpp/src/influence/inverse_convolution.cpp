#include "influence/inverse_convolution.hpp"

#include <algorithm>
#include <complex>

namespace viscoroll::detail {
namespace {

/// Least real part of the symbol, as a share of its largest value: round-off must not become a large inverse.
constexpr double kLeastShare = 1e-9;

WindowShape fast_shape(const WindowShape& shape) {
  return {fast_length(shape.phi_nodes), fast_length(shape.theta_nodes)};
}

}  // namespace

InverseConvolution::InverseConvolution(WindowShape shape, const Table& table, int threads, Watch& watch)
    : product_(shape, fast_shape(shape)) {
  const WindowShape period = product_.period();
  const auto value = [&](int j, int l) {
    const bool known = std::abs(j) <= table.phi_reach() && std::abs(l) <= table.theta_reach();
    return known ? table(j, l) : 0.0;
  };
  // On the circle, offset j stands for j and j - period, in proportion to the pairs of nodes at each.
  inverse_symbol_ = product_.spectrum(
      [&](int row, int column) {
        const double behind = static_cast<double>(row) / period.phi_nodes;
        const double aside = static_cast<double>(column) / period.theta_nodes;
        const int j = row - period.phi_nodes;
        const int l = column - period.theta_nodes;
        return (1.0 - behind) * ((1.0 - aside) * value(row, column) + aside * value(row, l)) +
               behind * ((1.0 - aside) * value(j, column) + aside * value(j, l));
      },
      threads, watch);
  const auto points = static_cast<double>(period.size());
  double largest = 0.0;
  for (const auto& symbol : inverse_symbol_) largest = std::max(largest, std::abs(symbol));
  for (auto& symbol : inverse_symbol_) {
    symbol = 1.0 / (points * points * std::complex<double>(std::max(symbol.real(), kLeastShare * largest), symbol.imag()));
  }
}

Eigen::ArrayXd InverseConvolution::apply(const Eigen::ArrayXd& field, int threads, Watch& watch) const {
  return product_.apply(field, {{0, &inverse_symbol_, 0, 1.0}}, 1, threads, watch);
}

}  // namespace viscoroll::detail

#include "influence/inverse_convolution.hpp"

#include <algorithm>
#include <complex>

namespace viscoroll::detail {
namespace {

/// Least real part of the symbol, as a share of its largest value: an error of periodicity must not become a large
/// inverse.
constexpr double kLeastShare = 1e-6;

}  // namespace

InverseConvolution::InverseConvolution(WindowShape shape, const Table& table)
    : shape_(shape),
      padded_phi_(fast_length(2 * shape.phi_nodes - 1)),
      padded_theta_(fast_length(2 * shape.theta_nodes - 1)),
      fft_(padded_phi_, padded_theta_),
      inverse_symbol_(fft_.spectrum_size()) {
  RealBuffer padded(fft_.real_size(), 0.0);
  for (int j = 1 - shape.phi_nodes; j < shape.phi_nodes; ++j) {
    for (int l = 1 - shape.theta_nodes; l < shape.theta_nodes; ++l) {
      const int row = j < 0 ? j + padded_phi_ : j;
      const int column = l < 0 ? l + padded_theta_ : l;
      padded[static_cast<std::size_t>(row) * static_cast<std::size_t>(padded_theta_) +
             static_cast<std::size_t>(column)] = table(j, l);
    }
  }
  fft_.forward(padded, inverse_symbol_);
  double largest = 0.0;
  for (const auto& value : inverse_symbol_) largest = std::max(largest, std::abs(value));
  const double normalization = 1.0 / static_cast<double>(fft_.real_size());
  for (auto& value : inverse_symbol_) {
    const std::complex<double> symbol(std::max(value.real(), kLeastShare * largest), value.imag());
    value = normalization / symbol;
  }
}

Eigen::ArrayXd InverseConvolution::apply(const Eigen::ArrayXd& field) const {
  RealBuffer padded(fft_.real_size(), 0.0);
  ComplexBuffer spectrum(fft_.spectrum_size());
  for (Eigen::Index i = 0; i < shape_.phi_nodes; ++i) {
    std::copy_n(field.data() + i * shape_.theta_nodes, shape_.theta_nodes, padded.begin() + i * padded_theta_);
  }
  fft_.forward(padded, spectrum);
  for (std::size_t k = 0; k < spectrum.size(); ++k) spectrum[k] *= inverse_symbol_[k];
  fft_.backward(spectrum, padded);
  Eigen::ArrayXd result(shape_.size());
  for (Eigen::Index i = 0; i < shape_.phi_nodes; ++i) {
    std::copy_n(padded.begin() + i * padded_theta_, shape_.theta_nodes, result.data() + i * shape_.theta_nodes);
  }
  return result;
}

}  // namespace viscoroll::detail

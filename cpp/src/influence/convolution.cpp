#include "influence/convolution.hpp"

#include <algorithm>

namespace viscoroll::detail {
namespace {

/// Index on a circle of `length` points.
std::size_t wrapped(int offset, int length) { return static_cast<std::size_t>(offset < 0 ? offset + length : offset); }

std::size_t count_results(const std::vector<ConvolutionTerm>& terms) {
  std::size_t count = 0;
  for (const ConvolutionTerm& term : terms) count = std::max(count, term.result + 1);
  return count;
}

}  // namespace

Convolution::Convolution(WindowShape shape, const std::vector<Table>& tables, std::vector<ConvolutionTerm> terms)
    : shape_(shape),
      terms_(std::move(terms)),
      results_(count_results(terms_)),
      padded_phi_(fast_length(2 * shape.phi_nodes - 1)),
      padded_theta_(fast_length(2 * shape.theta_nodes - 1)),
      fft_(padded_phi_, padded_theta_),
      table_spectra_(tables.size()) {
  const double normalization = 1.0 / static_cast<double>(fft_.real_size());
  RealBuffer padded(fft_.real_size());
  for (const ConvolutionTerm& term : terms_) {
    ComplexBuffer& spectrum = table_spectra_[term.table];
    if (!spectrum.empty()) continue;
    const Table& table = tables[term.table];
    std::fill(padded.begin(), padded.end(), 0.0);
    for (int j = 1 - shape.phi_nodes; j < shape.phi_nodes; ++j) {
      for (int l = 1 - shape.theta_nodes; l < shape.theta_nodes; ++l) {
        const std::size_t row = wrapped(j, padded_phi_) * static_cast<std::size_t>(padded_theta_);
        padded[row + wrapped(l, padded_theta_)] = normalization * table(j, l);
      }
    }
    spectrum.resize(fft_.spectrum_size());
    fft_.forward(padded, spectrum);
  }
}

void Convolution::load(const Eigen::ArrayXXd& operands, Eigen::Index field, RealBuffer& padded) const {
  std::fill(padded.begin(), padded.end(), 0.0);
  for (Eigen::Index i = 0; i < shape_.phi_nodes; ++i) {
    const double* row = operands.col(field).data() + i * shape_.theta_nodes;
    std::copy_n(row, shape_.theta_nodes, padded.begin() + i * padded_theta_);
  }
}

Eigen::ArrayXXd Convolution::apply(const Eigen::ArrayXXd& operands) const {
  using MutableSpectrum = Eigen::Map<Eigen::ArrayXcd>;
  using ConstSpectrum = Eigen::Map<const Eigen::ArrayXcd>;
  const auto size = static_cast<Eigen::Index>(fft_.spectrum_size());
  RealBuffer padded(fft_.real_size());

  std::vector<ComplexBuffer> spectra(static_cast<std::size_t>(operands.cols()), ComplexBuffer(fft_.spectrum_size()));
  for (std::size_t field = 0; field < spectra.size(); ++field) {
    load(operands, static_cast<Eigen::Index>(field), padded);
    fft_.forward(padded, spectra[field]);
  }

  Eigen::ArrayXXd results(shape_.size(), static_cast<Eigen::Index>(results_));
  ComplexBuffer sum(fft_.spectrum_size());
  for (std::size_t result = 0; result < results_; ++result) {
    MutableSpectrum(sum.data(), size).setZero();
    for (const ConvolutionTerm& term : terms_) {
      if (term.result != result) continue;
      MutableSpectrum(sum.data(), size) += term.sign * ConstSpectrum(table_spectra_[term.table].data(), size) *
                                           ConstSpectrum(spectra[term.operand].data(), size);
    }
    fft_.backward(sum, padded);
    double* column = results.col(static_cast<Eigen::Index>(result)).data();
    for (Eigen::Index i = 0; i < shape_.phi_nodes; ++i) {
      std::copy_n(padded.begin() + i * padded_theta_, shape_.theta_nodes, column + i * shape_.theta_nodes);
    }
  }
  return results;
}

}  // namespace viscoroll::detail

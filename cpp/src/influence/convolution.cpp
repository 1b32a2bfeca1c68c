#include "influence/convolution.hpp"

#include <algorithm>
#include <map>

namespace viscoroll::detail {
namespace {

/// Index on a circle of `length` points.
std::size_t wrapped(int offset, int length) { return static_cast<std::size_t>(offset < 0 ? offset + length : offset); }

}  // namespace

ScaledConvolution::ScaledConvolution(WindowShape shape, std::shared_ptr<const std::vector<Table>> tables,
                                     std::vector<Eigen::ArrayXd> scalings, std::vector<Term> terms)
    : shape_(shape),
      tables_(std::move(tables)),
      scalings_(std::move(scalings)),
      terms_(std::move(terms)),
      padded_phi_(fast_length(2 * shape.phi_nodes - 1)),
      padded_theta_(fast_length(2 * shape.theta_nodes - 1)),
      fft_(padded_phi_, padded_theta_),
      table_spectra_(tables_->size()) {
  const double normalization = 1.0 / static_cast<double>(fft_.real_size());
  RealBuffer padded(fft_.real_size());
  for (const Term& term : terms_) {
    ComplexBuffer& spectrum = table_spectra_[term.table];
    if (!spectrum.empty()) continue;
    const Table& table = (*tables_)[term.table];
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

Eigen::ArrayXd ScaledConvolution::apply(const Eigen::ArrayXd& operand) const {
  using MutableSpectrum = Eigen::Map<Eigen::ArrayXcd>;
  using ConstSpectrum = Eigen::Map<const Eigen::ArrayXcd>;
  const auto size = static_cast<Eigen::Index>(fft_.spectrum_size());
  RealBuffer padded(fft_.real_size());

  std::map<std::size_t, ComplexBuffer> operands;  // by the scaling on the right
  for (const Term& term : terms_) {
    ComplexBuffer& spectrum = operands[term.right];
    if (!spectrum.empty()) continue;
    std::fill(padded.begin(), padded.end(), 0.0);
    for (int i = 0; i < shape_.phi_nodes; ++i) {
      const auto row = Eigen::seqN(static_cast<Eigen::Index>(i) * shape_.theta_nodes, shape_.theta_nodes);
      Eigen::Map<Eigen::ArrayXd>(padded.data() + static_cast<std::ptrdiff_t>(i) * padded_theta_, shape_.theta_nodes) =
          scalings_[term.right](row) * operand(row);
    }
    spectrum.resize(fft_.spectrum_size());
    fft_.forward(padded, spectrum);
  }

  std::map<std::size_t, ComplexBuffer> products;  // by the scaling on the left
  for (const Term& term : terms_) {
    ComplexBuffer& product = products[term.left];
    product.resize(fft_.spectrum_size());
    MutableSpectrum(product.data(), size) += term.sign * ConstSpectrum(table_spectra_[term.table].data(), size) *
                                             ConstSpectrum(operands[term.right].data(), size);
  }

  Eigen::ArrayXd result = Eigen::ArrayXd::Zero(shape_.size());
  for (auto& [left, product] : products) {
    fft_.backward(product, padded);
    for (int i = 0; i < shape_.phi_nodes; ++i) {
      const auto row = Eigen::seqN(static_cast<Eigen::Index>(i) * shape_.theta_nodes, shape_.theta_nodes);
      result(row) += scalings_[left](row) *
                     Eigen::Map<const Eigen::ArrayXd>(padded.data() + static_cast<std::ptrdiff_t>(i) * padded_theta_,
                                                      shape_.theta_nodes);
    }
  }
  return result;
}

Eigen::MatrixXd ScaledConvolution::block(std::span<const Eigen::Index> nodes, int threads, Watch& watch) const {
  const auto count = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  parallel_for(nodes.size(), threads, watch, "assembling the compliance", [&](std::size_t column, std::size_t) {
    const Eigen::Index source = nodes[column];
    const auto source_phi = static_cast<int>(source / shape_.theta_nodes);
    const auto source_theta = static_cast<int>(source % shape_.theta_nodes);
    auto target = matrix.col(static_cast<Eigen::Index>(column));
    for (const Term& term : terms_) {
      const Table& table = (*tables_)[term.table];
      const Eigen::ArrayXd& left = scalings_[term.left];
      const double right = term.sign * scalings_[term.right][source];
      for (Eigen::Index row = 0; row < count; ++row) {
        const Eigen::Index node = nodes[static_cast<std::size_t>(row)];
        target[row] += right * left[node] *
                       table(static_cast<int>(node / shape_.theta_nodes) - source_phi,
                             static_cast<int>(node % shape_.theta_nodes) - source_theta);
      }
    }
  });
  return matrix;
}

}  // namespace viscoroll::detail

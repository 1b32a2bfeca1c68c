#include "influence/inverse_convolution.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <complex>

#include "influence/periodic_table.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Inverse of the matrix of symbols at every order, for each of its entries, row by row.
template <int Fields>
std::vector<ComplexBuffer> inverse(const std::vector<ComplexBuffer>& spectra, const std::vector<ConvolutionTerm>& terms,
                                   double points) {
  using Matrix = Eigen::Matrix<cplx, Fields, Fields, Fields == 1 ? 0 : Eigen::RowMajor>;
  const std::size_t size = spectra[terms.front().table].size();
  std::vector<ComplexBuffer> inverses(std::size_t{Fields} * Fields, ComplexBuffer(size));
  for (std::size_t i = 0; i < size; ++i) {
    Matrix symbol = Matrix::Zero();
    for (const ConvolutionTerm& term : terms) {
      symbol.data()[term.result * Fields + term.operand] += term.sign * points * points * spectra[term.table][i];
    }
    if (symbol(0, 0) == cplx()) continue;  // a gap that keeps columns on cache lines
    const Matrix inverted = symbol.inverse();
    for (std::size_t entry = 0; entry < inverses.size(); ++entry) inverses[entry][i] = inverted.data()[entry];
  }
  return inverses;
}

}  // namespace

InverseConvolution::InverseConvolution(WindowShape shape, WindowShape period, const std::vector<const Table*>& tables,
                                       const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch)
    : product_(shape, period) {
  for (const ConvolutionTerm& term : terms) fields_ = std::max(fields_, term.result + 1);
  std::vector<ComplexBuffer> spectra(tables.size());
  for (const ConvolutionTerm& term : terms) {
    ComplexBuffer& spectrum = spectra[term.table];
    if (spectrum.empty()) {
      spectrum = product_.spectrum(PeriodicTable(*tables[term.table], shape, period), threads, watch);
    }
  }
  // The spectrum is divided by the number of points, and so must its inverse be.
  const auto points = static_cast<double>(period.size());
  inverse_symbol_ = fields_ == 1 ? inverse<1>(spectra, terms, points) : inverse<3>(spectra, terms, points);
  for (std::size_t p = 0; p < fields_; ++p) {
    for (std::size_t q = 0; q < fields_; ++q) terms_.push_back({p, &inverse_symbol_[p * fields_ + q], q, 1.0});
  }
}

Eigen::ArrayXXd InverseConvolution::apply(const Eigen::ArrayXXd& fields, int threads, Watch& watch) const {
  return product_.apply(fields, terms_, fields_, threads, watch);
}

Eigen::VectorXd InverseConvolution::apply(const NodeRows& nodes, const Eigen::VectorXd& values, int threads,
                                          Watch& watch) const {
  Eigen::VectorXd result(values.size());
  product_.apply(
      1,
      [&](int row, std::size_t, double* line) {
        nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) { line[k] = values[i]; });
      },
      terms_, 1,
      [&](int row, std::size_t, const double* line) {
        nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) { result[i] = line[k]; });
      },
      threads, watch);
  return result;
}

}  // namespace viscoroll::detail

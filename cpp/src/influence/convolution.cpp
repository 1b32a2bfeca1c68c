#include "influence/convolution.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <complex>

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

constexpr cplx kI(0.0, 1.0);

/// A spectrum, and the factor with which it enters the matrix of symbols.
struct Symbol {
  std::size_t entry;
  const ComplexBuffer* spectrum;
  cplx factor;  // -i for odd tables
};

/// Inverse of the matrix of symbols at every order, one spectrum per entry, row by row.
template <int Fields>
std::vector<ComplexBuffer> inverse(const std::vector<Symbol>& symbols, double points) {
  using Matrix = Eigen::Matrix<cplx, Fields, Fields, Fields == 1 ? 0 : Eigen::RowMajor>;
  const std::size_t size = symbols.front().spectrum->size();
  std::vector<ComplexBuffer> inverses(std::size_t{Fields} * Fields, ComplexBuffer(size));
  for (std::size_t i = 0; i < size; ++i) {
    Matrix matrix = Matrix::Zero();
    for (const Symbol& symbol : symbols) {
      matrix.data()[symbol.entry] += symbol.factor * points * points * (*symbol.spectrum)[i];
    }
    if (matrix(0, 0) == cplx()) continue;  // padding that keeps columns on cache lines
    const Matrix inverted = matrix.inverse();
    for (std::size_t entry = 0; entry < inverses.size(); ++entry) inverses[entry][i] = inverted.data()[entry];
  }
  return inverses;
}

}  // namespace

Convolution::Convolution(WindowShape shape, const LoadedNodes& loaded, const std::vector<Table>& tables,
                         const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch)
    : product_(shape, doubled(shape, {.phi_nodes = loaded.rows, .theta_nodes = loaded.columns})),
      spectra_(tables.size()) {
  const WindowShape period = product_.period();
  // Offsets of displaced nodes from loaded nodes.
  const int farthest_downstream = shape.phi_nodes - 1 - loaded.first_row;
  const int farthest_upstream = loaded.first_row + loaded.rows - 1;
  const int farthest_aside = (shape.theta_nodes + loaded.columns) / 2 - 1;
  for (const ConvolutionTerm& term : terms) {
    ComplexBuffer& spectrum = spectra_[term.table];
    const Table& table = tables[term.table];
    const bool odd = table.mirror() < 0.0;
    const auto value = [&](int row, int column) {
      const int j = row <= farthest_downstream ? row : row - period.phi_nodes;
      return j >= -farthest_upstream && column <= farthest_aside ? table(j, column) : 0.0;
    };
    if (spectrum.empty()) spectrum = product_.spectrum(value, odd, threads, watch);
    terms_.push_back({term.result, &spectrum, term.operand, term.sign, odd});
    fields_ = std::max(fields_, term.operand + 1);
    results_ = std::max(results_, term.result + 1);
  }
}

InverseConvolution::InverseConvolution(WindowShape shape, WindowShape period, const std::vector<const Table*>& tables,
                                       const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch)
    : product_(shape, period) {
  for (const ConvolutionTerm& term : terms) fields_ = std::max(fields_, term.result + 1);
  std::vector<ComplexBuffer> spectra(tables.size());
  std::vector<Symbol> symbols;
  std::vector<bool> odd(fields_ * fields_);
  for (const ConvolutionTerm& term : terms) {
    const std::size_t entry = term.result * fields_ + term.operand;
    odd[entry] = tables[term.table]->mirror() < 0.0;
    ComplexBuffer& spectrum = spectra[term.table];
    if (spectrum.empty()) {
      spectrum = product_.spectrum(PeriodicTable(*tables[term.table], shape, period), odd[entry], threads, watch);
    }
    symbols.push_back({entry, &spectrum, odd[entry] ? -kI * term.sign : cplx(term.sign)});
  }
  // The spectrum is divided by the number of points, and so must its inverse be.
  const auto points = static_cast<double>(period.size());
  inverse_symbol_ = fields_ == 1 ? inverse<1>(symbols, points) : inverse<3>(symbols, points);
  for (std::size_t p = 0; p < fields_; ++p) {
    for (std::size_t q = 0; q < fields_; ++q) {
      const std::size_t entry = p * fields_ + q;
      // Spectra of odd tables are stored without the factor -i.
      if (odd[entry]) std::ranges::for_each(inverse_symbol_[entry], [](cplx& number) { number *= kI; });
      terms_.push_back({p, &inverse_symbol_[entry], q, 1.0, odd[entry]});
    }
  }
}

Eigen::ArrayXXd InverseConvolution::apply(const Eigen::ArrayXXd& fields, int threads, Watch& watch) const {
  return product_.apply(fields, terms_, fields_, threads, watch);
}

Eigen::VectorXd InverseConvolution::apply(const NodeRows& nodes, const Eigen::VectorXd& values, int threads,
                                          Watch& watch) const {
  Eigen::VectorXd result(values.size());
  const auto fill = [&](int row, std::size_t, double* line) {
    nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) { line[k] = values[i]; });
  };
  const auto take = [&](int row, std::size_t, const double* line) {
    nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) { result[i] = line[k]; });
  };
  if (nodes.mirrored()) {
    product_.apply_mirrored({false}, fill, terms_, 1, take, threads, watch);
  } else {
    product_.apply(1, fill, terms_, 1, take, threads, watch);
  }
  return result;
}

}  // namespace viscoroll::detail

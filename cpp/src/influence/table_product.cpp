#include "influence/table_product.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "base/instruction_sets.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
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

/// Number of nodes up to which products of a window are sums over nodes if few of them are loaded.
constexpr Index kSmallWindow = 4096;

/// Number of operations of a sum over nodes that take as long as one operation of a transform.
constexpr double kPerTransformed = 3.0;

/// Rows of a table, beginning with that of the first row of the window.
struct Influence {
  const double* first;
  Index stride;
};

/// sum += value * influence, on the first columns of a window.
VISCOROLL_BEST_INSTRUCTIONS
void add_influence(double value, const Influence& influence, const WindowShape& shape, Index columns, double* sum) {
  const double* row = influence.first;
  for (Index j = 0; j < shape.phi_nodes; ++j, row += influence.stride, sum += shape.theta_nodes) {
    for (Index k = 0; k < columns; ++k) sum[k] += value * row[k];
  }
}

/// Whether a field is symmetric about the middle column of a window.
bool is_symmetric_field(const double* field, const WindowShape& shape) {
  const Index width = shape.theta_nodes;
  for (Index row = 0; row < shape.phi_nodes; ++row, field += width) {
    for (Index k = 0; k < width / 2; ++k) {
      if (field[k] != field[width - 1 - k]) return false;
    }
  }
  return true;
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
  const auto value = [&](const Table& table, int row, int column) {
    const int j = row <= farthest_downstream ? row : row - period.phi_nodes;
    return j >= -farthest_upstream && column <= farthest_aside ? table(j, column) : 0.0;
  };
  transform(tables, terms, value, threads, watch);
}

Convolution::Convolution(WindowShape shape, WindowShape period, const std::vector<Table>& tables,
                         const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch)
    : product_(shape, period), spectra_(tables.size()) {
  const auto value = [](const Table& table, int row, int column) { return table(row, column); };
  transform(tables, terms, value, threads, watch);
}

template <class Value>
void Convolution::transform(const std::vector<Table>& tables, const std::vector<ConvolutionTerm>& terms,
                            const Value& value, int threads, Watch& watch) {
  for (const ConvolutionTerm& term : terms) {
    ComplexBuffer& spectrum = spectra_[term.table];
    const Table& table = tables[term.table];
    const bool odd = table.mirror() < 0.0;
    if (spectrum.empty()) {
      spectrum = product_.spectrum([&](int row, int column) { return value(table, row, column); }, odd, threads, watch);
    }
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

TableProduct::TableProduct(WindowShape shape, Tables tables, std::vector<ConvolutionTerm> terms)
    : shape_(shape), tables_(std::move(tables)), terms_(std::move(terms)) {
  for (const ConvolutionTerm& term : terms_) results_ = std::max(results_, static_cast<Index>(term.result) + 1);
}

bool TableProduct::is_quick_by_nodes(const Eigen::ArrayXXd& operands) const {
  double loaded = 0.0;
  for (const ConvolutionTerm& term : terms_) {
    loaded += static_cast<double>((operands.col(static_cast<Index>(term.operand)) != 0.0).count());
  }
  const double transformed = SpectralProduct::operations(doubled(shape_), static_cast<std::size_t>(operands.cols()),
                                                         terms_.size(), static_cast<std::size_t>(results_));
  return 2.0 * loaded * static_cast<double>(shape_.size()) < kPerTransformed * transformed;
}

/// Both halves of a table side by side, up to the reach of the window; offsets along a row are contiguous.
const Eigen::ArrayXXd& TableProduct::unfolded(std::size_t table) const {
  unfolded_.resize(tables_->size());
  Eigen::ArrayXXd& values = unfolded_[table];
  if (values.size() > 0) return values;
  const Table& half = (*tables_)[table];
  const int phi = shape_.phi_nodes - 1;
  const int theta = shape_.theta_nodes - 1;
  values.resize(2 * theta + 1, 2 * phi + 1);
  for (int j = -phi; j <= phi; ++j) {
    const Eigen::Map<const Eigen::ArrayXd> row(half.row(j).data(), theta + 1);
    values.col(j + phi).tail(theta + 1) = row;
    values.col(j + phi).head(theta) = half.mirror() * row.tail(theta).reverse();
  }
  return values;
}

Eigen::MatrixXd TableProduct::between(std::size_t table, const WeightedNodes& displaced,
                                      const WeightedNodes& loaded) const {
  const Eigen::ArrayXXd& values = unfolded(table);
  const double* const center = &values(shape_.theta_nodes - 1, shape_.phi_nodes - 1);
  const auto place = [&](Index node) { return node / shape_.theta_nodes * values.rows() + node % shape_.theta_nodes; };
  std::vector<Index> places(displaced.nodes.size());
  std::ranges::transform(displaced.nodes, places.begin(), place);
  Eigen::MatrixXd matrix(displaced.nodes.size(), loaded.nodes.size());
  for (Index j = 0; j < matrix.cols(); ++j) {
    const double* const from = center - place(loaded.nodes[static_cast<std::size_t>(j)]);
    const double factor = loaded.factors[j];
    for (Index i = 0; i < matrix.rows(); ++i) {
      matrix(i, j) = factor * displaced.factors[i] * from[places[static_cast<std::size_t>(i)]];
    }
  }
  return matrix;
}

Eigen::ArrayXXd TableProduct::by_nodes(const Eigen::ArrayXXd& operands) const {
  Eigen::ArrayXXd results = Eigen::ArrayXXd::Zero(shape_.size(), results_);
  const Index width = shape_.theta_nodes;
  const bool is_symmetric = std::ranges::all_of(terms_, [&](const ConvolutionTerm& term) {
    return (*tables_)[term.table].mirror() > 0.0 &&
           is_symmetric_field(operands.col(static_cast<Index>(term.operand)).data(), shape_);
  });
  const Index columns = is_symmetric ? (width + 1) / 2 : width;
  for (const ConvolutionTerm& term : terms_) {
    const Eigen::ArrayXXd& table = unfolded(term.table);
    const auto operand = operands.col(static_cast<Index>(term.operand));
    double* const result = results.col(static_cast<Index>(term.result)).data();
    for (Index row = 0; row < shape_.phi_nodes; ++row) {
      for (Index k = 0; k < width; ++k) {
        const double value = term.sign * operand[row * width + k];
        if (value == 0.0) continue;
        const Influence influence{.first = &table(width - 1 - k, shape_.phi_nodes - 1 - row), .stride = table.rows()};
        add_influence(value, influence, shape_, columns, result);
      }
    }
  }
  for (Index row = 0; row < shape_.phi_nodes; ++row) {
    for (Index k = columns; k < width; ++k) {
      results.row(row * width + k) = results.row(row * width + width - 1 - k);
    }
  }
  return results;
}

bool TableProduct::apply(std::size_t fields, const SpectralProduct::Fill& fill,
                         const SpectralProduct::Take& take) const {
  if (shape_.size() > kSmallWindow) return false;
  const Index width = shape_.theta_nodes;
  Eigen::ArrayXXd operands = Eigen::ArrayXXd::Zero(shape_.size(), static_cast<Index>(fields));
  for (int row = 0; row < shape_.phi_nodes; ++row) {
    for (std::size_t field = 0; field < fields; ++field) {
      fill(row, field, operands.col(static_cast<Index>(field)).data() + row * width);
    }
  }
  if (!is_quick_by_nodes(operands)) return false;
  const Eigen::ArrayXXd results = by_nodes(operands);
  for (int row = 0; row < shape_.phi_nodes; ++row) {
    for (Index result = 0; result < results_; ++result) {
      take(row, static_cast<std::size_t>(result), results.col(result).data() + row * width);
    }
  }
  return true;
}

}  // namespace viscoroll::detail

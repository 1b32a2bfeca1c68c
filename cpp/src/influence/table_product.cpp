#include "influence/table_product.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/instruction_sets.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// Number of nodes up to which products of a window are sums over nodes if few of them are loaded.
constexpr Index kSmallWindow = 4096;

/// Operations of sums over nodes in the time of one operation of a transform.
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
bool is_its_image(const double* field, const WindowShape& shape) {
  const Index width = shape.theta_nodes;
  for (Index row = 0; row < shape.phi_nodes; ++row, field += width) {
    for (Index k = 0; k < width / 2; ++k) {
      if (field[k] != field[width - 1 - k]) return false;
    }
  }
  return true;
}

}  // namespace

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

Eigen::MatrixXd TableProduct::between(std::size_t table, const std::vector<Index>& displaced,
                                      const std::vector<Index>& loaded) const {
  const Eigen::ArrayXXd& values = unfolded(table);
  const double* const center = &values(shape_.theta_nodes - 1, shape_.phi_nodes - 1);
  const auto place = [&](Index node) { return node / shape_.theta_nodes * values.rows() + node % shape_.theta_nodes; };
  std::vector<Index> places(displaced.size());
  std::ranges::transform(displaced, places.begin(), place);
  Eigen::MatrixXd matrix(displaced.size(), loaded.size());
  for (Index j = 0; j < matrix.cols(); ++j) {
    const double* const from = center - place(loaded[static_cast<std::size_t>(j)]);
    for (Index i = 0; i < matrix.rows(); ++i) matrix(i, j) = from[places[static_cast<std::size_t>(i)]];
  }
  return matrix;
}

Eigen::ArrayXXd TableProduct::by_nodes(const Eigen::ArrayXXd& operands) const {
  Eigen::ArrayXXd results = Eigen::ArrayXXd::Zero(shape_.size(), results_);
  const Index width = shape_.theta_nodes;
  const bool is_symmetric = std::ranges::all_of(terms_, [&](const ConvolutionTerm& term) {
    return (*tables_)[term.table].mirror() > 0.0 &&
           is_its_image(operands.col(static_cast<Index>(term.operand)).data(), shape_);
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

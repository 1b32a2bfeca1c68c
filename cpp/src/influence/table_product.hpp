/// @file
/// @brief Products of influence tables and fields on a window of surface nodes: by Fourier transforms, or node by node
/// if few nodes are loaded; and an approximate inverse of such products, as a preconditioner.
#pragma once

#include <Eigen/Core>
#include <cstdlib>
#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "influence/node_rows.hpp"
#include "influence/spectral_product.hpp"
#include "influence/table.hpp"

namespace viscoroll::detail {

/// @brief One term of a `Convolution`: a field times a table, added to a result.
struct ConvolutionTerm {
  std::size_t result;   ///< index of the result
  std::size_t table;    ///< index of the table
  std::size_t operand;  ///< index of the field
  double sign;
};

/// @brief Nodes of a window that contain all loads.
struct LoadedNodes {
  int first_row;
  int rows;
  int columns;  ///< number of columns, around the middle
};

/// @brief Sum of products of fields and translation-invariant tables over a window, by FFTs on the window doubled in
/// both directions, or on the period of periodic tables. Each field is transformed once, not once per table.
class Convolution {
 public:
  /// @param[in] shape window; the tables reach across it
  /// @param[in] tables all tables; only those in `terms` are used
  /// @param[in] terms summands
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  Convolution(WindowShape shape, const std::vector<Table>& tables, const std::vector<ConvolutionTerm>& terms,
              int threads, Watch& watch)
      : Convolution(shape, {.first_row = 0, .rows = shape.phi_nodes, .columns = shape.theta_nodes}, tables, terms,
                    threads, watch) {}
  /// @param[in] shape,tables,terms,threads,watch same as above
  /// @param[in] loaded nodes outside which all fields are 0; fewer nodes make the period shorter
  Convolution(WindowShape shape, const LoadedNodes& loaded, const std::vector<Table>& tables,
              const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch);
  /// @param[in] shape,terms,threads,watch same as above
  /// @param[in] period period of the tables, at least the window [nodes]
  /// @param[in] tables periodic tables that reach over a period
  Convolution(WindowShape shape, WindowShape period, const std::vector<Table>& tables,
              const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch);

  /// @param[in] operands one column per field and one row per node
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return one column per result and one row per node
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& operands, int threads, Watch& watch) const {
    return product_.apply(operands, terms_, results_, threads, watch);
  }

  /// @brief Same with functions that fill and take rows, see `SpectralProduct`.
  void apply(std::size_t fields, const SpectralProduct::Fill& fill, const SpectralProduct::Take& take, int threads,
             Watch& watch) const {
    product_.apply(fields, fill, terms_, results_, take, threads, watch);
  }

  /// @brief Same for fields that are even or odd, see `SpectralProduct`.
  void apply_mirrored(const std::vector<bool>& odd, const SpectralProduct::Fill& fill,
                      const SpectralProduct::Take& take, int threads, Watch& watch) const {
    product_.apply_mirrored(odd, fill, terms_, results_, take, threads, watch);
  }

  /// @return approximate number of floating-point operations of a product
  [[nodiscard]] double operations() const {
    return SpectralProduct::operations(product_.period(), fields_, terms_.size(), results_);
  }

 private:
  /// Transform the tables in the terms.
  /// @param[in] value function of (table, row, column) that returns the table at a place of the period
  template <class Value>
  void transform(const std::vector<Table>& tables, const std::vector<ConvolutionTerm>& terms, const Value& value,
                 int threads, Watch& watch);

  SpectralProduct product_;
  std::vector<ComplexBuffer> spectra_;  // spectra of the tables in the terms; others are empty
  std::vector<SpectralTerm> terms_;     // point to the spectra
  std::size_t fields_ = 0;
  std::size_t results_ = 0;
};

/// @brief Table times a triangle in each direction, summed over the offsets that are equal modulo the period.
///
/// The triangle weights an offset by the number of pairs of nodes at it. It keeps the Hermitian part of the symbol
/// positive if that of the convolution is (Fejer), so that the inverse symbol does not divide by small numbers. On a
/// period as long as the window it gives T. F. Chan's optimal circulant (SIAM J. Sci. Stat. Comput. 9 (1988) 766-771).
class PeriodicTable {
 public:
  /// @param[in] table table that reaches across the window and outlives this object
  /// @param[in] shape window
  /// @param[in] period period, from the window to the doubled window
  PeriodicTable(const Table& table, WindowShape shape, WindowShape period)
      : table_(table), shape_(shape), period_(period) {}

  /// @return value at a place of the period
  [[nodiscard]] double operator()(int row, int column) const {
    const int j = row - period_.phi_nodes;
    const int l = column - period_.theta_nodes;
    return tapered(row, column) + tapered(row, l) + tapered(j, column) + tapered(j, l);
  }

 private:
  [[nodiscard]] double tapered(int j, int l) const {
    const double ahead = 1.0 - std::abs(j) / static_cast<double>(shape_.phi_nodes);
    const double aside = 1.0 - std::abs(l) / static_cast<double>(shape_.theta_nodes);
    return ahead > 0.0 && aside > 0.0 ? ahead * aside * table_(j, l) : 0.0;
  }

  const Table& table_;
  WindowShape shape_;
  WindowShape period_;
};

/// @brief Inverse of the convolution with tables that are made periodic, see `PeriodicTable`.
class InverseConvolution {
 public:
  /// @param[in] shape window
  /// @param[in] period period of the domain, from the window to the doubled window; a longer one is more accurate and
  /// costs more
  /// @param[in] tables tables that reach across the window
  /// @param[in] terms terms of a convolution with as many fields as results
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  InverseConvolution(WindowShape shape, WindowShape period, const std::vector<const Table*>& tables,
                     const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch);

  /// @param[in] fields fields over the window, one column each
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return fields whose convolution is approximately `fields`
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& fields, int threads, Watch& watch) const;

  /// @brief Same for a single field that is given and evaluated only at some nodes.
  /// @param[in] nodes these nodes
  /// @param[in] values values of the field at these nodes
  /// @param[in] threads,watch same as above
  [[nodiscard]] Eigen::VectorXd apply(const NodeRows& nodes, const Eigen::VectorXd& values, int threads,
                                      Watch& watch) const;

 private:
  SpectralProduct product_;
  std::size_t fields_ = 0;
  std::vector<ComplexBuffer> inverse_symbol_;  // row by row
  std::vector<SpectralTerm> terms_;
};

/// @brief Nodes of a window, with a factor for each node.
struct WeightedNodes {
  const std::vector<Eigen::Index>& nodes;
  Eigen::ArrayXd factors;
};

/// @brief Products of a `Convolution` as sums over the loaded nodes. For small contacts this takes less time and no
/// spectra. An object computes one product at a time.
class TableProduct {
 public:
  using Tables = std::shared_ptr<const std::vector<Table>>;

  /// @param[in] shape window; the tables reach across it
  /// @param[in] tables all tables; only those in `terms` are used
  /// @param[in] terms summands
  TableProduct(WindowShape shape, Tables tables, std::vector<ConvolutionTerm> terms);

  /// @brief Compute a product with functions that fill and take rows, see `SpectralProduct`, if it takes less time than
  /// transforms.
  /// @return whether the product was computed; if not, `take` was not called
  [[nodiscard]] bool apply(std::size_t fields, const SpectralProduct::Fill& fill,
                           const SpectralProduct::Take& take) const;

  [[nodiscard]] const std::vector<ConvolutionTerm>& terms() const { return terms_; }

  /// @param[in] table index of a table
  /// @param[in] displaced,loaded nodes of the window, with a factor for each node
  /// @return values of the table times both factors, one row per displaced and one column per loaded node
  [[nodiscard]] Eigen::MatrixXd between(std::size_t table, const WeightedNodes& displaced,
                                        const WeightedNodes& loaded) const;

 private:
  [[nodiscard]] bool is_quick_by_nodes(const Eigen::ArrayXXd& operands) const;
  [[nodiscard]] Eigen::ArrayXXd by_nodes(const Eigen::ArrayXXd& operands) const;
  [[nodiscard]] const Eigen::ArrayXXd& unfolded(std::size_t table) const;

  WindowShape shape_;
  Tables tables_;
  std::vector<ConvolutionTerm> terms_;
  Eigen::Index results_ = 0;
  mutable std::vector<Eigen::ArrayXXd> unfolded_;  // [table](offset along a row, offset of rows), created when needed
};

}  // namespace viscoroll::detail

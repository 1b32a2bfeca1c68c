/// @file
/// @brief Product of influence tables and fields on a window of surface nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/parallel.hpp"
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
/// both directions. Each field is transformed once, not once per table.
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
  SpectralProduct product_;
  std::vector<ComplexBuffer> spectra_;  // spectra of the tables in the terms; others are empty
  std::vector<SpectralTerm> terms_;     // point to the spectra
  std::size_t fields_ = 0;
  std::size_t results_ = 0;
};

}  // namespace viscoroll::detail

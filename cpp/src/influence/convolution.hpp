/// @file
/// @brief Influence tables applied on a window of surface nodes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "influence/spectral_product.hpp"
#include "influence/table.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief A field to another one through a table: what a `Convolution` is the sum of.
struct ConvolutionTerm {
  std::size_t result;   ///< which field it adds to
  std::size_t table;    ///< which table
  std::size_t operand;  ///< which field it is fed with
  double sign;
};

/// @brief Nodes of a window outside which nothing is loaded.
struct LoadedNodes {
  int first_row;
  int rows;
  int columns;  ///< around the middle
};

/// @brief Several fields over a window to several others by translation-invariant tables, with FFTs on the window
/// doubled in both directions: one transform for each field rather than for each table.
class Convolution {
 public:
  /// @param[in] shape window; the tables reach across it
  /// @param[in] tables of which those that occur in terms are used
  /// @param[in] terms summands
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  Convolution(WindowShape shape, const std::vector<Table>& tables, const std::vector<ConvolutionTerm>& terms,
              int threads, Watch& watch)
      : Convolution(shape, {.first_row = 0, .rows = shape.phi_nodes, .columns = shape.theta_nodes}, tables, terms,
                    threads, watch) {}
  /// @param[in] loaded nodes that all fields leave out the others of: the fewer, the shorter the period
  Convolution(WindowShape shape, const LoadedNodes& loaded, const std::vector<Table>& tables,
              const std::vector<ConvolutionTerm>& terms, int threads, Watch& watch);

  /// @param[in] operands one column for each field, rows being nodes
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return one column for each field
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& operands, int threads, Watch& watch) const {
    return product_.apply(operands, terms_, results_, threads, watch);
  }

  /// @brief The same from rows to rows, see `SpectralProduct`.
  void apply(std::size_t fields, const SpectralProduct::Fill& fill, const SpectralProduct::Take& take, int threads,
             Watch& watch) const {
    product_.apply(fields, fill, terms_, results_, take, threads, watch);
  }

  /// @brief The same of fields that are even or odd, see `SpectralProduct`.
  void apply_mirrored(const std::vector<bool>& odd, const SpectralProduct::Fill& fill,
                      const SpectralProduct::Take& take, int threads, Watch& watch) const {
    product_.apply_mirrored(odd, fill, terms_, results_, take, threads, watch);
  }

  /// @return floating-point operations of a product, roughly
  [[nodiscard]] double operations() const {
    return SpectralProduct::operations(product_.period(), fields_, terms_.size(), results_);
  }

 private:
  SpectralProduct product_;
  std::vector<ComplexBuffer> spectra_;  // of the tables that occur in terms; others stay empty
  std::vector<SpectralTerm> terms_;     // which point to them
  std::size_t fields_ = 0;
  std::size_t results_ = 0;
};

}  // namespace viscoroll::detail

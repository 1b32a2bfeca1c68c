/// @file
/// @brief Fields over a window, multiplied in the Fourier domain.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "influence/fft.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Rectangular window of nodes, numbered row by row: node (i, k) is i * theta_nodes + k.
struct WindowShape {
  int phi_nodes;
  int theta_nodes;

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(phi_nodes) * theta_nodes; }
  friend bool operator==(const WindowShape&, const WindowShape&) = default;
};

/// @return the shortest period, of a fast length, on which a field over the window does not meet its images
[[nodiscard]] WindowShape doubled(const WindowShape& shape);

/// @brief A factor between a field and a result, for all orders.
struct SpectralTerm {
  std::size_t result;             ///< which result it adds to
  const ComplexBuffer* spectrum;  ///< from `SpectralProduct::spectrum`
  std::size_t operand;            ///< which field it is fed with
  double sign;
};

/// @brief Products of fields, continued by zeros to a periodic domain, with spectra over that domain.
///
/// Rows of zeros are never transformed, and a column is transformed, multiplied and transformed back while it lies in
/// the cache: memory is passed over three times, as much as for one two-dimensional transform. Buffers are kept from
/// product to product, so an object serves one product at a time.
class SpectralProduct {
 public:
  /// @param[in] window where fields are given and wanted
  /// @param[in] period of the domain, at least the window
  SpectralProduct(WindowShape window, WindowShape period);

  [[nodiscard]] WindowShape period() const { return period_; }

  /// @return numbers from one column of a spectrum to the next: place p of column q is number q * column_stride() + p
  [[nodiscard]] std::size_t column_stride() const { return column_stride_; }

  /// @brief Spectrum of a field over the whole domain, divided by the number of its points.
  /// @param[in] value gives the field at (row, column), rows in any order and on several threads
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  template <class Value>
  [[nodiscard]] ComplexBuffer spectrum(const Value& value, int threads, Watch& watch) const {
    return transform(
        [&value](int row, double* line, int columns) {
          for (int column = 0; column < columns; ++column) line[column] = value(row, column);
        },
        threads, watch);
  }

  /// @brief Fills a row of a field: theta_nodes numbers, which are zero before.
  using Fill = std::function<void(int row, std::size_t field, double* line)>;
  /// @brief Takes a row of a result: theta_nodes numbers.
  using Take = std::function<void(int row, std::size_t result, const double* line)>;

  /// @param[in] fields number of fields
  /// @param[in] fill gives them, rows in any order and on several threads
  /// @param[in] terms summands
  /// @param[in] results number of results
  /// @param[in] take receives them, those of a row one after the other on one thread
  /// @param[in] threads number of threads, 0 for all cores; small products take one
  /// @param[in] watch progress and cancellation
  void apply(std::size_t fields, const Fill& fill, const std::vector<SpectralTerm>& terms, std::size_t results,
             const Take& take, int threads, Watch& watch) const;

  /// @return floating-point operations of a product, roughly
  [[nodiscard]] double operations(std::size_t fields, std::size_t terms, std::size_t results) const;

  /// @param[in] operands one column for each field, rows being nodes
  /// @param[in] terms,results,threads,watch as above
  /// @return one column for each result
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& operands, const std::vector<SpectralTerm>& terms,
                                      std::size_t results, int threads, Watch& watch) const;

 private:
  [[nodiscard]] ComplexBuffer transform(const std::function<void(int row, double* line, int columns)>& fill,
                                        int threads, Watch& watch) const;
  [[nodiscard]] int useful_threads(int threads) const;

  WindowShape window_;
  WindowShape period_;
  std::size_t columns_;        // of the half spectrum
  std::size_t row_stride_;     // of half-transformed rows
  std::size_t column_stride_;  // of columns, in spectra as well
  RealFft theta_fft_;
  ComplexFft phi_fft_;

  /// Buffers of one thread.
  struct Workspace {
    RealBuffer row;
    ComplexBuffer lines;
    ComplexBuffer sums;
  };
  mutable std::vector<Workspace> workspaces_;
  mutable ComplexBuffer half_;  // rows of all fields, transformed along theta
};

}  // namespace viscoroll::detail

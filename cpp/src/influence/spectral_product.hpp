/// @file
/// @brief Fields over a window, multiplied in the Fourier domain.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "influence/column_blocks.hpp"
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

/// @return the same for fields that are nothing but on a smaller window inside
[[nodiscard]] WindowShape doubled(const WindowShape& shape, const WindowShape& loaded);

/// @brief A factor between a field and a result, for all orders.
struct SpectralTerm {
  std::size_t result;             ///< which result it adds to
  const ComplexBuffer* spectrum;  ///< from `SpectralProduct::spectrum`
  std::size_t operand;            ///< which field it is fed with
  double sign;
  bool odd = false;  ///< whether the spectrum is of a table that is odd in theta
};

/// @brief Products of fields, continued by zeros to a periodic domain, with spectra over that domain.
///
/// The spectra are of tables that are even or odd in theta: transformed along theta they are real but for a factor -i
/// of odd ones. So a field is its even and its odd part, each of real numbers along theta's orders, transforms along
/// phi are of real lines, and of a spectrum a quarter is kept. Of fields that are even or odd themselves there is one
/// part.
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

  /// @brief Spectrum of a table over the whole domain, divided by the number of its points: at the orders up to half of
  /// the period in either direction, of which the others are complex conjugates.
  /// @param[in] value gives the table at (row, column), columns up to half of the period, on several threads
  /// @param[in] odd whether it is odd in theta; then the factor -i of the spectrum is left out
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  template <class Value>
  [[nodiscard]] ComplexBuffer spectrum(const Value& value, bool odd, int threads, Watch& watch) const {
    return transform(
        [&value](int row, double* line, int columns) {
          for (int column = 0; column < columns; ++column) line[column] = value(row, column);
        },
        odd, threads, watch);
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

  /// @brief The same of fields each of which is even or odd across the middle column of the window: rows are given and
  /// taken from that column on.
  /// @param[in] odd whether each field is
  void apply_mirrored(const std::vector<bool>& odd, const Fill& fill, const std::vector<SpectralTerm>& terms,
                      std::size_t results, const Take& take, int threads, Watch& watch) const;

  /// @return floating-point operations of a product on a period, roughly
  [[nodiscard]] static double operations(WindowShape period, std::size_t fields, std::size_t terms,
                                         std::size_t results);

  /// @param[in] operands one column for each field, rows being nodes
  /// @param[in] terms,results,threads,watch as above
  /// @return one column for each result
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& operands, const std::vector<SpectralTerm>& terms,
                                      std::size_t results, int threads, Watch& watch) const;

 private:
  using Parts = std::vector<FieldPart>;

  /// Buffers of one thread.
  struct Workspace {
    RealBuffer row;
    RealBuffer odd_row;
    ComplexBuffer half_rows;
    RealBuffer lines;
    RealBuffer scratch;  // of the transforms of several lines
    ComplexBuffer columns;
    ComplexBuffer sums;
  };

  [[nodiscard]] ComplexBuffer transform(const std::function<void(int row, double* line, int columns)>& fill, bool odd,
                                        int threads, Watch& watch) const;
  [[nodiscard]] int useful_threads(int threads) const;
  /// Room for so many parts.
  void reserve(std::size_t parts, int threads) const;
  /// Call function(first, end, workspace) for rows of the window, some at a time.
  void for_rows(int threads, Watch& watch,
                const std::function<void(std::size_t first, std::size_t end, Workspace& work)>& function) const;
  /// A transformed row among those of a workspace.
  [[nodiscard]] std::complex<double>* half_row(Workspace& work, std::size_t place) const;
  void multiply(const Parts& operands, const std::vector<SpectralTerm>& terms, const Parts& results, int threads,
                Watch& watch) const;

  WindowShape window_;
  WindowShape period_;
  std::size_t columns_;        // of half a spectrum
  std::size_t line_stride_;    // of columns before they are transformed
  std::size_t column_stride_;  // of columns, in spectra as well
  RealFft theta_fft_;
  RealFft phi_fft_;
  mutable std::vector<Workspace> workspaces_;
  mutable ColumnBlocks rows_;  // of all parts, transformed along theta
};

}  // namespace viscoroll::detail

/// @file
/// @brief Products of fields over a window with spectra, in the Fourier domain.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

#include "base/parallel.hpp"
#include "influence/fft.hpp"

namespace viscoroll::detail {

/// @brief Even or odd part of a field.
struct FieldPart {
  std::size_t field;
  bool odd;
};

/// @brief Real numbers in blocks of columns, each block stored row by row. Memory access is contiguous both when a few
/// rows are written at a time and when a block is read at a time.
class ColumnBlocks {
 public:
  static constexpr std::size_t kColumns = 8;  ///< columns of a block: a cache line of every row

  /// @param[in] columns number of columns
  /// @return number of blocks that contain them
  [[nodiscard]] static constexpr std::size_t count(std::size_t columns) { return (columns + kColumns - 1) / kColumns; }

  /// @param[in] parts number of parts of fields, each of which is a table of `rows` and `columns`
  void resize(std::size_t parts, std::size_t rows, std::size_t columns) {
    rows_ = rows;
    blocks_ = count(columns);
    numbers_.resize(parts * rows_ * blocks_ * kColumns);
  }

  /// @brief Store one part of transformed rows. The transform of an even field is real; that of an odd field is -i
  /// times the stored number.
  /// @param[in] lines rows of count(columns) * kColumns numbers each
  /// @param[in] number index of the part
  /// @param[in] odd whether the part is odd
  /// @param[in] first,end range of rows
  void store(const std::complex<double>* lines, std::size_t number, bool odd, std::size_t first, std::size_t end) {
    const std::size_t stride = 2 * blocks_ * kColumns;
    const double* pairs = reinterpret_cast<const double*>(lines) + (odd ? 1 : 0);
    const double sign = odd ? -1.0 : 1.0;
    for (std::size_t block = 0; block < blocks_; ++block) {
      double* place = at(number, block) + first * kColumns;
      for (std::size_t row = 0; row < end - first; ++row, place += kColumns) {
        const double* line = pairs + row * stride + 2 * block * kColumns;
        for (std::size_t c = 0; c < kColumns; ++c) place[c] = sign * line[2 * c];
      }
    }
  }

  /// @brief Inverse of `store`. The other part of the lines is unchanged.
  void load(std::size_t number, bool odd, std::size_t first, std::size_t end, std::complex<double>* lines) const {
    const std::size_t stride = 2 * blocks_ * kColumns;
    double* pairs = reinterpret_cast<double*>(lines) + (odd ? 1 : 0);
    const double sign = odd ? -1.0 : 1.0;
    for (std::size_t block = 0; block < blocks_; ++block) {
      const double* place = at(number, block) + first * kColumns;
      for (std::size_t row = 0; row < end - first; ++row, place += kColumns) {
        double* line = pairs + row * stride + 2 * block * kColumns;
        for (std::size_t c = 0; c < kColumns; ++c) line[2 * c] = sign * place[c];
      }
    }
  }

  /// @brief Copy the columns of a block to lines.
  void gather(std::size_t number, std::size_t block, double* lines, std::size_t stride) const {
    const double* place = at(number, block);
    for (std::size_t row = 0; row < rows_; ++row, place += kColumns) {
      for (std::size_t c = 0; c < kColumns; ++c) lines[c * stride + row] = place[c];
    }
  }

  /// @brief Inverse of `gather`.
  void scatter(const double* lines, std::size_t stride, std::size_t number, std::size_t block) {
    double* place = at(number, block);
    for (std::size_t row = 0; row < rows_; ++row, place += kColumns) {
      for (std::size_t c = 0; c < kColumns; ++c) place[c] = lines[c * stride + row];
    }
  }

 private:
  [[nodiscard]] std::size_t start(std::size_t number, std::size_t block) const {
    return (number * blocks_ + block) * rows_ * kColumns;
  }
  [[nodiscard]] double* at(std::size_t number, std::size_t block) { return numbers_.data() + start(number, block); }
  [[nodiscard]] const double* at(std::size_t number, std::size_t block) const {
    return numbers_.data() + start(number, block);
  }

  std::size_t rows_ = 0;
  std::size_t blocks_ = 0;
  RealBuffer numbers_;
};

/// @brief Rectangular window of nodes, numbered row by row: node (i, k) is i * theta_nodes + k.
struct WindowShape {
  int phi_nodes;
  int theta_nodes;

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(phi_nodes) * theta_nodes; }
  friend bool operator==(const WindowShape&, const WindowShape&) = default;
};

/// @return shortest period of fast lengths that keeps a field over the window apart from its images
[[nodiscard]] WindowShape doubled(const WindowShape& shape);

/// @return same, for fields that are 0 outside a smaller window
[[nodiscard]] WindowShape doubled(const WindowShape& shape, const WindowShape& loaded);

/// @brief One term of a product: a field times a spectrum, added to a result.
struct SpectralTerm {
  std::size_t result;             ///< index of the result
  const ComplexBuffer* spectrum;  ///< spectrum from `SpectralProduct::spectrum`
  std::size_t operand;            ///< index of the field
  double sign;
  bool odd = false;  ///< whether the spectrum belongs to a table that is odd in theta
};

/// @brief Products of fields, extended by zeros to a periodic domain, with spectra over that domain.
///
/// The spectra belong to tables that are even or odd in theta. Transformed along theta they are real, apart from a
/// factor -i of odd tables. A field is therefore split into its even and its odd part, each with real numbers along the
/// orders of theta; transforms along phi are those of real lines, and a quarter of a spectrum is stored. A field that
/// is even or odd itself has one part.
///
/// Rows of zeros are not transformed, and a column is transformed, multiplied and transformed back while it is in the
/// cache. Data pass through memory three times, as in one two-dimensional transform. Buffers are kept between products,
/// so an object may compute one product at a time.
class SpectralProduct {
 public:
  /// @param[in] window nodes at which fields are given and evaluated
  /// @param[in] period period of the domain, at least the window
  SpectralProduct(WindowShape window, WindowShape period);

  [[nodiscard]] WindowShape period() const { return period_; }

  /// @return stride between columns of a spectrum: place p of column q has the index q * column_stride() + p
  [[nodiscard]] std::size_t column_stride() const { return column_stride_; }

  /// @brief Return the spectrum of a table over the whole domain, divided by the number of points.
  /// It contains the orders up to half the period in both directions; the others are complex conjugates.
  /// @param[in] value function of (row, column) that returns the table, for columns up to half the period; called from
  /// several threads
  /// @param[in] odd whether the table is odd in theta; the factor -i of its spectrum is then omitted
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

  /// @brief Function that fills a row of a field: theta_nodes numbers, initially 0.
  using Fill = std::function<void(int row, std::size_t field, double* line)>;
  /// @brief Function that takes a row of a result: theta_nodes numbers.
  using Take = std::function<void(int row, std::size_t result, const double* line)>;

  /// @param[in] fields number of fields
  /// @param[in] fill provides the rows of fields, in any order and from several threads
  /// @param[in] terms summands
  /// @param[in] results number of results
  /// @param[in] take receives the rows of results; those of one row one after the other in one thread
  /// @param[in] threads number of threads, 0 for all cores; small products use one
  /// @param[in] watch progress and cancellation
  void apply(std::size_t fields, const Fill& fill, const std::vector<SpectralTerm>& terms, std::size_t results,
             const Take& take, int threads, Watch& watch) const;

  /// @brief Same for fields that are even or odd about the middle column of the window; rows are filled and taken from
  /// that column on.
  /// @param[in] odd whether each field is odd
  /// @param[in] fill,terms,results,take,threads,watch same as in `apply`
  void apply_mirrored(const std::vector<bool>& odd, const Fill& fill, const std::vector<SpectralTerm>& terms,
                      std::size_t results, const Take& take, int threads, Watch& watch) const;

  /// @return approximate number of floating-point operations of a product on a period
  [[nodiscard]] static double operations(WindowShape period, std::size_t fields, std::size_t terms,
                                         std::size_t results);

  /// @param[in] operands one column per field and one row per node
  /// @param[in] terms,results,threads,watch same as above
  /// @return one column per result and one row per node
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
    RealBuffer scratch;  // memory of transforms of several lines
    ComplexBuffer columns;
    ComplexBuffer sums;
  };

  [[nodiscard]] ComplexBuffer transform(const std::function<void(int row, double* line, int columns)>& fill, bool odd,
                                        int threads, Watch& watch) const;
  [[nodiscard]] int useful_threads(int threads) const;
  /// Allocate buffers for the given number of parts.
  void reserve(std::size_t parts, int threads) const;
  /// Call function(first, end, workspace) for ranges of rows of the window.
  void for_rows(int threads, Watch& watch,
                const std::function<void(std::size_t first, std::size_t end, Workspace& work)>& function) const;
  /// Return a transformed row in a workspace.
  [[nodiscard]] std::complex<double>* half_row(Workspace& work, std::size_t place) const;
  void multiply(const Parts& operands, const std::vector<SpectralTerm>& terms, const Parts& results, int threads,
                Watch& watch) const;

  WindowShape window_;
  WindowShape period_;
  std::size_t columns_;        // columns of half a spectrum
  std::size_t line_stride_;    // stride of columns before the transform
  std::size_t column_stride_;  // stride of transformed columns and of spectra
  RealFft theta_fft_;
  RealFft phi_fft_;
  mutable std::vector<Workspace> workspaces_;
  mutable ColumnBlocks rows_;  // all parts, transformed along theta
};

}  // namespace viscoroll::detail

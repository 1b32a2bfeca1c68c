/// @file
/// @brief Storage of half-transformed rows, arranged for access by columns.
#pragma once

#include <complex>
#include <cstddef>

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

}  // namespace viscoroll::detail

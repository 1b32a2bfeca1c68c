/// @file
/// @brief Views of matrices that are passed between translation units with different instruction sets.
///
/// They contain no type of a library: a type that both units share would be compiled twice, with different
/// instructions.
#pragma once

#include <complex>
#include <cstddef>

namespace viscoroll::detail {

/// @brief A matrix with contiguous rows or columns.
struct ConstMatrixView {
  const double* data;
  std::ptrdiff_t rows;
  std::ptrdiff_t columns;
  std::ptrdiff_t stride;  ///< distance from a row (or column) to the next
  bool row_major;
};

/// @brief A row-major matrix.
struct RowMajorView {
  double* data;
  std::ptrdiff_t rows;
  std::ptrdiff_t columns;
  std::ptrdiff_t stride;
};

/// @brief A column-major complex matrix without gaps between the columns.
struct ConstComplexMatrixView {
  const std::complex<double>* data;
  std::ptrdiff_t rows;
  std::ptrdiff_t columns;
};

/// @brief Functions behind `dense_products.hpp` and `dense_solvers.hpp`, compiled for one instruction set.
struct DenseProducts {
  void (*add)(const ConstMatrixView& left, const ConstMatrixView& right, const RowMajorView& sum);
  void (*multiply)(const ConstComplexMatrixView& matrix, const std::complex<double>* vector,
                   std::complex<double>* product);
  /// Replaces a column-major square matrix by its triangular factors L and U, where the diagonal of L is 1. Row i of
  /// the matrix is row places[i] of the product L U.
  void (*factor)(double* matrix, std::ptrdiff_t size, int* places);
  void (*factor_single)(float* matrix, std::ptrdiff_t size, int* places);
  /// Solves a system with the factors of `factor_single`.
  void (*solve_single)(const float* factors, std::ptrdiff_t size, const int* places, const double* right,
                       double* solution);
};

}  // namespace viscoroll::detail

/// @file
/// @brief Matrices as one translation unit hands them to another that is compiled with other instructions: no type of a
/// library, which both would have in common.
#pragma once

#include <complex>
#include <cstddef>

namespace viscoroll::detail {

/// @brief A matrix whose rows, or columns, are contiguous.
struct ConstMatrixView {
  const double* data;
  std::ptrdiff_t rows;
  std::ptrdiff_t columns;
  std::ptrdiff_t stride;  ///< from a row, or column, to the next
  bool row_major;
};

/// @brief A matrix by rows.
struct RowMajorView {
  double* data;
  std::ptrdiff_t rows;
  std::ptrdiff_t columns;
  std::ptrdiff_t stride;
};

/// @brief A complex matrix by columns, without gaps.
struct ConstComplexMatrixView {
  const std::complex<double>* data;
  std::ptrdiff_t rows;
  std::ptrdiff_t columns;
};

/// @brief The products of `dense_products.hpp`, compiled for some instruction set.
struct DenseProducts {
  void (*add)(const ConstMatrixView& left, const ConstMatrixView& right, const RowMajorView& sum);
  void (*multiply)(const ConstComplexMatrixView& matrix, const std::complex<double>* vector,
                   std::complex<double>* product);
  /// Replaces a square matrix by columns by its triangular factors, L with ones in its diagonal; row i of the matrix is
  /// row places[i] of their product.
  void (*factor)(double* matrix, std::ptrdiff_t size, int* places);
  void (*factor_single)(float* matrix, std::ptrdiff_t size, int* places);
  /// Solves by such factors, in place.
  void (*solve_single)(const float* factors, std::ptrdiff_t size, const int* places, const double* right,
                       double* solution);
};

}  // namespace viscoroll::detail

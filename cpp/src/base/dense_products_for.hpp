/// @file
/// @brief Dense products with Eigen, for the instruction set with which the including file is compiled.
///
/// Each including file defines its own name VISCOROLL_EIGEN, which replaces the namespace of Eigen. The linker
/// therefore cannot merge functions of Eigen that are compiled for different instruction sets.
#pragma once

#define Eigen VISCOROLL_EIGEN  // NOLINT(readability-identifier-naming)
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>

#include "base/dense_views.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Dynamic;
using Stride = Eigen::OuterStride<>;
using RowMajor = Eigen::Matrix<double, Dynamic, Dynamic, Eigen::RowMajor>;

template <class Matrix>
Eigen::Map<const Matrix, Eigen::Unaligned, Stride> map(const ConstMatrixView& view) {
  return {view.data, view.rows, view.columns, Stride(view.stride)};
}

template <class Left, class Right>
void add_as(const ConstMatrixView& left, const ConstMatrixView& right, const RowMajorView& sum) {
  Eigen::Map<RowMajor, Eigen::Unaligned, Stride> result(sum.data, sum.rows, sum.columns, Stride(sum.stride));
  const auto& factor = map<Left>(left);
  const auto& other = map<Right>(right);
  if (left.rows + left.columns + right.columns >= EIGEN_GEMM_TO_COEFFBASED_THRESHOLD) {
    result.noalias() += factor * other;
    return;
  }
  // Eigen evaluates small products in packets from the first aligned number on, so that their round-off would depend on
  // the address. These loops avoid that.
  for (Eigen::Index i = 0; i < sum.rows; ++i) {
    for (Eigen::Index j = 0; j < sum.columns; ++j) {
      double product = 0.0;
      for (Eigen::Index k = 0; k < left.columns; ++k) product += factor(i, k) * other(k, j);
      result(i, j) += product;
    }
  }
}

void add(const ConstMatrixView& left, const ConstMatrixView& right, const RowMajorView& sum) {
  using ColumnMajor = Eigen::MatrixXd;
  if (left.row_major) {
    right.row_major ? add_as<RowMajor, RowMajor>(left, right, sum) : add_as<RowMajor, ColumnMajor>(left, right, sum);
  } else {
    right.row_major ? add_as<ColumnMajor, RowMajor>(left, right, sum)
                    : add_as<ColumnMajor, ColumnMajor>(left, right, sum);
  }
}

void multiply(const ConstComplexMatrixView& matrix, const std::complex<double>* vector, std::complex<double>* product) {
  const Eigen::Map<const Eigen::MatrixXcd> left(matrix.data, matrix.rows, matrix.columns);
  const Eigen::Map<const Eigen::VectorXcd> right(vector, matrix.columns);
  Eigen::Map<Eigen::VectorXcd>(product, matrix.rows).noalias() = left * right;
}

template <class Scalar>
void factor(Scalar* matrix, std::ptrdiff_t size, int* places) {
  using Matrix = Eigen::Matrix<Scalar, Dynamic, Dynamic>;
  if (size == 0) return;
  // A copy in memory that is aligned for these instructions; otherwise the round-off would depend on the address.
  Matrix factors = Eigen::Map<Matrix>(matrix, size, size);
  Eigen::Ref<Matrix> in_place(factors);
  const Eigen::PartialPivLU<Eigen::Ref<Matrix>> lu(in_place);
  Eigen::Map<Matrix>(matrix, size, size) = factors;
  const auto& order = lu.permutationP().indices();
  std::copy_n(order.data(), size, places);
}

void solve_single(const float* factors, std::ptrdiff_t size, const int* places, const double* right, double* solution) {
  const Eigen::Map<const Eigen::MatrixXf> matrix(factors, size, size);
  Eigen::VectorXf unknowns(size);
  for (Eigen::Index row = 0; row < size; ++row) unknowns[places[row]] = static_cast<float>(right[row]);
  matrix.triangularView<Eigen::UnitLower>().solveInPlace(unknowns);
  matrix.triangularView<Eigen::Upper>().solveInPlace(unknowns);
  for (Eigen::Index row = 0; row < size; ++row) solution[row] = static_cast<double>(unknowns[row]);
}

constexpr DenseProducts kProducts{.add = add,
                                  .multiply = multiply,
                                  .factor = factor<double>,
                                  .factor_single = factor<float>,
                                  .solve_single = solve_single};

}  // namespace
}  // namespace viscoroll::detail

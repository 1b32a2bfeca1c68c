/// @file
/// @brief Products of dense matrices with the best instruction set of the machine.
///
/// The instruction set is selected at the first product. Influence tables spend most of their time in these products.
/// With AVX2 they are 3 times as fast as with SSE2, which every x86-64 processor has. With AVX-512 they would be 4.2
/// times as fast on a Xeon, which saves 5 % of the time of the computations with most products. On an EPYC AVX-512
/// saves nothing.
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <vector>

#include "base/dense_views.hpp"

namespace viscoroll::detail {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// @return implementations that this processor can run: first the baseline, then those with larger instruction sets
[[nodiscard]] std::vector<DenseProducts> usable_products();

/// @return implementation with the largest instruction set that this processor can run
[[nodiscard]] const DenseProducts& best_products();

/// @brief Add a product to a matrix: sum += left right.
/// @param[in] left,right matrices, blocks of matrices or their transposes
/// @param[in,out] sum matrix, block or transpose that shares no memory with `left` and `right`
template <class Left, class Right, class Sum>
void add_product(const Eigen::MatrixBase<Left>& left, const Eigen::MatrixBase<Right>& right, Sum&& sum) {
  using Target = std::remove_cvref_t<Sum>;
  if constexpr (Target::IsRowMajor) {
    const auto view = [](const auto& matrix) {
      return ConstMatrixView{.data = matrix.derived().data(),
                             .rows = matrix.rows(),
                             .columns = matrix.cols(),
                             .stride = matrix.derived().outerStride(),
                             .row_major = std::remove_cvref_t<decltype(matrix)>::IsRowMajor};
    };
    eigen_assert(left.rows() == sum.rows() && left.cols() == right.rows() && right.cols() == sum.cols());
    best_products().add(view(left), view(right),
                        {.data = sum.data(), .rows = sum.rows(), .columns = sum.cols(), .stride = sum.outerStride()});
  } else {
    add_product(right.transpose(), left.transpose(), sum.transpose());
  }
}

/// @return product left right, column-major
template <class Left, class Right>
[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixBase<Left>& left, const Eigen::MatrixBase<Right>& right) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(left.rows(), right.cols());
  add_product(left, right, result);
  return result;
}

/// @return product of a matrix and a vector
[[nodiscard]] inline Eigen::VectorXcd multiplied(const Eigen::MatrixXcd& matrix, const Eigen::VectorXcd& vector) {
  Eigen::VectorXcd result(matrix.rows());
  best_products().multiply({.data = matrix.data(), .rows = matrix.rows(), .columns = matrix.cols()}, vector.data(),
                           result.data());
  return result;
}

}  // namespace viscoroll::detail

/// @file
/// @brief Products of dense matrices by the best instruction set of the machine, chosen when the first one is asked
/// for: most of the time that tables take goes into them. By AVX2 they are 3 times as fast as by SSE2, which all of
/// their kind have. By AVX-512 they would be 4.2 times on a Xeon: a twentieth of what takes most of them, and on an
/// EPYC nothing.
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <vector>

#include "dense_views.hpp"

namespace viscoroll::detail {

/// @return the products for any processor of the kind, and those for more and more of what this one can do
[[nodiscard]] std::vector<DenseProducts> usable_products();

/// @return the last of them
[[nodiscard]] const DenseProducts& best_products();

/// @brief sum += left right.
/// @param[in] left,right,sum matrices, blocks of them or their transposes; `sum` shares no memory with the others
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

/// @return left right, by columns
template <class Left, class Right>
[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixBase<Left>& left, const Eigen::MatrixBase<Right>& right) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(left.rows(), right.cols());
  add_product(left, right, result);
  return result;
}

/// @return matrix vector
[[nodiscard]] inline Eigen::VectorXcd multiplied(const Eigen::MatrixXcd& matrix, const Eigen::VectorXcd& vector) {
  Eigen::VectorXcd result(matrix.rows());
  best_products().multiply({.data = matrix.data(), .rows = matrix.rows(), .columns = matrix.cols()}, vector.data(),
                           result.data());
  return result;
}

}  // namespace viscoroll::detail

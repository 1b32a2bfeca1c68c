/// @file
/// @brief Dense factorizations, compiled in one place: each takes seconds.
#pragma once

#include <Eigen/LU>

namespace viscoroll::detail {

/// @brief Systems of a square matrix, by its triangular factors.
class DenseFactors {
 public:
  void compute(const Eigen::MatrixXd& matrix);

  /// @return not finite where the matrix is singular
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

/// @return the inverse of a square matrix
[[nodiscard]] Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& matrix);

}  // namespace viscoroll::detail

/// @file
/// @brief Dense factorizations, compiled in one place: each takes seconds.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace viscoroll::detail {

/// @brief Systems of a square matrix, by its triangular factors: those of `DenseProducts`.
class DenseFactors {
 public:
  void compute(const Eigen::MatrixXd& matrix);

  /// @return not finite where the matrix is singular
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  Eigen::MatrixXd factors_;
  std::vector<int> places_;  // where the rows of the right side go
};

/// @brief The same to six digits, for what needs no more: a preconditioner.
class SingleFactors {
 public:
  void compute(const Eigen::MatrixXd& matrix);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  Eigen::MatrixXf factors_;
  std::vector<int> places_;
};

/// @return the inverse of a square matrix
[[nodiscard]] Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& matrix);

}  // namespace viscoroll::detail

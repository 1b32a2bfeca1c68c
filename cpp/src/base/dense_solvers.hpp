/// @file
/// @brief Dense factorizations. They are compiled in one source file, because each takes seconds to compile.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace viscoroll::detail {

/// @brief Triangular factors of a square matrix, computed by `DenseProducts`.
class DenseFactors {
 public:
  void compute(const Eigen::MatrixXd& matrix);

  /// @return solution; not finite if the matrix is singular
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  Eigen::MatrixXd factors_;
  std::vector<int> places_;  // permuted position of each row of the right-hand side
};

/// @brief Triangular factors of a square matrix in single precision, for preconditioners (six digits).
class SingleFactors {
 public:
  void compute(const Eigen::MatrixXd& matrix);
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  Eigen::MatrixXf factors_;
  std::vector<int> places_;
};

/// @return inverse of a square matrix
[[nodiscard]] Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& matrix);

}  // namespace viscoroll::detail

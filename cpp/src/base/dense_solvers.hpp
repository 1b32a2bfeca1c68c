/// @file
/// @brief Dense factorizations, inverses and least squares. They are compiled in one source file, because each
/// factorization takes seconds to compile.
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

/// @brief Compute the bordered inverse from the Schur complement of the added rows.
/// @param[in] inverse inverse of the earlier matrix; may be empty
/// @param[in] beside compliance between earlier and added unknowns, [earlier, added]
/// @param[in] corner compliance between added unknowns, [added, added]
/// @return inverse of the whole matrix, with the added unknowns last
[[nodiscard]] Eigen::MatrixXd bordered_inverse(const Eigen::MatrixXd& inverse, const Eigen::MatrixXd& beside,
                                               Eigen::MatrixXd corner);

/// @brief Minimize |A x - b| with x >= 0, by the active set of C. L. Lawson and R. J. Hanson, Solving Least Squares
/// Problems (1974), chapter 23.
/// @param[in] matrix A
/// @param[in] right b
/// @return x
[[nodiscard]] Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace viscoroll::detail

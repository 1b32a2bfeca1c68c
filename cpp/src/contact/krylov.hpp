/// @file
/// @brief Linear systems that are known by their products alone.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace viscoroll::detail {

/// @brief A linear map.
using LinearOperator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// @brief What a Krylov solve came to.
struct KrylovSolution {
  Eigen::VectorXd unknowns;
  int products;  ///< with the matrix
  double error;  ///< relative residual
};

/// @brief Solve A x = b by BiCGSTAB, for a matrix that is not symmetric.
/// @param[in] matrix A
/// @param[in] preconditioner approximate inverse of A
/// @param[in] right b
/// @param[in] guess to start from
/// @param[in] tolerance of the relative residual
[[nodiscard]] KrylovSolution solve_krylov(const LinearOperator& matrix, const LinearOperator& preconditioner,
                                          const Eigen::VectorXd& right, const Eigen::VectorXd& guess,
                                          double tolerance);

}  // namespace viscoroll::detail

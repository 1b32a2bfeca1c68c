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

/// @brief Which method solves a system.
enum class KrylovMethod {
  cg,        ///< conjugate gradients, for a symmetric positive definite matrix: one product per iteration
  bicgstab,  ///< for any other: two
  gmres,     ///< for any other: one, and memory for a vector; the residuals are those of the preconditioned system
};

/// @brief Solve A x = b.
/// @param[in] method BiCGSTAB, or CG where A and the preconditioner allow it
/// @param[in] matrix A
/// @param[in] preconditioner approximate inverse of A
/// @param[in] right b
/// @param[in] guess to start from
/// @param[in] tolerance of the relative residual
[[nodiscard]] KrylovSolution solve_krylov(KrylovMethod method, const LinearOperator& matrix,
                                          const LinearOperator& preconditioner, const Eigen::VectorXd& right,
                                          const Eigen::VectorXd& guess, double tolerance);

}  // namespace viscoroll::detail

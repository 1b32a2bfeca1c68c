/// @file
/// @brief Iterative solution of linear systems given by matrix-vector products.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace viscoroll::detail {

/// @brief A linear map.
using LinearOperator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// @brief Result of a Krylov solution.
struct KrylovSolution {
  Eigen::VectorXd unknowns;
  int products;     ///< number of products with the matrix
  double residual;  ///< norm of b - A x
};

/// Relative residual of frictionless contact above which a solution is unusable.
inline constexpr double kUnusableResidual = 1e-8;

/// @brief Tolerance and cost of a Krylov solution, which ends when the norm of the residual is below either tolerance.
struct KrylovTolerance {
  double absolute = 0.0;
  double relative = 0.0;  ///< relative to the residual of the guess
  /// Number of unknowns up to which the method may take as many directions as unknowns.
  Eigen::Index small_system = 600;
};

/// @brief Solve A x = b by GMRES (Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856-869), preconditioned from
/// the right, so that the residuals are those of the system itself.
/// @param[in] matrix A
/// @param[in] preconditioner approximate inverse of A
/// @param[in] right b
/// @param[in] guess initial x
/// @param[in] tolerance tolerance of the residual
/// @param[in] residual b - A x for the guess, if it is known, which saves a product
[[nodiscard]] KrylovSolution solve_krylov(const LinearOperator& matrix, const LinearOperator& preconditioner,
                                          const Eigen::VectorXd& right, const Eigen::VectorXd& guess,
                                          const KrylovTolerance& tolerance,
                                          std::optional<Eigen::VectorXd> residual = std::nullopt);

}  // namespace viscoroll::detail

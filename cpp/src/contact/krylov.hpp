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
  int products;     ///< with the matrix
  double residual;  ///< norm of b - A x
};

/// @brief When a residual is small enough: as soon as its norm is below one of the two. And what that may cost.
struct KrylovTolerance {
  double absolute = 0.0;
  double relative = 0.0;            ///< to the residual of the guess
  Eigen::Index small_system = 600;  ///< unknowns up to which all directions may be taken, where few do not do
};

/// @brief Solve A x = b by GMRES (Saad and Schultz, SIAM J. Sci. Stat. Comput. 7 (1986) 856-869), preconditioned from
/// the right, so that the residuals are those of the system itself.
/// @param[in] matrix A
/// @param[in] preconditioner approximate inverse of A
/// @param[in] right b
/// @param[in] guess to start from
/// @param[in] tolerance of the residual
[[nodiscard]] KrylovSolution solve_krylov(const LinearOperator& matrix, const LinearOperator& preconditioner,
                                          const Eigen::VectorXd& right, const Eigen::VectorXd& guess,
                                          const KrylovTolerance& tolerance);

}  // namespace viscoroll::detail

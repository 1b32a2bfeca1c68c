/// @file
/// @brief The contact equations without their matrix: products by FFT, and a Krylov method.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/coating_compliance.hpp"
#include "influence/inverse_convolution.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief What a Krylov solve came to.
struct KrylovSolution {
  Eigen::VectorXd forces;
  int iterations;
  double error;  ///< relative residual
};

/// @brief Pressing forces on some nodes that lower them by given amounts, by BiCGSTAB (the matrix is not symmetric)
/// with the inverse of the vertical compliance's periodic symbol as preconditioner.
/// @param[in] coating compliance
/// @param[in] preconditioner of its table for r by r
/// @param[in] nodes that carry forces
/// @param[in] lowering of each of them, C p [m]
/// @param[in] guess forces to start from [N]
/// @param[in] tolerance of the relative residual
/// @param[in] watch progress and cancellation, polled at every product
[[nodiscard]] KrylovSolution solve_krylov(const CoatingCompliance& coating, const InverseConvolution& preconditioner,
                                          const std::vector<Eigen::Index>& nodes, const Eigen::VectorXd& lowering,
                                          const Eigen::VectorXd& guess, double tolerance, Watch& watch);

}  // namespace viscoroll::detail

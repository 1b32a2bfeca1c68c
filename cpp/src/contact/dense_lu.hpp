/// @file
/// @brief Dense linear systems of contact problems, on all cores and ready to stop.
#pragma once

#include <Eigen/Core>

#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief Solve A X = B by block elimination without pivoting between blocks.
///
/// The symmetric part of a compliance matrix is positive definite (forces cannot gain work from the coating), and so
/// are those of its Schur complements: every pivot block is regular and the elimination stable (Golub and Van Loan,
/// Matrix Computations, section 4.3.2).
/// @param[in] matrix A, with positive definite symmetric part; used up
/// @param[in] right_sides B, one column for each system; used up
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation, polled every few milliseconds
/// @return X
[[nodiscard]] Eigen::MatrixXd solve_dense(Eigen::MatrixXd matrix, Eigen::MatrixXd right_sides, int threads,
                                          Watch& watch);

}  // namespace viscoroll::detail

/// @file
/// @brief Inverse of a symmetric matrix to which rows and columns are added.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief Compute the bordered inverse from the Schur complement of the added rows.
/// @param[in] inverse inverse of the earlier matrix; may be empty
/// @param[in] beside compliance between earlier and added unknowns, [before, added]
/// @param[in] corner compliance between added unknowns, [added, added]
/// @return inverse of the whole matrix, with the added unknowns last
[[nodiscard]] Eigen::MatrixXd bordered_inverse(const Eigen::MatrixXd& inverse, const Eigen::MatrixXd& beside,
                                               Eigen::MatrixXd corner);

}  // namespace viscoroll::detail

/// @file
/// @brief Inverses of symmetric matrices that gain rows and columns.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

/// @brief By the complement that the rows before leave of those that are added.
/// @param[in] inverse of the rows before, may have none
/// @param[in] beside [before, added]
/// @param[in] corner [added, added]
/// @return the inverse of all of them, the added ones last
[[nodiscard]] Eigen::MatrixXd bordered_inverse(const Eigen::MatrixXd& inverse, const Eigen::MatrixXd& beside,
                                               Eigen::MatrixXd corner);

}  // namespace viscoroll::detail

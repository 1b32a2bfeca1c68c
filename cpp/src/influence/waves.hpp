/// @file
/// @brief Waves of several orders at offsets, those of a mesh or others.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// @brief Cosines and sines of order times offset, a row for each order and a column for each offset.
struct Waves {
  RowMajorMatrix cosines;
  RowMajorMatrix sines;
};

/// @param[in] orders not necessarily whole
/// @param[in] spacing of the offsets, which start from 0 [rad]
/// @param[in] reach largest offset [spacings]
[[nodiscard]] Waves make_waves(const Eigen::ArrayXd& orders, double spacing, int reach);

/// @param[in] orders not necessarily whole
/// @param[in] offsets anywhere [rad]
[[nodiscard]] Waves make_waves(const Eigen::ArrayXd& orders, const Eigen::ArrayXd& offsets);

}  // namespace viscoroll::detail

/// @file
/// @brief Waves of several orders at the offsets of a mesh.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// @brief Cosines and sines of order times offset, a row for each order and a column for each offset from 0.
struct Waves {
  RowMajorMatrix cosines;
  RowMajorMatrix sines;
};

/// @param[in] orders not necessarily whole
/// @param[in] spacing of the offsets [rad]
/// @param[in] reach largest offset [spacings]
[[nodiscard]] Waves make_waves(const Eigen::ArrayXd& orders, double spacing, int reach);

}  // namespace viscoroll::detail

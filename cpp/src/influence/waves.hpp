/// @file
/// @brief Waves of several orders at the offsets of a mesh or at other offsets.
#pragma once

#include <Eigen/Core>

namespace viscoroll::detail {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// @brief Cosines and sines of order times offset, one row per order and one column per offset.
struct Waves {
  RowMajorMatrix cosines;
  RowMajorMatrix sines;
};

/// @param[in] orders orders, not necessarily whole
/// @param[in] spacing spacing of the offsets, which start at 0 [rad]
/// @param[in] last_offset number of spacings to the largest offset
[[nodiscard]] Waves make_waves(const Eigen::ArrayXd& orders, double spacing, int last_offset);

/// @param[in] orders orders, not necessarily whole
/// @param[in] offsets any offsets [rad]
[[nodiscard]] Waves make_waves(const Eigen::ArrayXd& orders, const Eigen::ArrayXd& offsets);

}  // namespace viscoroll::detail

/// @file
/// @brief Effect of the free sides of a tread on the influence of its rows of nodes.
#pragma once

#include "influence/side_sum.hpp"
#include "transient/mirrored_tables.hpp"

namespace viscoroll::detail {

/// @brief Influence in the form of `MirroredTables`, for mirror-symmetric forces, to which the even part of the section
/// responds.
///
/// Forces are gathered by means over patches, and displacements are read at nodes. Half the sum of this and of the
/// reverse is symmetric and does the same work.
/// @param[in] difference difference of the section for as many components; its even part is used
/// @param[in] factors factors at offsets along phi
/// @param[in] shape rows of nodes
/// @param[in] column_distance distance between neighboring nodes across [m]
/// @return influence of a row on the rows 0, 1, ... ahead, up to the reach of the factors, one below the other [m/N]
[[nodiscard]] HalfField side_influence(const SampledDifference& difference, const SideFactors& factors,
                                       const RowShape& shape, double column_distance);

}  // namespace viscoroll::detail

/// @file
/// @brief What the free sides of a tread add to the influence of its rows of nodes.
#pragma once

#include "influence/side_sum.hpp"
#include "transient/mirrored_tables.hpp"

namespace viscoroll::detail {

/// @brief As `MirroredTables` have it, of loads that are mirror images, which the even part of the section bears.
///
/// Means over patches are what forces are gathered by, values at nodes what is read: half the sum of that and of the
/// other way round is symmetric, and does the same work.
/// @param[in] difference of the section, of loads with as many components; its even part
/// @param[in] factors at offsets along phi
/// @param[in] shape of the rows
/// @param[in] column_distance between neighbors across [m]
/// @return influence of a row on those 0, 1, ... ahead, as far as the factors reach, one below the other [m/N]
[[nodiscard]] HalfField side_influence(const SampledDifference& difference, const SideFactors& factors,
                                       const RowShape& shape, double column_distance);

}  // namespace viscoroll::detail

/// @file
/// @brief Effect of the free side faces of a tread on its influence: the difference between the influence of the tread
/// and that of an unbounded one.
#pragma once

#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "creep/layer_spectrum.hpp"
#include "creep/mirrored_tables.hpp"
#include "influence/side_influence.hpp"
#include "section/side_difference.hpp"

namespace viscoroll::detail {

/// @brief Weights in the form of `LayerSpectrum::weights_of`: the sums over retardation times use sections solved at
/// complex moduli around these times. The process keeps the results of the last few treads.
/// @param[in] layers layers of the unbounded tread
/// @param[in] tread at least one layer
/// @param[in] tangential whether forces along phi and z occur, or forces along r only
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @return weights for the instantaneous compliance and for each retardation time: even parts at some orders [1/Pa/m]
[[nodiscard]] std::shared_ptr<const std::vector<SampledDifference>> side_weights(const LayerSpectrum& layers,
                                                                                 const CoatedWheel& tread,
                                                                                 bool tangential, int threads,
                                                                                 Watch& watch);

/// @brief Sum over all orders, which all weights share.
/// @param[in] weights at least one weight
/// @param[in] layers layers of the tread
/// @param[in] mesh mesh of the tread
[[nodiscard]] SideSum sum_of_side_weights(const std::shared_ptr<const std::vector<SampledDifference>>& weights,
                                          const LayerSpectrum& layers, const MeshOnBody& mesh);

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

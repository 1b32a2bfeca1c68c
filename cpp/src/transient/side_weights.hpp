/// @file
/// @brief Effect of free sides on the weights of layers with different relaxation functions, order by order.
#pragma once

#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "influence/side_sum.hpp"
#include "section/side_difference.hpp"
#include "transient/layer_spectrum.hpp"

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

}  // namespace viscoroll::detail

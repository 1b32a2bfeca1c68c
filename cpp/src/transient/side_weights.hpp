/// @file
/// @brief What free sides add to the weights of layers that do not creep alike, order by order.
#pragma once

#include <memory>
#include <vector>

#include "influence/side_sum.hpp"
#include "parallel.hpp"
#include "section/side_difference.hpp"
#include "transient/layer_spectrum.hpp"

namespace viscoroll::detail {

/// @brief As `LayerSpectrum::weights_of`: sums over retardation times are taken from sections solved at complex moduli
/// around them. The last few treads of the process are kept.
/// @param[in] layers of the tread as if without sides
/// @param[in] tread at least one layer
/// @param[in] tangential whether loads along phi and z occur, or those along r alone
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @return of what yields at once, and of each retardation time: even parts at some orders [1/Pa/m]
[[nodiscard]] std::shared_ptr<const std::vector<SampledDifference>> side_weights(const LayerSpectrum& layers,
                                                                                 const CoatedWheel& tread,
                                                                                 bool tangential, int threads,
                                                                                 Watch& watch);

/// @return the sums over all orders that every one of them has
/// @param[in] weights at least one
/// @param[in] layers of the tread
/// @param[in] mesh on it
[[nodiscard]] SideSum sum_of_side_weights(const std::shared_ptr<const std::vector<SampledDifference>>& weights,
                                          const LayerSpectrum& layers, const MeshOnBody& mesh);

}  // namespace viscoroll::detail

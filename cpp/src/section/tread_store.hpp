/// @file
/// @brief Differences of treads' sections, kept for further speeds, loads and meshes.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "section/side_difference.hpp"

namespace viscoroll::detail {

/// @brief What faces change of a tread in one or several respects. The last few treads of the process are kept, by
/// their dimensions and by what else they depend on.
/// @param[in] wheel at least one layer
/// @param[in] tangential whether loads along phi and z occur, or those along r alone
/// @param[in] numbers all else that the differences depend on
/// @param[in] find them, where they are not kept
[[nodiscard]] std::shared_ptr<const std::vector<SampledDifference>> kept_differences(
    const CoatedWheel& wheel, bool tangential, const std::vector<double>& numbers,
    const std::function<std::vector<SampledDifference>()>& find);

/// @brief What faces change of a tread that rolls: layers that share one relaxation function are solved once for all
/// speeds, for they are kept by what they are to the outermost one.
/// @param[in] wheel at least one layer
/// @param[in] body its layers at the orders of `sampled_orders`
/// @param[in] tangential whether loads along phi and z occur, or those along r alone
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
[[nodiscard]] std::shared_ptr<const SampledDifference> kept_difference(const CoatedWheel& wheel,
                                                                       const HarmonicBody& body, bool tangential,
                                                                       int threads, Watch& watch);

}  // namespace viscoroll::detail

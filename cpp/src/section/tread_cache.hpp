/// @file
/// @brief Cache of the differences between treads with faces and endless treads, which further speeds, loads and meshes
/// use.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "section/side_difference.hpp"

namespace viscoroll::detail {

/// @brief Differences between a tread with faces and an endless one, from a cache of the last few treads of the
/// process.
///
/// The key contains the dimensions of the wheel and all other numbers on which the differences depend.
/// @param[in] wheel wheel with at least one layer
/// @param[in] tangential whether there are tangential loads besides normal ones
/// @param[in] numbers all other numbers on which the differences depend
/// @param[in] compute function that computes the differences if the cache does not contain them
/// @return the differences
[[nodiscard]] std::shared_ptr<const std::vector<SampledDifference>> cached_differences(
    const CoatedWheel& wheel, bool tangential, const std::vector<double>& numbers,
    const std::function<std::vector<SampledDifference>()>& compute);

/// @brief Difference between a rolling tread with faces and an endless one.
///
/// The key contains the moduli relative to that of the outermost layer, so that layers that share one relaxation
/// function are solved once for all speeds.
/// @param[in] wheel wheel with at least one layer
/// @param[in] body its layers at the orders of `sampled_orders`
/// @param[in] tangential whether there are tangential loads besides normal ones
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @return the difference
[[nodiscard]] std::shared_ptr<const SampledDifference> cached_difference(const CoatedWheel& wheel,
                                                                         const HarmonicBody& body, bool tangential,
                                                                         int threads, Watch& watch);

}  // namespace viscoroll::detail

/// @file
/// @brief Orders and frequencies at which the creep of layers is evaluated.
#pragma once

#include <vector>

#include "modal/layered_body.hpp"
#include "transient/creep_spectrum.hpp"

namespace viscoroll::detail {

/// @brief An order of a surface, not necessarily an integer.
struct SurfaceOrder {
  double m;  ///< along
  double n;  ///< across
};

/// @return frequencies of a range of times at equal ratios, without those outside a master curve [rad/s]
[[nodiscard]] std::vector<double> compared_frequencies(const std::vector<Layer>& layers, const TimeRange& range);

/// @return orders at equal ratios, for waves from much longer than the total thickness to much shorter than every layer
[[nodiscard]] std::vector<SurfaceOrder> compared_orders(const LayeredBody& body);

}  // namespace viscoroll::detail

/// @file
/// @brief Orders and frequencies at which the creep of layers is looked at.
#pragma once

#include <vector>

#include "modal/layered_body.hpp"
#include "transient/creep_spectrum.hpp"

namespace viscoroll::detail {

/// @brief An order of a surface, not necessarily whole.
struct SurfaceOrder {
  double m;  ///< along
  double n;  ///< across
};

/// @return frequencies of a range of times, at equal ratios, without those that a master curve refuses [rad/s]
[[nodiscard]] std::vector<double> compared_frequencies(const std::vector<Layer>& layers, const TimeRange& range);

/// @return orders at equal ratios, from waves that are far longer than all layers are thick to such as are far shorter
[[nodiscard]] std::vector<SurfaceOrder> compared_orders(const LayeredBody& body);

}  // namespace viscoroll::detail

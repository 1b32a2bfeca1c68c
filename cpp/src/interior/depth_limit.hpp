/// @file
/// @brief Up to which order anything of the surface is seen at a depth.
#pragma once

#include <vector>

#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// @brief Orders fall like exp(-k ln(r_o / r)), with inertia more slowly.
class DepthLimit {
 public:
  DepthLimit(const CoatedSphere& sphere, double angular_speed);

  /// @param[in] place where
  /// @param[in] exponent what is left of an order is exp(-exponent)
  /// @return the order k; infinite at the surface
  [[nodiscard]] double operator()(const Place& place, double exponent) const;

 private:
  double radius_;
  double decay_;  // per k of what there is without inertia
};

}  // namespace viscoroll::detail

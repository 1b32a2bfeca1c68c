/// @file
/// @brief Depth below which an order is negligible.
#pragma once

#include <complex>

#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @brief Decay rate of shear waves with depth, relative to k: sqrt(1 - mach^2), which inertia makes small.
/// @param[in] mach2 square of the ratio of the speed of waves along the surface to the shear wave speed
/// @return ratio, at least 0.05
[[nodiscard]] double shear_decay(std::complex<double> mach2);

/// @brief Position below which material does not affect the surface.
///
/// Solutions decay like exp(-k depth) or, with inertia, like shear waves. A core affects the lowest orders from any
/// depth.
/// @param[in] layers layers with their moduli at this order
/// @param[in] m,n order along and across
/// @param[in] exponent the order has decayed to exp(-exponent) at the returned position
/// @return position [m]; -infinity if all layers affect the surface
template <class Scalar>
[[nodiscard]] double deepest_position(const LayerStack<Scalar>& layers, double m, double n, double exponent);

/// @brief Highest order that reaches a position, the inverse of `deepest_position`.
class DepthLimit {
 public:
  /// @param[in] body layers
  /// @param[in] angular_speed Omega [rad/s]
  DepthLimit(const LayeredBody& body, double angular_speed);

  /// @param[in] position position along the normal [m]
  /// @param[in] exponent the returned order has decayed to exp(-exponent) at the position
  /// @return order k; infinite at the surface
  [[nodiscard]] double operator()(double position, double exponent) const;

 private:
  Metric metric_;
  double decay_ = 1.0;  // decay rate relative to that without inertia
};

extern template double deepest_position(const LayerStack<double>&, double, double, double);
extern template double deepest_position(const LayerStack<std::complex<double>>&, double, double, double);

}  // namespace viscoroll::detail

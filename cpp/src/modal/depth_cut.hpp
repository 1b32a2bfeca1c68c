/// @file
/// @brief How deep an order reaches: what lies below is left out.
#pragma once

#include <complex>

#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @return share of k by which shear waves die out with depth, sqrt(1 - mach^2), which inertia makes small
/// @param[in] mach2 square of the speed at which waves pass along the surface, per that of shear waves
[[nodiscard]] double shear_decay(std::complex<double> mach2);

/// @brief Place below which material is out of reach of the surface. Solutions fall like exp(-k depth) or, with
/// inertia, like shear waves; those of the lowest orders hold on to a core from any depth.
/// @param[in] layers as the order sees them
/// @param[in] m,n order along and across
/// @param[in] exponent what is left of the order there is exp(-exponent)
/// @return place [m]; -infinity where everything is within reach
template <class Scalar>
[[nodiscard]] double deepest_place(const LayerStack<Scalar>& layers, double m, double n, double exponent);

/// @brief The reverse: up to which order anything of the surface is seen at a place.
class DepthLimit {
 public:
  /// @param[in] body layers
  /// @param[in] angular_speed Omega [rad/s]
  DepthLimit(const LayeredBody& body, double angular_speed);

  /// @param[in] place where
  /// @param[in] exponent what is left of an order is exp(-exponent)
  /// @return the order k; infinite at the surface
  [[nodiscard]] double operator()(double place, double exponent) const;

 private:
  Metric metric_;
  double decay_ = 1.0;  // per k of what there is without inertia
};

extern template double deepest_place(const LayerStack<double>&, double, double, double);
extern template double deepest_place(const LayerStack<std::complex<double>>&, double, double, double);

}  // namespace viscoroll::detail

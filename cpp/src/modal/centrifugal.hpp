/// @file
/// @brief The coating under the centrifugal load.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @brief u_r [m] and r sigma_rr [N/m] under the centrifugal load: order m = n = 0.
/// @param[in] layers as order 0 sees them
/// @return at the inner boundary of the innermost layer and at the outer one of each
[[nodiscard]] std::vector<Eigen::Vector2d> centrifugal_states(const LayerStack<std::complex<double>>& layers);

/// @brief Uniform displacement of the surface of a body.
/// @param[in] body any: a plane does not turn, and has none
/// @param[in] angular_speed Omega [rad/s], > 0
/// @return d_R^(c) [m], outwards
[[nodiscard]] double centrifugal_displacement(const LayeredBody& body, double angular_speed);

}  // namespace viscoroll::detail

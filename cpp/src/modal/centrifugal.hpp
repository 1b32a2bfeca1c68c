/// @file
/// @brief Displacement and stress of the layers under the centrifugal load.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "modal/layered_body.hpp"

namespace viscoroll::detail {

/// @brief Radial displacement u_r [m] and r sigma_rr [N/m] under the centrifugal load, order m = n = 0.
/// @param[in] layers layers with their moduli at order m = 0, the relaxed moduli
/// @return (u_r, r sigma_rr) at the inner boundary of the innermost layer, then at the outer boundary of each layer
[[nodiscard]] std::vector<Eigen::Vector2d> centrifugal_states(const LayerStack<std::complex<double>>& layers);

/// @brief Uniform displacement of the surface of a body under the centrifugal load.
/// @param[in] body any body
/// @param[in] angular_speed Omega [rad/s], > 0
/// @return d_R^(c) [m], outwards; 0 for a plane, which does not turn
[[nodiscard]] double centrifugal_displacement(const LayeredBody& body, double angular_speed);

}  // namespace viscoroll::detail

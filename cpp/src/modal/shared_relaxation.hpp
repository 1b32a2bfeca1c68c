/// @file
/// @brief Layers that share one relaxation function. Relative to its modulus their equations are real.
#pragma once

#include <cstddef>
#include <optional>

#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief Layers of a body in units of g, if mu_l*(w) = c_l g(w) at all its orders and all Poisson's ratios are real
/// and constant.
/// @param[in] body body with layers at a list of orders
/// @param[in] reference index of the layer whose modulus is g
/// @param[in] highest_density density for which rho Omega^2 r_o^2 is set to 1 [kg/m^3]; 0: without inertia
/// @return layers; none if there is no such g
[[nodiscard]] std::optional<LayerStack<double>> layers_per_modulus(const HarmonicBody& body, std::size_t reference,
                                                                   double highest_density);

}  // namespace viscoroll::detail

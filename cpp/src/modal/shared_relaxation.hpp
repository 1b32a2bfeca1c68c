/// @file
/// @brief Layers whose moduli are those of one relaxation function: real but for its modulus.
#pragma once

#include <cstddef>
#include <optional>

#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief The layers of a body in units of g, where mu_l*(w) = c_l g(w) at all its orders and Poisson's ratios are real
/// and constant.
/// @param[in] body which one
/// @param[in] reference layer whose modulus is g
/// @param[in] highest_density for which rho Omega^2 r_o^2 is 1 [kg/m^3]; 0 leaves inertia out
/// @return nothing where there is no such g
[[nodiscard]] std::optional<LayerStack<double>> layers_per_modulus(const HarmonicBody& body, std::size_t reference,
                                                                   double highest_density);

}  // namespace viscoroll::detail

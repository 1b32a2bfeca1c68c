/// @file
/// @brief Input checks of the layers of a body.
#pragma once

#include <span>

#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Check each layer.
/// @throws InvalidInput for invalid input, which the message names "layers[j].<parameter>"
void require_layers(std::span<const Layer> layers);

/// @brief Check that the layers and the core are not too small relative to the body (`kLargestLengthRatio`).
/// @param[in] layers checked layers of a ball, roller or wheel
/// @param[in] core_radius radius of the core [m]; 0 for a solid ball
/// @throws InvalidInput if a layer or the core is too small
void require_lengths(std::span<const Layer> layers, double core_radius);

}  // namespace viscoroll::detail

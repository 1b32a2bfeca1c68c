/// @file
/// @brief Checks of the layers of a body.
#pragma once

#include <span>

#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @throws std::invalid_argument for bad input, named "layers[j].<parameter>"
void require_layers(std::span<const Layer> layers);

/// @param[in] layers of a ball, a roller or a wheel, which have been checked one by one
/// @param[in] core_radius [m], 0 of a solid ball
/// @throws std::invalid_argument where a layer or the core is too small beside the body, see `kLargestLengthRatio`
void require_lengths(std::span<const Layer> layers, double core_radius);

}  // namespace viscoroll::detail

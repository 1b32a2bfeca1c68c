/// @file
/// @brief The coating under the centrifugal load.
#pragma once

#include "modal/medium.hpp"

namespace viscoroll::detail {

/// @brief As `viscoroll::centrifugal_displacement`, of a coating at order 0.
/// @return d_R^(c) [m], outwards
[[nodiscard]] double centrifugal_displacement(const HarmonicCoating& coating);

}  // namespace viscoroll::detail

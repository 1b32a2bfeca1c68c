/// @file
/// @brief The coating under the centrifugal load.
#pragma once

#include <span>

#include "modal/medium.hpp"

namespace viscoroll::detail {

/// @brief As `viscoroll::centrifugal_displacement`, of a coating at order 0.
/// @return d_R^(c) [m], outwards
[[nodiscard]] double centrifugal_displacement(const HarmonicCoating& coating);

/// @brief The same of a cylinder, in plane strain.
/// @param[in] media layers at rest, core outwards
[[nodiscard]] double cylinder_centrifugal_displacement(std::span<const Medium<std::complex<double>>> media);

}  // namespace viscoroll::detail

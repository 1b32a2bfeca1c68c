/// @file
/// @brief The coating under the centrifugal load.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <span>
#include <vector>

#include "modal/medium.hpp"

namespace viscoroll::detail {

/// @brief As `viscoroll::centrifugal_displacement`, of a coating at order 0.
/// @return d_R^(c) [m], outwards
[[nodiscard]] double centrifugal_displacement(const HarmonicCoating& coating);

/// @brief The same of a cylinder, in plane strain.
/// @param[in] media layers at rest, core outwards
[[nodiscard]] double cylinder_centrifugal_displacement(std::span<const Medium<std::complex<double>>> media);

/// @brief u_r [m] and r sigma_rr [N/m] of a sphere under the centrifugal load.
/// @param[in] media layers at order 0, from the center outwards
/// @return at the inner boundary of the innermost layer and at the outer radius of each
[[nodiscard]] std::vector<Eigen::Vector2d> centrifugal_states(std::span<const Medium<std::complex<double>>> media);

}  // namespace viscoroll::detail

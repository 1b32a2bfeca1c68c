/// @file
/// @brief The coating as the contact sees it: matrices over the nodes of a window, for nodal forces along the vertical.
#pragma once

#include <memory>
#include <vector>

#include "contact/surface_window.hpp"
#include "influence/convolution.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {

/// @brief Which terms of C_r = Q^T C_s Q are kept, and how patches are loaded.
struct Formulation {
  Compliance compliance;
  PatchLoad patch_load;
};

/// @brief Tables that the operators of a formulation are made of.
[[nodiscard]] std::vector<TableRequest> required_tables(const Formulation& formulation);

/// @brief Matrices that take vertical nodal forces [N] to what they do.
struct CoatingOperators {
  ScaledConvolution vertical;  ///< vertical displacement [m]: C_WW, or C_RR in its place
  ScaledConvolution backward;  ///< backward displacement [m]: C_UW; zero with the radial compliance
  ScaledConvolution power;     ///< with forces on both sides, power lost per radian of turning [N m]
};

/// @brief Combine tables into operators.
/// @param[in] formulation as for `required_tables`
/// @param[in] window nodes
/// @param[in] tables for the requests of `required_tables`, reaching across the window
[[nodiscard]] CoatingOperators make_operators(const Formulation& formulation, const SurfaceWindow& window,
                                              std::shared_ptr<const std::vector<Table>> tables);

}  // namespace viscoroll::detail

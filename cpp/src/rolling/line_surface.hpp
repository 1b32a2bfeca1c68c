/// @file
/// @brief Surfaces of rollers, and of what they roll on, in line contact: theory.md section 14.
#pragma once

#include <complex>
#include <memory>

#include "influence/table_sum.hpp"
#include "modal/layered_body.hpp"
#include "parallel.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief One of two surfaces, on the mesh of the first.
struct LineSurface {
  std::unique_ptr<const TableSum> sum;  ///< none of a rigid body
  std::complex<double> normal = 0.0;    ///< compliance of the mesh's highest order [m/Pa]
  std::complex<double> along = 0.0;     ///< the same along the way of the material
  double stiffest_modulus = 0.0;        ///< largest shear modulus of a layer at the highest harmonic [Pa]
  double centrifugal = 0.0;             ///< d_R^(c) [m]
};

/// @param[in] body the roller whose mesh it is, another one, or a plane with the first one's radius
/// @param[in] surface_speed V [m/s] at which its material crosses the contact
/// @param[in] arc of neighboring nodes [m]
/// @param[in] mesh that of the first roller
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
[[nodiscard]] LineSurface line_surface(const LayeredBody& body, double surface_speed, double arc, const Mesh& mesh,
                                       int threads, Watch& watch);

}  // namespace viscoroll::detail

/// @file
/// @brief Surfaces of rollers, and of what they roll on, in line contact: theory.md section 14.
#pragma once

#include <complex>
#include <memory>

#include "influence/table_sum.hpp"
#include "parallel.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll::detail {

/// @brief One of two surfaces, on the mesh of the first.
struct LineSurface {
  std::unique_ptr<const TableSum> sum;  ///< none of a rigid body
  std::complex<double> normal = 0.0;    ///< compliance of the mesh's highest order [m/Pa]
  std::complex<double> along = 0.0;     ///< the same along the way of the material
  double stiffest_modulus = 0.0;        ///< largest shear modulus of a layer at the highest harmonic [Pa]
  double centrifugal = 0.0;             ///< d_R^(c) [m]
};

/// @param[in] cylinder the roller whose mesh it is, or another one
/// @param[in] surface_speed V [m/s] at which its material crosses the contact
/// @param[in] arc of neighboring nodes [m]
/// @param[in] mesh that of the first roller
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
[[nodiscard]] LineSurface roller_surface(const CoatedCylinder& cylinder, double surface_speed, double arc,
                                         const Mesh& mesh, int threads, Watch& watch);

/// @param[in] plane layers and base, or rigid
/// @param[in] surface_speed V [m/s]
/// @param[in] radius of what rolls on it [m]
/// @param[in] mesh that of what rolls on it
[[nodiscard]] LineSurface plane_surface(const CoatedPlane& plane, double surface_speed, double radius,
                                        const Mesh& mesh);

}  // namespace viscoroll::detail

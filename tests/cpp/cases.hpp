/// @file
/// @brief Spheres that several tests share.
#pragma once

#include "viscoroll/modulus_functions.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll::cases {

/// Standard linear solid of the paper's section 14.
inline Prony rubber() { return standard_linear_solid(6e6, 3e6, 0.125); }

/// The paper's section 14: 20 mm core, 1 mm incompressible coating.
inline CoatedSphere paper_sphere(double density = 1000.0) {
  return {.core_radius = 20e-3,
          .layers = {{.thickness = 1e-3, .shear_modulus = rubber(), .poisson_ratio = 0.5, .density = density}}};
}

/// Two layers with different relaxation functions.
inline CoatedSphere dissimilar_layers(double density = 0.0) {
  return {.core_radius = 20e-3,
          .layers = {{.thickness = 2e-3, .shear_modulus = rubber(), .poisson_ratio = 0.45, .density = density},
                     {.thickness = 1e-3, .shear_modulus = Elastic{2e6}, .bulk_modulus = 1e9, .density = density}}};
}

}  // namespace viscoroll::cases

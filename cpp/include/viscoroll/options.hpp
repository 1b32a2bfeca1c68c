/// @file
/// @brief How to solve.
#pragma once

#include <optional>

#include "viscoroll/formulation.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief How to solve.
struct Options {
  std::optional<Mesh> mesh;                                ///< none: chosen and refined until `accuracy` is reached
  double accuracy = 0.01;                                  ///< wanted relative error without a mesh [-], in [1e-4, 0.5]
  Compliance compliance = Compliance::radial;              ///< compliance in the contact condition
  Curvature curvature = Curvature::sphere;                 ///< what is kept of it in the equations of the layers
  PatchLoad patch_load = PatchLoad::flat;                  ///< traction on a node's patch
  SlipKinematics slip_kinematics = SlipKinematics::exact;  ///< with friction
  int max_iterations = 2000;                               ///< linear systems on a mesh, >= 1
  int threads = 0;                                         ///< 0 for all cores
  Observer observer;                                       ///< progress and cancellation
};

}  // namespace viscoroll

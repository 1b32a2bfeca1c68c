/// @file
/// @brief Options of the solver.
#pragma once

#include <optional>
#include <tuple>

#include "viscoroll/fields.hpp"
#include "viscoroll/formulation.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief Options of the solver.
struct Options {
  std::optional<Mesh> mesh;                    ///< none: the solver refines a mesh until `accuracy` is reached
  double accuracy = 0.01;                      ///< required relative error if no mesh is given [-], in [1e-4, 0.5]
  Compliance compliance = Compliance::radial;  ///< compliance in the contact condition
  Curvature curvature = Curvature::sphere;     ///< curvature terms in the layer equations of a sphere
  PatchLoad patch_load = PatchLoad::flat;      ///< traction on the patch of a node
  SlipKinematics slip_kinematics = SlipKinematics::exact;  ///< kinematics of slip, with friction
  bool finite_strain = true;                               ///< whether to compute the torque at finite strain
  int max_iterations = 2000;                               ///< largest number of linear systems on a mesh, >= 1
  int threads = 0;                                         ///< number of threads, 0 for all cores
  Observer observer;                                       ///< progress and cancellation

  /// @brief All members but the observer.
  static constexpr auto fields() {
    return std::tuple{Field{"mesh", &Options::mesh, true},
                      Field{"accuracy", &Options::accuracy, true},
                      Field{"compliance", &Options::compliance, true},
                      Field{"curvature", &Options::curvature, true},
                      Field{"patch_load", &Options::patch_load, true},
                      Field{"slip_kinematics", &Options::slip_kinematics, true},
                      Field{"finite_strain", &Options::finite_strain, true},
                      Field{"max_iterations", &Options::max_iterations, true},
                      Field{"threads", &Options::threads, true}};
  }
};

}  // namespace viscoroll

/// @file
/// @brief A load case of two bodies, and its contact problem: load, friction and kinematics at the nodes of a window.
#pragma once

#include <vector>

#include "contact/contact_problem.hpp"
#include "rolling/mesh_model.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/options.hpp"

namespace viscoroll::detail {

/// @brief A checked load case. It refers to its inputs, which must outlive it.
struct RollingCase {
  const PairAtSpeed& pair;
  const LoadCase& load_case;
  const Options& options;
  Execution execution;
  ContactReach contact;    ///< estimated size of the contact; rather too large than too small
  double estimated_depth;  ///< undeformed gap at the edge of the estimated contact [m]
  double equivalent_load;  ///< with adhesion, load without adhesion at which the contact has about the same size [N]
  double shortest_zone = 0.0;  ///< length to which cohesive zones are shortened, unless the mesh is too coarse [m]
};

/// @brief Check a load case against both bodies, and estimate its contact.
/// @param[in] pair both bodies at the speed of the load case
/// @param[in] load_case load, friction and drive, whose values have been checked
/// @param[in] options solver options, whose values have been checked
/// @param[in] watch progress and cancellation
/// @throws InvalidInput for formulations and penetrations that the pair does not support
[[nodiscard]] RollingCase rolling_case(const PairAtSpeed& pair, const LoadCase& load_case, const Options& options,
                                       Watch& watch);

/// @return the case of another pair, load case and options, which must outlive it, with the same estimated contact
[[nodiscard]] inline RollingCase with_same_estimate(const RollingCase& given, const PairAtSpeed& pair,
                                                    const LoadCase& load_case, const Options& options) {
  return {.pair = pair,
          .load_case = load_case,
          .options = options,
          .execution = given.execution,
          .contact = given.contact,
          .estimated_depth = given.estimated_depth,
          .equivalent_load = given.equivalent_load,
          .shortest_zone = given.shortest_zone};
}

/// @brief A load case on a mesh, with the quantities that are known before the contact is solved.
struct ContactSetup : RollingCase {
  const MeshModel& model;
  ContactOptions limits;
  Formulation formulation;
  Nodes nodes;

  /// @return undeformed gap below which nodes are assumed to touch at first: `estimated_depth`, scaled by the
  /// centrifugal growth of the rolling body [m]
  [[nodiscard]] double contact_gap_limit() const { return pair.growth.own * estimated_depth; }
  /// @return 0 with the radial compliance, whose pressure does no work along the plane, else 1
  [[nodiscard]] double pressure_work_factor() const { return options.compliance == Compliance::vertical ? 1.0 : 0.0; }
  /// @return whether one of the two bodies ends at side faces
  [[nodiscard]] bool has_sides() const;

  /// @return points at which displacements are evaluated
  [[nodiscard]] SurfaceWindow displaced_points(const SurfaceWindow& window) const;
  /// @return moment arms of all nodes of the window, with the slope of the counterbody
  [[nodiscard]] MomentArms moment_arms(const SurfaceWindow& window) const;
  /// @return moment arms of some nodes, without the slope of the counterbody
  [[nodiscard]] MomentArms moment_arms(const SurfaceWindow& window, const std::vector<Eigen::Index>& at) const;
  /// @return the contact problem on a window
  [[nodiscard]] ContactProblem problem(const SurfaceWindow& window) const;
};

/// @brief Collect the quantities of a load case that are known before the contact is solved.
/// @param[in] model the bodies of the load case on a mesh
/// @param[in] given load case; the mesh and the accuracy of its options are ignored
[[nodiscard]] ContactSetup assemble(const MeshModel& model, const RollingCase& given);

}  // namespace viscoroll::detail

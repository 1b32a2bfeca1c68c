/// @file
/// @brief The contact problem of a load case: what presses, slides and turns on the nodes of a window.
#pragma once

#include <vector>

#include "contact/contact_problem.hpp"
#include "rolling/mesh_model.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/options.hpp"

namespace viscoroll::detail {

/// @brief A load case on a model, and what follows from both before anything is solved.
struct Assembly {
  const MeshModel& model;
  const LoadCase& load_case;
  const Options& options;
  Execution execution;
  ContactOptions limits;
  Formulation formulation;
  Nodes nodes;
  ContactReach contact;    ///< estimated, rather from above
  double estimated_depth;  ///< initial gap up to which nodes are likely to touch, by the estimated contact [m]

  [[nodiscard]] const RollingPair& pair() const { return model.pair; }
  /// @return `estimated_depth` of the free surface [m]
  [[nodiscard]] double likely_depth() const { return model.swelling.own * estimated_depth; }
  /// @brief With the radial compliance pressure does no work along the plane.
  [[nodiscard]] double pressure_share() const { return options.compliance == Compliance::vertical ? 1.0 : 0.0; }
  /// @return whether one of the two ends beside the path
  [[nodiscard]] bool has_sides() const;
  /// @return whether displacements are those from a place that rests
  [[nodiscard]] bool approach_exists() const;

  /// @return where displacements are taken
  [[nodiscard]] SurfaceWindow displaced_points(const SurfaceWindow& window) const;
  [[nodiscard]] LeverArms lever_arms(const SurfaceWindow& window) const;
  /// @return those of some nodes, without the slope of what is rolled on
  [[nodiscard]] LeverArms lever_arms(const SurfaceWindow& window, const std::vector<Eigen::Index>& at) const;
  [[nodiscard]] ContactProblem problem(const SurfaceWindow& window) const;
};

/// @param[in] model both bodies at the load case's speed, on a mesh
/// @param[in] load_case load, friction and drive
/// @param[in] options how to solve; its mesh and accuracy are not looked at
/// @param[in] watch progress and cancellation
[[nodiscard]] Assembly assemble(const MeshModel& model, const LoadCase& load_case, const Options& options,
                                Watch& watch);

}  // namespace viscoroll::detail

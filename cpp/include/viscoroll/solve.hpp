/// @file
/// @brief Steady rolling contact of two bodies, of which at least one deforms.
#pragma once

#include <memory>

#include "viscoroll/load_case.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll {

/// @brief Solve steady rolling of a body on a rigid plane: sections 11 to 13 of the paper with the solvers of
/// docs/theory/normal-contact.md and docs/theory/friction.md.
/// @param[in] body core and layers
/// @param[in] load_case load, rolling speed, friction and drive
/// @param[in] options options of the solver
/// @return the solution with its status
/// @throws InvalidInput for invalid input, for a load whose penetration would reach the thickness of the layers, for a
/// speed at or above `critical_speed`, and for a drive that friction cannot balance, so that the body slides
/// permanently
/// @throws ConvergenceError if the solver finds no usable state
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] Result solve(const RollingBody& body, const LoadCase& load_case, const Options& options = {});

/// @brief Solve steady rolling of a body on a counterbody that deforms or is curved: a coated plane, a half-space, a
/// groove, or another ball, roller or wheel.
///
/// See docs/theory/rollers.md, docs/theory/planes-and-pairs.md and docs/theory/wheels.md.
/// @param[in] body rolling body; without layers it is rigid, which requires a counterbody that deforms
/// @param[in] on counterbody
/// @param[in] load_case load, rolling speed, friction and drive; both surfaces pass the contact at Omega times the
/// outer radius
/// @param[in] options options of the solver
/// @return the solution with its status
/// @throws InvalidInput for the same reasons as on a rigid plane, and if both bodies are rigid
/// @throws ConvergenceError if the solver finds no usable state
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] Result solve(const RollingBody& body, const Counterbody& on, const LoadCase& load_case,
                           const Options& options = {});

/// @brief Solve again with a frozen contact: the nodes in contact, sticking and slipping stay those of a state.
///
/// No node joins or leaves a set, so that results are smooth functions of the inputs and difference quotients
/// approximate derivatives (docs/theory/sensitivities.md).
/// @param[in] body,on,load_case same as in `solve`, slightly different from the inputs for which the state was solved
/// @param[in] state contact of a result
/// @param[in] options options of the solver, with the mesh of that result
/// @return the solution with its status
/// @throws InvalidInput for invalid input, and for a state of another mesh
/// @throws ConvergenceError if there is no solution near the state
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] Result solve_frozen(const RollingBody& body, const Counterbody& on, const LoadCase& load_case,
                                  const FrozenContact& state, const Options& options);

/// @brief A body at one speed on one mesh, for many load cases. Its spectrum and its influence tables are computed
/// once.
///
/// Several threads may solve with the same model at the same time.
class RollingModel {
 public:
  /// @brief Prepare a body on a rigid plane.
  /// @param[in] body core and layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacing and truncation
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] curvature curvature terms in the layer equations of a sphere
  /// @param[in] observer progress and cancellation
  /// @throws InvalidInput for invalid input, and for a speed at or above `critical_speed`
  /// @throws Canceled if the observer canceled the computation
  RollingModel(const RollingBody& body, double angular_speed, const Mesh& mesh, int threads = 0,
               Curvature curvature = Curvature::sphere, const Observer& observer = {});

  /// @brief Prepare a body on a counterbody that deforms or is curved. The other parameters are those above.
  RollingModel(const RollingBody& body, const Counterbody& on, double angular_speed, const Mesh& mesh, int threads = 0,
               Curvature curvature = Curvature::sphere, const Observer& observer = {});

  /// @brief Prepare a body for load cases that give the speed of the ground. The other parameters are those above.
  RollingModel(const RollingBody& body, const Counterbody& on, const GroundSpeed& speed, const Mesh& mesh,
               int threads = 0, Curvature curvature = Curvature::sphere, const Observer& observer = {});
  ~RollingModel();
  RollingModel(RollingModel&&) noexcept;
  RollingModel& operator=(RollingModel&&) noexcept;
  RollingModel(const RollingModel&) = delete;
  RollingModel& operator=(const RollingModel&) = delete;

  /// @brief Solve a load case on this mesh, as `viscoroll::solve` does.
  /// @param[in] load_case load case at the speed of the model
  /// @param[in] options options of the solver; the mesh may be left out; `accuracy` and `curvature` have no effect
  /// @return the solution with its status
  [[nodiscard]] Result solve(const LoadCase& load_case, const Options& options = {}) const;

 private:
  RollingModel(const RollingBody& body, const Counterbody& on, const LoadCase& speed, const Mesh& mesh, int threads,
               Curvature curvature, const Observer& observer);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace viscoroll

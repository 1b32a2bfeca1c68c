/// @file
/// @brief Steady rolling contact of two bodies, of which one deforms at the least.
#pragma once

#include <memory>

#include "viscoroll/load_case.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll {

/// @brief Solve steady rolling of what rolls on something, a rigid plane unless told otherwise: paper sections 11 to 13
/// with the solvers of docs/theory/normal-contact.md and friction.md.
/// @param[in] body rigid core and layers
/// @param[in] load_case load, rolling speed, friction and drive
/// @param[in] options how to solve
/// @return the solution, with its status
/// @throws std::invalid_argument for bad input, a load too large for the coating (penetration >= thickness),
/// speeds at or above `critical_speed`, and drives with which what rolls slides without end
/// @throws ConvergenceError where no usable state was found
/// @throws Cancelled where the observer stopped the solve
[[nodiscard]] Result solve(const RollingBody& body, const LoadCase& load_case, const Options& options = {});

/// @brief The same on something that deforms or is curved: on a coated plane, a half-space, in a groove or on another
/// ball, roller or wheel (docs/theory/rollers.md, planes-and-pairs.md and wheels.md).
/// @param[in] body what rolls, rigid if it has no layers, unless `on` is a rigid plane
/// @param[in] on what it rolls on; not both may be rigid
/// @param[in] load_case load, rolling speed, friction and drive; both surfaces pass the contact at Omega times the
/// outer radius
/// @param[in] options how to solve
[[nodiscard]] Result solve(const RollingBody& body, const Counterpart& on, const LoadCase& load_case,
                           const Options& options = {});

/// @brief Solve anew with who touches, sticks and slips as it was: nodes neither join nor leave, so that quotients of
/// small differences are derivatives (docs/theory/sensitivities.md).
/// @param[in] body,on,load_case as of `solve`, a little different from what the state was solved for
/// @param[in] state of a result
/// @param[in] options how to solve, on the mesh of that result
/// @throws std::invalid_argument for bad input, and a state that is not of that mesh
/// @throws ConvergenceError where there is no solution near the state
/// @throws Cancelled where the observer stopped the solve
[[nodiscard]] Result solve_kept(const RollingBody& body, const Counterpart& on, const LoadCase& load_case,
                                const KeptContact& state, const Options& options);

/// @brief A body at one speed on one mesh, for many load cases: its spectrum and its influence tables are
/// computed once. Threads may solve on it at the same time.
class RollingModel {
 public:
  /// @param[in] body rigid core and layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacing and truncation
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] curvature what is kept of it in the equations of the layers
  /// @param[in] observer progress and cancellation
  /// @throws std::invalid_argument for bad input, and speeds at or above `critical_speed`
  RollingModel(const RollingBody& body, double angular_speed, const Mesh& mesh, int threads = 0,
               Curvature curvature = Curvature::sphere, const Observer& observer = {});

  /// @brief The same on something that deforms.
  RollingModel(const RollingBody& body, const Counterpart& on, double angular_speed, const Mesh& mesh, int threads = 0,
               Curvature curvature = Curvature::sphere, const Observer& observer = {});
  ~RollingModel();
  RollingModel(RollingModel&&) noexcept;
  RollingModel& operator=(RollingModel&&) noexcept;
  RollingModel(const RollingModel&) = delete;
  RollingModel& operator=(const RollingModel&) = delete;

  /// @brief The same as `viscoroll::solve` on this mesh.
  /// @param[in] load_case at the speed of the model
  /// @param[in] options how to solve; the mesh may be left out; accuracy and curvature are not looked at
  [[nodiscard]] Result solve(const LoadCase& load_case, const Options& options = {}) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace viscoroll

/// @file
/// @brief Transient rolling of a body on a counterbody with prescribed histories of angle and load: start, stop, rest,
/// reversal, change of load.
///
/// The frame is that of result.hpp: the body rolls forward while its angle increases, and without friction the contact
/// moves r_o times the angle along the track. Inertia of the layers is neglected. In line contact, loads, forces,
/// torques and energies are per unit length.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "viscoroll/formulation.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/profile.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll {

/// @brief Load history before the first instant. It affects the first revolution.
enum class Start {
  relaxed,     ///< the load has acted for an infinite time
  undeformed,  ///< the load is applied instantaneously at the first instant
};

/// @brief Mass, spring and damper between the rolling body and a frame, which moves at a constant height. Spring and
/// damper exert no force at the start, where the external force is the load. At least one member is positive. In line
/// contact, all are per unit length.
struct Axle {
  double mass = 0.0;       ///< mass that moves up and down with the axle [kg]
  double stiffness = 0.0;  ///< of the spring [N/m]
  double damping = 0.0;    ///< force of the damper per speed [N s/m]

  static constexpr auto fields() {
    return std::tuple{Field{"mass", &Axle::mass, true}, Field{"stiffness", &Axle::stiffness, true},
                      Field{"damping", &Axle::damping, true}};
  }

  friend bool operator==(const Axle&, const Axle&) = default;
};

/// @brief Check an axle.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const Axle& axle);

/// @brief Options of a transient computation.
struct HistoryOptions {
  /// Surface mesh; none: 16 nodes across the contact at rest, or 48 in line contact.
  std::optional<Mesh> mesh;
  Compliance compliance = Compliance::radial;  ///< compliance in the contact condition
  Curvature curvature = Curvature::sphere;     ///< `sphere` or `paper`
  double friction = 0.0;                       ///< Coulomb's coefficient between the two bodies [-], in [0, 4]
  /// Force on the center, positive forward [N]; |driving_force| < friction * load if the center has no mass.
  double driving_force = 0.0;
  /// Driving moment about the center [N m], in place of `driving_force`; requires friction. At 0 the body is towed.
  std::optional<double> driving_torque = std::nullopt;
  double mass = 0.0;          ///< mass that moves with the center [kg], >= 0; a mass > 0 requires friction
  double center_speed = 0.0;  ///< initial speed of the center, positive forward [m/s]; requires a mass
  /// Height of the ground over the distance r_o psi along the track, the same across the track; none: smooth.
  std::optional<HeightProfile> ground = std::nullopt;
  /// Height of the tread over the circumference: the point that meets the track at the distance r_o psi in the first
  /// revolution; none: smooth.
  std::optional<HeightProfile> tread = std::nullopt;
  std::optional<Axle> axle = std::nullopt;  ///< none: the load acts on the contact itself
  int averaged_meshes = 4;                  ///< number of phase-shifted meshes over which results are averaged, 1 to 16
  /// Number of time steps while the body turns by one mesh spacing, 1 to 64; none: one step from each waypoint to the
  /// next.
  std::optional<int> steps_per_spacing = 4;
  double shortest_time = 1e-4;       ///< shortest time to which continuous spectra are resolved [s], > 0
  double longest_time = 1e4;         ///< longest time to which continuous spectra are resolved [s], > shortest_time
  double spectrum_tolerance = 0.01;  ///< largest allowed `RollingHistory::spectrum_error` [-], in (0, 1)
  int threads = 0;                   ///< number of threads, 0 for all cores

  static constexpr auto fields() {
    return std::tuple{Field{"mesh", &HistoryOptions::mesh, true},
                      Field{"compliance", &HistoryOptions::compliance, true},
                      Field{"curvature", &HistoryOptions::curvature, true},
                      Field{"friction", &HistoryOptions::friction, true},
                      Field{"driving_force", &HistoryOptions::driving_force, true},
                      Field{"driving_torque", &HistoryOptions::driving_torque, true},
                      Field{"mass", &HistoryOptions::mass, true},
                      Field{"center_speed", &HistoryOptions::center_speed, true},
                      Field{"ground", &HistoryOptions::ground, true},
                      Field{"tread", &HistoryOptions::tread, true},
                      Field{"axle", &HistoryOptions::axle, true},
                      Field{"averaged_meshes", &HistoryOptions::averaged_meshes, true},
                      Field{"steps_per_spacing", &HistoryOptions::steps_per_spacing, true},
                      Field{"shortest_time", &HistoryOptions::shortest_time, true},
                      Field{"longest_time", &HistoryOptions::longest_time, true},
                      Field{"spectrum_tolerance", &HistoryOptions::spectrum_tolerance, true},
                      Field{"threads", &HistoryOptions::threads, true}};
  }
};

/// @brief Scalars of a history at an instant, in SI units. The members have the names in `history_scalars.def`. Work
/// and dissipated energies are counted from the first instant.
struct RollingInstant {
#define VISCOROLL_HISTORY_SCALAR(name, unit, label, details) double name = 0.0;  ///< label [unit]. details
#define VISCOROLL_HISTORY_SUMMARY VISCOROLL_HISTORY_SCALAR
#include "viscoroll/history_scalars.def"
#undef VISCOROLL_HISTORY_SUMMARY
#undef VISCOROLL_HISTORY_SCALAR
};

/// @brief Contact pressure on one of the phase-shifted meshes at an instant, row-major [phi][theta].
struct ContactField {
  double time = 0.0;             ///< time of the instant [s]
  int phi_nodes = 0;             ///< number of rows
  int theta_nodes = 0;           ///< number of columns
  std::vector<double> x;         ///< forward coordinate of the undeformed nodes [m]
  std::vector<double> z;         ///< lateral coordinate of the undeformed nodes [m]
  std::vector<double> pressure;  ///< contact pressure [Pa]
};

/// @brief Receives instants as they are computed, on the thread that called the library.
using InstantReceiver = std::function<void(std::span<const RollingInstant>)>;

/// @brief A prescribed motion: waypoints with linear interpolation in time. Two waypoints at one time are a jump.
struct Motion {
  std::vector<double> time;   ///< times of the waypoints [s], at least one, not decreasing
  std::vector<double> angle;  ///< angle psi at each waypoint [rad]
  /// Load P at each waypoint [N], >= 0; at 0 the body has lifted off. With an axle, the external force on the axle.
  std::vector<double> load;
  /// Distance traveled by the center from the first waypoint to each waypoint [m]; requires friction. Empty: the forces
  /// on the center determine it.
  std::vector<double> center_displacement = {};
  /// Height of the axle at each waypoint, in place of the load [m]: r_o minus the penetration. Empty: the load is
  /// given.
  std::vector<double> axle_height = {};

  static constexpr auto fields() {
    return std::tuple{Field{"time", &Motion::time}, Field{"angle", &Motion::angle}, Field{"load", &Motion::load, true},
                      Field{"center_displacement", &Motion::center_displacement, true},
                      Field{"axle_height", &Motion::axle_height, true}};
  }
};

/// @brief Check a motion.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const Motion& motion);

/// @brief Oscillation of the angle about 0, which starts forward.
struct Oscillation {
  double amplitude = 0.0;  ///< largest angle [rad]
  double frequency = 0.0;  ///< frequency [Hz], in [1e-100, 1e100]
  double cycles = 1.0;     ///< number of cycles, in (0, 1e4]

  static constexpr auto fields() {
    return std::tuple{Field{"amplitude", &Oscillation::amplitude}, Field{"frequency", &Oscillation::frequency},
                      Field{"cycles", &Oscillation::cycles, true}};
  }
};

/// @return times and angles of an oscillation, with 160 waypoints in each cycle, without loads
/// @throws InvalidInput naming parameter, value, unit and range
[[nodiscard]] Motion motion_of(const Oscillation& oscillation);

/// @brief Range of times in which a history resolves moduli with a continuous spectrum.
struct TimeRange {
  double shortest = 0.0;  ///< [s]
  double longest = 0.0;   ///< [s]
};

/// @brief Range of times for a motion: from a tenth of the shortest time step while the body rolls, or 1e-4 of the
/// duration if it does not roll, to ten times the duration.
/// @param[in] motion waypoints
/// @param[in] mesh mesh of the history; none: 500 nodes per revolution, because the mesh is chosen later
/// @param[in] steps_per_spacing same as in `HistoryOptions`
[[nodiscard]] TimeRange time_range(const Motion& motion, const std::optional<Mesh>& mesh,
                                   std::optional<int> steps_per_spacing);

/// @brief Complete state of a history, as numbers that can be stored.
struct RollingState {
  std::vector<double> numbers;  ///< in an internal order of the library
};

/// @brief A rolling body whose motion advances step by step.
///
/// Copies advance independently of each other: to try a step and discard it, advance a copy. Copies share the influence
/// tables.
class RollingHistory {
 public:
  /// @brief Start a history on the rigid plane. The parameters are those of the next constructor.
  explicit RollingHistory(const RollingBody& body, double load, Start start = Start::relaxed,
                          const HistoryOptions& options = {}, double time = 0.0, double angle = 0.0,
                          const Observer& observer = {});
  /// @brief Start a history on a counterbody.
  /// @param[in] body rolling body, with layers or rigid
  /// @param[in] on counterbody, with layers or rigid; at least one of the two bodies deforms
  /// @param[in] load load P at the first instant [N], > 0; for rollers per unit length [N/m]
  /// @param[in] start load history before the first instant
  /// @param[in] options options of the computation
  /// @param[in] time,angle time [s] and angle [rad] of the first instant
  /// @param[in] observer progress and cancellation
  /// @param[in] axle_height height of the axle at the first instant, r_o minus the penetration [m]; `load` then only
  /// determines the mesh; none: the load is given
  /// @throws InvalidInput for invalid input, and for layers to which the transient method does not apply
  RollingHistory(const RollingBody& body, const Counterbody& on, double load, Start start = Start::relaxed,
                 const HistoryOptions& options = {}, double time = 0.0, double angle = 0.0,
                 const Observer& observer = {}, std::optional<double> axle_height = std::nullopt);
  /// @brief Continue from a stored state.
  /// @param[in] load first load of the motion, > 0, which determines the mesh if `options` has none [N] or [N/m]
  /// @param[in] state state of a history of the same bodies and options
  /// @param[in] body,on,options,observer,axle_height same as in the constructor above
  /// @throws InvalidInput for invalid input, and for a state of other bodies or of other options
  RollingHistory(const RollingBody& body, const Counterbody& on, double load, const RollingState& state,
                 const HistoryOptions& options = {}, const Observer& observer = {},
                 std::optional<double> axle_height = std::nullopt);
  RollingHistory(const RollingHistory& other);
  RollingHistory(RollingHistory&& other) noexcept;
  RollingHistory& operator=(const RollingHistory& other);
  RollingHistory& operator=(RollingHistory&& other) noexcept;
  ~RollingHistory();

  /// @brief Advance to an instant. Angle and load change linearly in time; the library chooses the time steps.
  ///
  /// After an exception the history is unchanged.
  /// @param[in] time time at the end [s], not before `current()`; equal to it for a jump
  /// @param[in] angle angle at the end [rad]
  /// @param[in] load load at the end [N], >= 0; at 0 the body has lifted off. With an axle, the external force on it
  /// @param[in] center_displacement distance traveled by the center since the first instant [m]; requires friction;
  /// none: the forces on the center determine it
  /// @param[in] observer progress and cancellation
  /// @param[in] axle_height height of the axle at the end [m], which replaces the load; none: the load is given
  /// @return scalars at the end
  /// @throws InvalidInput for invalid input, and for a drive that friction cannot balance
  /// @throws ConvergenceError if the contact iteration does not converge
  /// @throws Canceled if the observer canceled the computation
  RollingInstant advance(double time, double angle, double load,
                         std::optional<double> center_displacement = std::nullopt, const Observer& observer = {},
                         std::optional<double> axle_height = std::nullopt);

  /// @return scalars at the current instant
  [[nodiscard]] const RollingInstant& current() const;
  /// @return contact pressure on the first of the phase-shifted meshes at the current instant
  [[nodiscard]] ContactField contact() const;
  /// @return number of time steps since the first instant
  [[nodiscard]] std::int64_t steps() const;
  /// @return the mesh
  [[nodiscard]] const Mesh& mesh() const;
  /// @return largest relative error of the creep compliance with discrete retardation times [-]
  [[nodiscard]] double spectrum_error() const;

  /// @return state from which a history of the same bodies and options can continue
  [[nodiscard]] RollingState state() const;
  /// @brief Continue from a stored state.
  /// @param[in] state state of a history of the same bodies and options
  /// @param[in] observer progress and cancellation
  /// @throws InvalidInput for a state of other bodies or of other options
  void restore(const RollingState& state, const Observer& observer = {});

 private:
  friend std::vector<RollingInstant> roll(RollingHistory& history, const Motion& motion, const Observer& observer,
                                          const InstantReceiver& receive);
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// @brief Follow a prescribed motion.
/// @param[in,out] history history whose current instant is the first waypoint or a later time within the motion; the
/// computation follows the motion from this instant. After an exception, the history is at the last completed instant.
/// @param[in] motion waypoints
/// @param[in] observer progress and cancellation
/// @param[in] receive called after every few steps with the new instants
/// @return scalars at all instants, beginning with the current one
/// @throws InvalidInput for invalid input, and for a drive that friction cannot balance
/// @throws ConvergenceError if the contact iteration does not converge
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] std::vector<RollingInstant> roll(RollingHistory& history, const Motion& motion,
                                               const Observer& observer = {}, const InstantReceiver& receive = {});

}  // namespace viscoroll

/// @file
/// @brief Transient rolling of a body on a counterpart: start, stop, stand, reverse.
///
/// Frame as in result.hpp: an angle that grows rolls forward, and without friction the contact goes r_o times the angle
/// along the track. Inertia is left out. In line contact loads, forces, torques and energies are per length.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "viscoroll/formulation.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll {

/// @brief What the layers have gone through before the first instant. It decides the first turn.
enum class Start {
  relaxed,  ///< it has borne the load for ever
  fresh,    ///< it is pressed on in no time
};

/// @brief How a history is computed.
struct HistoryOptions {
  std::optional<Mesh> mesh;                    ///< none: 16 nodes across the contact at rest, of a roller 48
  Compliance compliance = Compliance::radial;  ///< compliance in the contact condition
  Curvature curvature = Curvature::sphere;     ///< sphere or paper
  double friction = 0.0;                       ///< Coulomb's coefficient between the two bodies [-], in [0, 4]
  /// Force on the center, forward [N]; below friction * load in magnitude where the center has no mass.
  double driving_force = 0.0;
  /// Moment about the center in place of a force on it, with friction [N m]; 0: towed.
  std::optional<double> driving_torque = std::nullopt;
  double mass = 0.0;          ///< of what moves with the center, with friction [kg], >= 0
  double center_speed = 0.0;  ///< of the center with its mass at the first instant, forward [m/s]
  int lattices = 4;           ///< shifted lattices that are averaged, 1 to 16
  /// Steps while the coating turns by a spacing, 1 to 64; none: one step from each knot to the next.
  std::optional<int> steps_per_spacing = 4;
  double shortest_time = 1e-4;       ///< of what a modulus with a continuous spectrum is resolved for [s], > 0
  double longest_time = 1e4;         ///< likewise [s]
  double spectrum_tolerance = 0.01;  ///< largest relative error of the compliance by discrete times [-], in (0, 1)
  int threads = 0;                   ///< 0 for all cores
};

/// @brief A history at an instant, as the mean over the lattices. Energies are counted from the first instant; those of
/// a half-plane, on which nothing rests, are as arbitrary as its approach while the load changes.
struct RollingInstant {
  double time = 0.0;   ///< [s]
  double angle = 0.0;  ///< psi, turned forward [rad]; r_o times it is the way of the contact along the track
  double load = 0.0;   ///< P [N]
  /// M = sum of x p, whoever deforms: what rolling costs, M / R per way along the track, 1/R the sum of the curvatures
  /// along it [N m]. After a stop it is what keeps the body from rolling back.
  double resisting_torque = 0.0;
  /// T, moment of the contact forces about the center [N m]: on a rigid plane M and what does the work, of a rigid body
  /// on what deforms 0, of two soft ones the share of what rolls.
  double driving_torque = 0.0;
  double penetration = 0.0;  ///< approach of the two bodies, r_o - H [m]; not a number where nothing rests (half-plane)
  double contact_area = 0.0;   ///< [m^2]
  double semi_axis_x = 0.0;    ///< of the ellipse with the contact's second moments, in line contact half its width [m]
  double semi_axis_z = 0.0;    ///< likewise [m]; not a number in line contact
  double max_pressure = 0.0;   ///< [Pa]
  double stored_energy = 0.0;  ///< in both bodies [J]
  double counterpart_stored_energy = 0.0;      ///< part of it in what it rolls on [J]
  double dissipated_energy = 0.0;              ///< lost in both bodies and by slip since the start [J]
  double counterpart_dissipated_energy = 0.0;  ///< part of it lost in what it rolls on, and forgotten there [J]
  double work = 0.0;                           ///< of rolling and load since the start, by the trapezoidal rule [J]
  double energy_imbalance = 0.0;               ///< work - change of stored energy - dissipated_energy [J]
  /// Q, force on the center, forward, less its mass times acceleration [N]: with friction -sum of t_x, and on what
  /// deforms that of the pressure along the deformed surface, of a rigid body M / R.
  double driving_force = 0.0;
  double center_way = 0.0;      ///< of the center along the track since the start [m]; 0 without friction
  double center_speed = 0.0;    ///< its speed [m/s]; without mass the mean over the step before
  double slip_energy = 0.0;     ///< part of dissipated_energy that slip on the plane takes [J]
  double stick_share = 0.0;     ///< of the nodes in contact [-]; 0 without friction
  double error_estimate = 0.0;  ///< of resisting_torque: standard error of the mean over the lattices [N m]
};

/// @brief Fields of the contact of one lattice at an instant, row-major [phi][theta].
struct ContactField {
  double time = 0.0;             ///< [s]
  int phi_nodes = 0;             ///< rows
  int theta_nodes = 0;           ///< columns
  std::vector<double> x;         ///< forward coordinate of the undeformed nodes [m]
  std::vector<double> z;         ///< lateral coordinate [m]
  std::vector<double> pressure;  ///< [Pa]
};

/// @brief A motion between knots, linear in time. Two knots at one time are a jump.
struct Motion {
  std::vector<double> time;   ///< [s], at least one, not decreasing
  std::vector<double> angle;  ///< psi [rad], as many
  std::vector<double> load;   ///< P [N], as many, >= 0; at 0 the body has lifted off
  /// Of the center since the first instant [m], as many, with friction; none: forces move the center.
  std::vector<double> center_way = {};
};

/// @brief Check a motion.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const Motion& motion);

/// @brief Everything that a history remembers, as numbers to be stored.
struct RollingState {
  std::vector<double> numbers;  ///< in an order of the library's own
};

/// @brief A body on its way: state in, state out. Copies are independent of each other and share tables, so
/// that a step can be tried and taken back.
class RollingHistory {
 public:
  /// On the rigid plane.
  explicit RollingHistory(const RollingBody& body, double load, Start start = Start::relaxed,
                          const HistoryOptions& options = {}, double time = 0.0, double angle = 0.0,
                          const Observer& observer = {});
  /// @param[in] body what rolls, with layers or rigid
  /// @param[in] on what it rolls on, likewise: one of the two deforms
  /// @param[in] load P at the first instant [N], of a roller per length, > 0
  /// @param[in] start what was before
  /// @param[in] options how to compute
  /// @param[in] time,angle of the first instant [s], [rad]
  /// @param[in] observer progress and cancellation
  /// @throws std::invalid_argument for bad input, and layers that are not for this method
  RollingHistory(const RollingBody& body, const Counterpart& on, double load, Start start = Start::relaxed,
                 const HistoryOptions& options = {}, double time = 0.0, double angle = 0.0,
                 const Observer& observer = {});
  /// @brief Go on from a state.
  /// @param[in] load the first one of its motion, by which a mesh is chosen where none is given [N] or [N/m], > 0
  /// @param[in] state of a history of the same bodies and options
  /// @param[in] body,on,options,observer as above
  /// @throws std::invalid_argument for bad input, and where the state is of other bodies or of other options
  RollingHistory(const RollingBody& body, const Counterpart& on, double load, const RollingState& state,
                 const HistoryOptions& options = {}, const Observer& observer = {});
  RollingHistory(const RollingHistory& other);
  RollingHistory(RollingHistory&& other) noexcept;
  RollingHistory& operator=(const RollingHistory& other);
  RollingHistory& operator=(RollingHistory&& other) noexcept;
  ~RollingHistory();

  /// @brief Turn and load linearly in time, in steps of the library's choice.
  /// @param[in] time [s], not before now; now for a jump
  /// @param[in] angle [rad]
  /// @param[in] load [N], >= 0; at 0 the body has lifted off
  /// @param[in] center_way of the center since the first instant [m], with friction; none: forces move the center
  /// @param[in] observer progress and cancellation
  /// @return the instant at the end
  /// @throws std::invalid_argument for bad input; the history is then as it was before
  /// @throws ConvergenceError where no usable state was found; likewise
  /// @throws Cancelled where the observer stopped it; likewise
  RollingInstant advance(double time, double angle, double load, std::optional<double> center_way = std::nullopt,
                         const Observer& observer = {});

  /// @return the instant reached
  [[nodiscard]] const RollingInstant& now() const;
  /// @return contact of the first lattice at the instant reached
  [[nodiscard]] ContactField contact() const;
  /// @return steps taken since the first instant
  [[nodiscard]] std::int64_t steps() const;
  /// @return the mesh
  [[nodiscard]] const Mesh& mesh() const;
  /// @return largest relative error of the creep compliance by discrete retardation times [-]
  [[nodiscard]] double spectrum_error() const;

  /// @return what is needed to go on from here, in a history of the same bodies and options
  [[nodiscard]] RollingState state() const;
  /// @brief Go on from a state.
  /// @param[in] state of a history of the same bodies and options
  /// @param[in] observer progress and cancellation
  /// @throws std::invalid_argument where it is of other bodies or of other options
  void restore(const RollingState& state, const Observer& observer = {});

 private:
  friend std::vector<RollingInstant> roll(RollingHistory& history, const Motion& motion, const Observer& observer);
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// @brief Follow a motion.
/// @param[in,out] history at the first knot; where it is later, the motion is followed from there on. After an
/// exception it is at the last instant that was reached
/// @param[in] motion knots
/// @param[in] observer progress and cancellation
/// @return all instants, that of the start first
/// @throws std::invalid_argument for bad input
/// @throws ConvergenceError where no usable state was found
/// @throws Cancelled where the observer stopped it
[[nodiscard]] std::vector<RollingInstant> roll(RollingHistory& history, const Motion& motion,
                                               const Observer& observer = {});

}  // namespace viscoroll

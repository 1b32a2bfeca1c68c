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

/// @brief The scalars of a history at an instant, in SI units, each a member of the name that `history_scalars.def`
/// gives it. Energies are counted from the first instant.
struct RollingInstant {
#define VISCOROLL_HISTORY_SCALAR(name, unit, label, details) double name = 0.0;  ///< label [unit]. details
#define VISCOROLL_HISTORY_SUMMARY VISCOROLL_HISTORY_SCALAR
#include "viscoroll/history_scalars.def"
#undef VISCOROLL_HISTORY_SUMMARY
#undef VISCOROLL_HISTORY_SCALAR
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
  /// @throws std::invalid_argument for bad input, and a drive that friction cannot balance; the history is then as it
  /// was before
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
/// @throws std::invalid_argument for bad input, and a drive that friction cannot balance
/// @throws ConvergenceError where no usable state was found
/// @throws Cancelled where the observer stopped it
[[nodiscard]] std::vector<RollingInstant> roll(RollingHistory& history, const Motion& motion,
                                               const Observer& observer = {});

}  // namespace viscoroll

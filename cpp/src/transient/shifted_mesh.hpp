/// @file
/// @brief One of the phase-shifted meshes of material nodes: docs/theory/transient.md.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "transient/center_motion.hpp"
#include "transient/instant_contact.hpp"
#include "transient/row_memory.hpp"
#include "transient/time_step.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

/// @brief Error for a contact that reaches the sides of the tables.
class ContactTooWide : public std::runtime_error {
 public:
  ContactTooWide() : std::runtime_error("the contact reaches the side of the tables") {}
};

/// @brief Error for a track whose memory extends farther than its tables reach.
class TrackTooLong : public std::runtime_error {
 public:
  TrackTooLong() : std::runtime_error("the memory of the track extends beyond its tables") {}
};

/// @brief Scalars that are averaged over the phase-shifted meshes and stored for each of them.
inline constexpr std::array kShiftedMeshScalars{
#define VISCOROLL_HISTORY_SCALAR(name, unit, label, details) &RollingInstant::name,
#define VISCOROLL_HISTORY_SUMMARY(name, unit, label, details)
#include "viscoroll/history_scalars.def"
#undef VISCOROLL_HISTORY_SUMMARY
#undef VISCOROLL_HISTORY_SCALAR
};

/// @brief One of the phase-shifted meshes: nodes at angles (I + shift) spacing + angle turned, their forces, and the
/// memory of each body.
class ShiftedMesh {
 public:
  using Checkpoint = std::function<void()>;

  /// @param[in] pair data shared by all meshes
  /// @param[in] shift of the nodes at angle 0 [spacings], in [0, 1)
  /// @param[in] half_rows initial number of rows on either side of the lowest one that may touch
  ShiftedMesh(std::shared_ptr<const ViscoelasticPair> pair, double shift, Eigen::Index half_rows);

  /// @brief Solve the first contact, at rest.
  /// @param[in] start undeformed or relaxed
  /// @param[in] at angle and load
  /// @param[in] center_speed initial speed of the center [m/s]
  /// @param[in] checkpoint called every few milliseconds, here and below
  void start(Start start, const StepEnd& at, double center_speed, const Checkpoint& checkpoint);

  /// @brief Advance by a step in which angle and load are linear in time.
  /// @param[in] step weights of the time step
  /// @param[in] end end of the step
  /// @throws ContactTooWide, TrackTooLong, ConvergenceError
  void advance(const PairStep& step, const StepEnd& end, const Checkpoint& checkpoint);

  /// @brief Continue the same history on larger tables.
  void widen(std::shared_ptr<const ViscoelasticPair> pair, const Checkpoint& checkpoint);

  void write(NumberWriter& numbers) const;
  /// @brief Restore the state that a mesh of the same bodies has written.
  void read(NumberReader& numbers, const Checkpoint& checkpoint);

  [[nodiscard]] const RollingInstant& current() const { return now_; }
  [[nodiscard]] ContactField field() const;

 private:
  /// Data of a search for a contact.
  struct Attempt {
    const PairStep* step;  ///< null for a first contact
    const InstantaneousCompliance& instantaneous;
    const StepEnd& end;
    const CenterCondition& center;
    const Checkpoint& checkpoint;
  };
  enum class Sense { back, forward };

  /// @param[in] parts_in returns the compliance factors of a body, given its number
  template <class Parts>
  [[nodiscard]] InstantaneousCompliance instantaneous(const Parts& parts_in, const Checkpoint& checkpoint);
  /// @param[in] step null for a first contact of unloaded bodies
  [[nodiscard]] InstantContact instant(const Attempt& attempt);
  /// @brief Position of a contact, and displacements there that do not depend on the new forces.
  [[nodiscard]] InstantContact before_contact(const PairStep* step, const InstantaneousCompliance& instantaneous,
                                              const StepEnd& end, const Checkpoint& checkpoint) const;
  [[nodiscard]] StickSlip search(const Attempt& attempt, const InstantContact& instant);
  /// Condition for load and penetration at the end of a step, in scaled forces.
  [[nodiscard]] ApproachCondition approach(const Attempt& attempt) const;
  /// @param[in] attempt data of the search, used to explain a failure
  /// @param[in] search called without arguments
  template <class Search>
  auto explaining_failure(const Attempt& attempt, const Search& search);
  void require_supported_load(const Attempt& attempt);
  /// Load of the contact without friction at a given height of the axle.
  [[nodiscard]] double load_without_friction(const Attempt& attempt);
  void require_reachable_drive(const Attempt& attempt);
  [[nodiscard]] RollingInstant slid(const Attempt& attempt, Sense sense);
  void require_reach(const ContactPlace& place) const;
  void require_open_track(const ContactPlace& place) const;
  [[nodiscard]] bool fits(const InstantContact& instant, double load);
  /// Whether the window contains every point that the bodies could touch; if not, widen the window.
  [[nodiscard]] bool reaches_all(const InstantContact& instant, const StepEnd& end);
  void widen_window(Eigen::Index half_rows);
  [[nodiscard]] LastForces last_forces() const { return {.force = force_, .count = count_, .lowest = lowest_}; }
  void take(const InstantContact& instant, const StepEnd& end);
  void take_friction(const InstantContact& instant);
  void take_stored_energy();
  [[nodiscard]] double slip_work(const InstantContact& instant) const;
  void lose(double energy, bool in_rolling_body);
  /// Displacements of every body on the rows of a window.
  [[nodiscard]] std::vector<HalfField> displacements(const ContactPlace& place) const;
  void forget_contact();

  std::shared_ptr<const ViscoelasticPair> pair_;
  double shift_;
  Eigen::Index half_rows_;
  std::vector<RowMemory> memories_;        // of every body
  std::vector<InstantaneousTables> last_;  // of every body, in the last step
  ContactInverse inverse_;                 // without friction
  ContactStiffness stiffness_;             // with friction
  VectorField force_;                      // at the nodes of the last window, row by row
  Eigen::Index first_ = 0;                 // first row of the last window
  Eigen::Index count_ = 0;                 // number of its rows
  double lowest_ = 0.0;                    // position of its middle row relative to the lowest point [spacings]
  CenterPower power_;                      // at the last instant
  double center_acceleration_ = 0.0;       // of a center with mass, in the time integration [m/s^2]
  double ahead_ = 0.0;  // distance by which the center has moved farther than the body has rolled [m]
  AxleState axle_;
  RollingInstant now_;
};

}  // namespace viscoroll::detail

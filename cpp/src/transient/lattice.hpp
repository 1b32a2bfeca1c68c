/// @file
/// @brief One lattice of material nodes that rolls, stands and turns back: docs/theory/transient.md.
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "transient/contact_numbers.hpp"
#include "transient/contact_search.hpp"
#include "transient/row_memory.hpp"
#include "transient/step_end.hpp"
#include "transient/touch.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

/// @brief A contact that does not fit between the sides of the tables.
class ContactTooWide : public std::runtime_error {
 public:
  ContactTooWide() : std::runtime_error("the contact reaches the side of the tables") {}
};

/// @brief A track that remembers more than its tables reach.
class TrackTooLong : public std::runtime_error {
 public:
  TrackTooLong() : std::runtime_error("the track is remembered farther than its tables reach") {}
};

/// @brief Scalars that are averaged over lattices and stored for each of them.
inline constexpr std::array kLatticeScalars{
#define VISCOROLL_HISTORY_SCALAR(name, unit, label, details) &RollingInstant::name,
#define VISCOROLL_HISTORY_SUMMARY(name, unit, label, details)
#include "viscoroll/history_scalars.def"
#undef VISCOROLL_HISTORY_SUMMARY
#undef VISCOROLL_HISTORY_SCALAR
};

/// @brief Nodes at angles (I + shift) spacing + angle turned, what they bear, and what each body remembers of it.
class Lattice {
 public:
  using Checkpoint = std::function<void()>;

  /// @param[in] pair shared by all lattices
  /// @param[in] shift of the nodes at angle 0 [spacings], in [0, 1)
  /// @param[in] half_rows rows on either side of the lowest one that may touch, to begin with
  Lattice(std::shared_ptr<const CreepingPair> pair, double shift, Eigen::Index half_rows);

  /// @brief The first contact, at rest.
  /// @param[in] checkpoint called every few milliseconds, here and below
  void start(Start start, const StepEnd& at, double center_speed, const Checkpoint& checkpoint);

  /// @brief Turn and load linearly in time.
  /// @param[in] step weights of the time that it takes
  /// @param[in] end of the step
  /// @throws ContactTooWide, TrackTooLong, ConvergenceError
  void advance(const PairStep& step, const StepEnd& end, const Checkpoint& checkpoint);

  /// @brief The same history on wider tables.
  void widen(std::shared_ptr<const CreepingPair> pair, const Checkpoint& checkpoint);

  void write(NumberWriter& numbers) const;
  /// @brief Take over what a lattice of the same bodies has written.
  void read(NumberReader& numbers, const Checkpoint& checkpoint);

  [[nodiscard]] const RollingInstant& now() const { return now_; }
  [[nodiscard]] ContactField field() const;

 private:
  /// A contact to be found.
  struct Attempt {
    const PairStep* step;  ///< none for a first contact
    const Yielding& yielding;
    const StepEnd& end;
    const CenterCondition& center;
    const Checkpoint& checkpoint;
  };
  enum class Sense { back, forward };

  /// @param[in] parts_in gives the parts of the forces that have yielded in a body, by its number
  template <class Parts>
  [[nodiscard]] Yielding yielding(const Parts& parts_in, const Checkpoint& checkpoint);
  /// @param[in] step none for a first contact, on bodies that bear nothing else
  [[nodiscard]] Touch touch(const PairStep* step, const Yielding& yielding, const StepEnd& end,
                            const CenterCondition& center, const Checkpoint& checkpoint);
  /// @brief The place of a contact and the displacements there that the new forces do not change.
  [[nodiscard]] Touch before_contact(const PairStep* step, const Yielding& yielding, const StepEnd& end,
                                     const Checkpoint& checkpoint) const;
  [[nodiscard]] StickSlip search(const Touch& touch, const StepEnd& end, const CenterCondition& center);
  /// @param[in] attempt of the search, by which a failure is explained
  /// @param[in] search called without arguments
  template <class Search>
  auto explaining_failure(const Attempt& attempt, const Search& search);
  void require_bearable_load(const Attempt& attempt);
  void require_reachable_drive(const Attempt& attempt);
  [[nodiscard]] RollingInstant slid(const Attempt& attempt, Sense sense);
  void require_reach(const ContactPlace& place) const;
  void require_open_track(const ContactPlace& place) const;
  [[nodiscard]] bool fits(const Touch& touch, double load);
  [[nodiscard]] LastForces last_forces() const { return {.force = force_, .count = count_, .lowest = lowest_}; }
  void take(const Touch& touch, const StepEnd& end);
  void take_friction(const Touch& touch);
  void take_stored_energy();
  [[nodiscard]] double slip_work(const Touch& touch) const;
  void lose(double energy, bool in_what_rolls);
  /// Of every body, on the rows of a window.
  [[nodiscard]] std::vector<HalfField> displacements(const ContactPlace& place) const;
  void forget_contact();

  std::shared_ptr<const CreepingPair> pair_;
  double shift_;
  Eigen::Index half_rows_;
  std::vector<RowMemory> memories_;   // of every body
  std::vector<YieldingTables> last_;  // of every body, in the last step
  ContactInverse inverse_;            // without friction,
  ContactStiffness stiffness_;        // and with it
  VectorField force_;                 // of what is below on the window at the last angle, row by row
  Eigen::Index first_ = 0;            // its first row,
  Eigen::Index count_ = 0;            // and how many there are
  double lowest_ = 0.0;               // place of the window's middle row from the lowest point [spacings]
  CenterPower power_;                 // at the last instant
  double center_acceleration_ = 0.0;  // of the center with its mass, as the integration in time has it [m/s^2]
  RollingInstant now_;
};

}  // namespace viscoroll::detail

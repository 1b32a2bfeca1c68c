/// @file
/// @brief One lattice of material nodes that rolls, stands and turns back: docs/theory.md, transient rolling.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <stdexcept>

#include "transient/coating_history.hpp"
#include "transient/elastic_contact.hpp"
#include "transient/ring_memory.hpp"
#include "transient/stick_slip_step.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

/// @brief A contact that does not fit between the sides of the tables.
class ContactTooWide : public std::runtime_error {
 public:
  ContactTooWide() : std::runtime_error("the contact reaches the side of the tables") {}
};

/// @brief Numbers that each lattice has of an instant: what is averaged over lattices, and stored of each.
inline constexpr std::array kLatticeScalars{&RollingInstant::angle,
                                            &RollingInstant::load,
                                            &RollingInstant::resisting_torque,
                                            &RollingInstant::driving_torque,
                                            &RollingInstant::penetration,
                                            &RollingInstant::contact_area,
                                            &RollingInstant::semi_axis_x,
                                            &RollingInstant::semi_axis_z,
                                            &RollingInstant::max_pressure,
                                            &RollingInstant::stored_energy,
                                            &RollingInstant::dissipated_energy,
                                            &RollingInstant::work,
                                            &RollingInstant::energy_imbalance,
                                            &RollingInstant::driving_force,
                                            &RollingInstant::center_way,
                                            &RollingInstant::slip_energy,
                                            &RollingInstant::stick_share};

/// @brief Nodes of the coating at angles (I + shift) spacing + angle turned, what they bear and what they remember.
class Lattice {
 public:
  /// @param[in] coating shared by all lattices
  /// @param[in] shift of the nodes at angle 0 [spacings], in [0, 1)
  /// @param[in] half_rows rows on either side of the lowest one that may touch, to begin with
  Lattice(std::shared_ptr<const CreepingCoating> coating, double shift, Eigen::Index half_rows);

  /// @brief The first contact.
  void start(Start start, double angle, double load);

  /// @brief Turn and load linearly in time.
  /// @param[in] step weights of the time that it takes
  /// @param[in] jump whether it takes none
  /// @param[in] angle,load at its end
  /// @throws ContactTooWide, ConvergenceError
  void advance(const TimeStep& step, bool jump, double angle, double load);

  /// @brief The same history on wider tables.
  void widen(std::shared_ptr<const CreepingCoating> coating);

  void write(NumberWriter& numbers) const;
  /// @brief Take over what a lattice of the same coating has written.
  void read(NumberReader& numbers);

  [[nodiscard]] const RollingInstant& now() const { return now_; }
  [[nodiscard]] ContactField field() const;

 private:
  /// Where the rows around the lowest point are.
  struct Place {
    RingRows rows;
    SurfaceWindow nodes;
    Axes axes;  ///< empty where pressure is radial and there is no friction
  };

  /// Who touches at an angle, in scaled forces.
  struct Touch {
    Place place;
    HalfField known;  ///< K h
    double compliance;
    StickSlip contact;  ///< without friction only with what presses
  };

  [[nodiscard]] Place place_at(double angle) const;
  [[nodiscard]] Axes axes_at(const SurfaceWindow& nodes) const;
  /// @param[in] step none for a first contact, on a coating that bears nothing else
  [[nodiscard]] Touch touch(const TimeStep* step, double compliance, double angle, double load, double driving_force);
  [[nodiscard]] StickSlip touch_smooth(const Place& place, const HalfField& known, double load);
  [[nodiscard]] StickSlip touch_with_friction(const Place& place, const HalfField& known, double compliance,
                                              double angle, double load, double driving_force) const;
  [[nodiscard]] HalfField guess(const HalfField& last, const Place& place) const;
  [[nodiscard]] RingMemory::Load load_of(const Touch& touch) const;
  void take(const Touch& touch, double angle, double load);
  void take_contact(const Touch& touch);
  void take_friction(const Touch& touch);
  [[nodiscard]] double slip_work(const Touch& touch) const;
  [[nodiscard]] bool has_friction() const { return coating_->friction > 0.0; }

  std::shared_ptr<const CreepingCoating> coating_;
  double shift_;
  Eigen::Index half_rows_;
  RingMemory memory_;
  ContactInverse inverse_;
  PlaneForces forces_;   // of the window at the last angle
  RingRows rows_;        // which it is of
  double lowest_ = 0.0;  // place of the window's middle row from the lowest point [spacings]
  RollingInstant now_;
};

}  // namespace viscoroll::detail

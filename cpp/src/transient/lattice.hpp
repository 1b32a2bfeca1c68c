/// @file
/// @brief One lattice of material nodes that rolls, stands and turns back: docs/theory.md section 13.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <stdexcept>

#include "transient/coating_history.hpp"
#include "transient/contact_stiffness.hpp"
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
                                            &RollingInstant::center_speed,
                                            &RollingInstant::slip_energy,
                                            &RollingInstant::stick_share};

/// @brief Where a step ends, in which angle, load and a given way of the center change linearly.
struct StepEnd {
  double time;                       ///< [s]
  double angle;                      ///< [rad]
  double load;                       ///< [N]
  std::optional<double> center_way;  ///< since the first instant [m]; none: forces decide
};

/// @brief Nodes of the coating at angles (I + shift) spacing + angle turned, what they bear and what they remember.
class Lattice {
 public:
  /// @param[in] coating shared by all lattices
  /// @param[in] shift of the nodes at angle 0 [spacings], in [0, 1)
  /// @param[in] half_rows rows on either side of the lowest one that may touch, to begin with
  Lattice(std::shared_ptr<const CreepingCoating> coating, double shift, Eigen::Index half_rows);

  /// @brief The first contact, at rest.
  void start(Start start, const StepEnd& at, double center_speed);

  /// @brief Turn and load linearly in time.
  /// @param[in] step weights of the time that it takes
  /// @param[in] duration that time [s], 0 for a jump
  /// @param[in] end of the step
  /// @throws ContactTooWide, ConvergenceError
  void advance(const TimeStep& step, double duration, const StepEnd& end);

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
  [[nodiscard]] Touch touch(const TimeStep* step, double compliance, const StepEnd& end, const CenterCondition& center);
  [[nodiscard]] StickSlip touch_smooth(const Place& place, const HalfField& known, double load);
  [[nodiscard]] StickSlip touch_with_friction(const Place& place, const HalfField& known, double compliance,
                                              const StepEnd& end, const CenterCondition& center);
  [[nodiscard]] StickSlip lifted(const Place& place, const HalfField& known, const CenterCondition& center) const;
  [[nodiscard]] CenterCondition center_condition(double duration, const StepEnd& end) const;
  void move_center(double duration, double way);
  [[nodiscard]] VectorField carried_forces(const Place& place) const;
  [[nodiscard]] VectorField guess(const Place& place, double load) const;
  [[nodiscard]] HalfField by_components(const VectorField& force, const Place& place) const;
  [[nodiscard]] RingMemory::Load load_of(const Touch& touch) const;
  void take(const Touch& touch, const StepEnd& end);
  void take_contact(const Touch& touch);
  void take_moments(const Touch& touch);
  void take_friction(const Touch& touch);
  [[nodiscard]] double slip_work(const Touch& touch) const;
  void forget_contact();
  [[nodiscard]] bool has_friction() const { return coating_->friction > 0.0; }

  std::shared_ptr<const CreepingCoating> coating_;
  double shift_;
  Eigen::Index half_rows_;
  RingMemory memory_;
  ContactInverse inverse_;            // without friction,
  ContactStiffness stiffness_;        // and with it
  VectorField force_;                 // of the plane on the window at the last angle, row by row
  RingRows rows_;                     // which it is of
  double lowest_ = 0.0;               // place of the window's middle row from the lowest point [spacings]
  double center_acceleration_ = 0.0;  // of the center with its mass, as the integration in time has it [m/s^2]
  RollingInstant now_;
};

}  // namespace viscoroll::detail

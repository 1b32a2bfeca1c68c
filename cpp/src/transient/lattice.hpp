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
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

/// @brief A contact that does not fit between the sides of the tables.
class ContactTooWide : public std::runtime_error {
 public:
  ContactTooWide() : std::runtime_error("the contact reaches the side of the tables") {}
};

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
    std::array<HalfField, 3> down;     // components of the direction y; the first one alone where pressure is radial
    std::array<HalfField, 3> forward;  // of the direction x
  };

  [[nodiscard]] Place place_at(double angle) const;
  [[nodiscard]] ElasticContact touch(const Place& place, const HalfField& known, double load);
  [[nodiscard]] ElasticContact touch_in_window(const TimeStep* step, double compliance, double angle, double load,
                                               Place& place);
  [[nodiscard]] HalfField guess(const Place& place, double load) const;
  [[nodiscard]] RingMemory::Load load_of(const Place& place, const ElasticContact& contact, double compliance) const;
  void take(const Place& place, const ElasticContact& contact, const HalfField& known, double compliance, double angle,
            double load);
  [[nodiscard]] HalfField along(const std::array<HalfField, 3>& direction, const HalfField& field) const;
  [[nodiscard]] HalfField spread(const std::array<HalfField, 3>& direction, const HalfField& scalar) const;

  std::shared_ptr<const CreepingCoating> coating_;
  double shift_;
  Eigen::Index half_rows_;
  RingMemory memory_;
  ContactInverse inverse_;
  HalfField pressing_;   // of the window at the last angle, per unit load
  double lowest_ = 0.0;  // place of the window's middle row from the lowest point [spacings]
  RollingInstant now_;
};

}  // namespace viscoroll::detail

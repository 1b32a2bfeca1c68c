/// @file
/// @brief What every material node remembers of the forces it has borne, and what that displaces.
#pragma once

#include <vector>

#include "transient/mirrored_tables.hpp"
#include "transient/numbers.hpp"
#include "transient/time_step.hpp"

namespace viscoroll::detail {

/// @brief Consecutive rows of a ring.
struct RingRows {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};

/// @brief Memory of a ring of nodes. With each retarded force a_j its displacement K a_j is kept, which follows the
/// same equation: a step needs one product, K F, and energies are sums.
class RingMemory {
 public:
  /// @param[in] tables of the coating, whose ring and reach it has
  /// @param[in] spectrum of the coating
  RingMemory(const MirroredTables& tables, const CreepSpectrum& spectrum);

  /// @brief Forces and their displacements, on rows of the ring.
  struct Load {
    RingRows rows;
    HalfField force;
    HalfField displacement;
  };

  /// @brief The coating has borne a load for ever.
  void relax(const Load& load);
  /// @brief A load has come in no time.
  void press(const Load& load);
  /// @brief A step of time, in which forces change linearly to a new load.
  /// @return energy that the coating lost in it [J]
  double advance(const TimeStep& step, const Load& load);

  /// @return K h on some rows: the displacement at the end of a step that does not come from its new forces
  [[nodiscard]] HalfField known_displacement(const TimeStep& step, const RingRows& rows) const;

  /// @return K v on some rows: all of the displacement of now
  [[nodiscard]] HalfField displacement(const RingRows& rows) const;

  /// @return F.K F J_0 / 2 + sum J_j a_j.K a_j / 2 [J]
  [[nodiscard]] double stored_energy() const { return stored_; }

  void write(NumberWriter& numbers) const;
  /// @brief Take over what another memory of the same shape has written.
  void read(NumberReader& numbers, const MirroredTables& tables);

  /// @return the same memory on tables with more nodes aside
  [[nodiscard]] RingMemory widened(const MirroredTables& tables) const;

 private:
  struct Retarded {
    HalfField force;
    HalfField displacement;
  };

  [[nodiscard]] Eigen::Index ring() const { return now_.force.cols(); }
  void set(const Load& load, Retarded& field) const;
  /// @return forces around the ring with their displacements
  [[nodiscard]] Retarded displaced(const HalfField& force, const MirroredTables& tables) const;
  void find_stored_energy();

  double instantaneous_;
  std::vector<double> weights_;
  Retarded now_;                    // F and K F, over the ring
  std::vector<Retarded> retarded_;  // of every retardation time
  double stored_ = 0.0;
};

}  // namespace viscoroll::detail

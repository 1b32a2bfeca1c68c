/// @file
/// @brief Memory of rows of material nodes, around a rotating body or along a track at rest: past forces and their
/// displacements.
#pragma once

#include <optional>
#include <vector>

#include "transient/numbers.hpp"
#include "transient/time_step.hpp"
#include "transient/viscoelastic_body.hpp"

namespace viscoroll::detail {

/// @brief Memory of a body's nodes, which stay in their rows. With each retarded force a_j its displacement K_j a_j is
/// stored, which follows the same equation. A step therefore needs one product K_j F for each of the body's tables, and
/// energies are sums.
///
/// Rows have numbers of either sign. Around a ring, rows a whole number of turns apart are the same row. Along a track,
/// a row is alive until all but a millionth of its retarded displacement has recovered; rows beyond the reach of living
/// rows are dropped. Rows are dropped by the time since their last load, not by distance, because the body may come
/// back to them.
class RowMemory {
 public:
  /// @param[in] body provides tables, spectrum and ring
  explicit RowMemory(const ViscoelasticBody& body);

  /// @brief Forces and their displacements by each of the body's tables, on consecutive rows.
  struct Load {
    Eigen::Index first;
    HalfField force;
    std::vector<HalfField> displacements;
  };

  /// @brief Set the state after a load has acted for an infinite time.
  void relax(const Load& load);
  /// @brief Apply a load instantaneously.
  void press(const Load& load);
  /// @brief Advance by a time step, in which forces change linearly to a new load.
  /// @param[in] step weights of the step
  /// @param[in] duration of the step [s]
  /// @param[in] load at the end of the step
  /// @return energy that the body dissipates in the step, including the energy of dropped rows [J]
  double advance(const TimeStep& step, double duration, const Load& load);

  /// @return sum J_j K_j h_j on some rows: displacement at the end of a step that does not depend on the new forces
  [[nodiscard]] HalfField known_displacement(const TimeStep& step, Eigen::Index first, Eigen::Index count) const;

  /// @return K_0 F + sum J_j K_j a_j on some rows: the present displacement
  [[nodiscard]] HalfField displacement(Eigen::Index first, Eigen::Index count) const;

  /// @return J_0 F.K_0 F / 2 + sum J_j a_j.K_j a_j / 2 [J]
  [[nodiscard]] double stored_energy() const { return stored_; }
  /// @return number of stored rows
  [[nodiscard]] Eigen::Index rows() const { return now_.force.cols(); }

  /// @brief Range of rows from the first to the last.
  struct Span {
    Eigen::Index first;
    Eigen::Index last;
  };
  /// @return living rows of a track; none for a ring, or if no row is alive
  [[nodiscard]] std::optional<Span> living() const;

  /// @return whether a row is stored
  [[nodiscard]] bool keeps(Eigen::Index row) const { return column(row).has_value(); }

  void write(NumberWriter& numbers) const;
  /// @brief Restore the state that another memory of the same shape has written.
  void read(NumberReader& numbers, const CreepTables& tables);

  /// @brief Transfer the memory to wider tables.
  /// @param[in] tables tables with more nodes across
  /// @param[in] checkpoint called every few milliseconds
  [[nodiscard]] RowMemory widened(const CreepTables& tables, const std::function<void()>& checkpoint) const;

 private:
  struct LoadedDisplacements {
    HalfField force;
    std::vector<HalfField> displacements;  // by each of the tables
  };
  struct Retarded {
    HalfField force;
    HalfField displacement;
  };

  /// @return number of the table of a retardation time
  [[nodiscard]] std::size_t table_of(std::size_t term) const { return now_.displacements.size() == 1 ? 0 : term + 1; }

  /// @return column of a row; none if the row is not stored
  [[nodiscard]] std::optional<Eigen::Index> column(Eigen::Index row) const;
  /// Store some rows of a track as well.
  void cover(Eigen::Index first, Eigen::Index count);
  /// Keep only these columns; new columns have no memory.
  void keep(Eigen::Index first, Eigen::Index count);
  /// Advance the times since the rows of a track were loaded.
  void age(double duration, const Load& load);
  /// Drop the rows of a track that have recovered and that no living row displaces.
  /// @return energy that was stored in them [J]
  double forget(const Load& load);
  [[nodiscard]] double stored_in(Eigen::Index column) const;
  /// @return field on the rows of a load, extended to all rows
  [[nodiscard]] HalfField spread(Eigen::Index first, const HalfField& field) const;
  [[nodiscard]] LoadedDisplacements spread(const Load& load) const;
  /// @return displacement of all rows under forces on all rows
  [[nodiscard]] HalfField displaced(const HalfField& force, const MirroredTables& tables,
                                    const std::function<void()>& checkpoint) const;
  /// Compute all displacements from the forces.
  void displace(const CreepTables& tables, const std::function<void()>& checkpoint);
  void find_stored_energy();

  std::optional<Eigen::Index> ring_;
  double instantaneous_;
  std::vector<double> weights_;
  double fading_;                   // time in which all but a millionth of the retarded displacement recovers [s]
  Eigen::Index reach_;              // reach of the tables [rows]
  Eigen::Index first_ = 0;          // row of the first column
  LoadedDisplacements now_;         // F and K_j F
  std::vector<Retarded> retarded_;  // for every retardation time
  Eigen::ArrayXd idle_;             // time since each row of a track was loaded [s]
  double stored_ = 0.0;
};

}  // namespace viscoroll::detail

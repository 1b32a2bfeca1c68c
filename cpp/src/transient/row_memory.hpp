/// @file
/// @brief What rows of material nodes remember of the forces they have borne, and what that displaces: around a body
/// that turns, or along a track that rests.
#pragma once

#include <optional>
#include <vector>

#include "transient/creeping_body.hpp"
#include "transient/numbers.hpp"
#include "transient/time_step.hpp"

namespace viscoroll::detail {

/// @brief Memory of a body's nodes, which never move through the rows. With each retarded force a_j its displacement
/// K_j a_j is kept, which follows the same equation: a step needs one product for each of the body's tables, K_j F, and
/// energies are sums.
///
/// Rows have numbers of either sign. Around a ring those that lie whole turns apart are one row. Along a track a row
/// lives until all but a millionth of what is retarded has crept back there; what is out of the reach of living rows is
/// forgotten. So rows go by the time since they bore a load, never by their distance: what rolls may come back to them.
class RowMemory {
 public:
  /// @param[in] body whose tables, spectrum and ring it has
  explicit RowMemory(const CreepingBody& body);

  /// @brief Forces and their displacements by each of the body's tables, on consecutive rows.
  struct Load {
    Eigen::Index first;
    HalfField force;
    std::vector<HalfField> displacements;
  };

  /// @brief The body has borne a load for ever.
  void relax(const Load& load);
  /// @brief A load has come in no time.
  void press(const Load& load);
  /// @brief A step of time, in which forces change linearly to a new load.
  /// @param[in] step its weights
  /// @param[in] duration that it takes [s]
  /// @param[in] load at its end
  /// @return energy that the body lost in it, what was forgotten among it [J]
  double advance(const TimeStep& step, double duration, const Load& load);

  /// @return sum J_j K_j h_j on some rows: the displacement at the end of a step that does not come from its new forces
  [[nodiscard]] HalfField known_displacement(const TimeStep& step, Eigen::Index first, Eigen::Index count) const;

  /// @return K_0 F + sum J_j K_j a_j on some rows: all of the displacement of now
  [[nodiscard]] HalfField displacement(Eigen::Index first, Eigen::Index count) const;

  /// @return J_0 F.K_0 F / 2 + sum J_j a_j.K_j a_j / 2 [J]
  [[nodiscard]] double stored_energy() const { return stored_; }
  /// @return rows that are kept
  [[nodiscard]] Eigen::Index rows() const { return now_.force.cols(); }

  /// @brief Rows from the first to the last.
  struct Span {
    Eigen::Index first;
    Eigen::Index last;
  };
  /// @return those of a track that live; none around a ring, and where no row does
  [[nodiscard]] std::optional<Span> living() const;

  /// @return whether anything is kept of a row
  [[nodiscard]] bool keeps(Eigen::Index row) const { return column(row).has_value(); }

  void write(NumberWriter& numbers) const;
  /// @brief Take over what another memory of the same shape has written.
  void read(NumberReader& numbers, const CreepingTables& tables);

  /// @param[in] tables with more nodes aside
  /// @param[in] checkpoint called every few milliseconds
  /// @return the same memory on these
  [[nodiscard]] RowMemory widened(const CreepingTables& tables, const std::function<void()>& checkpoint) const;

 private:
  struct Borne {
    HalfField force;
    std::vector<HalfField> displacements;  // by each of the tables
  };
  struct Retarded {
    HalfField force;
    HalfField displacement;
  };

  /// @return number of the tables of a retardation time
  [[nodiscard]] std::size_t table_of(std::size_t term) const { return now_.displacements.size() == 1 ? 0 : term + 1; }

  /// @return the column of a row; none where nothing is kept of it
  [[nodiscard]] std::optional<Eigen::Index> column(Eigen::Index row) const;
  /// Have some rows of a track among those that are kept.
  void cover(Eigen::Index first, Eigen::Index count);
  /// Keep these columns alone; those that are new remember nothing.
  void keep(Eigen::Index first, Eigen::Index count);
  /// How long ago the rows of a track bore their last load.
  void age(double duration, const Load& load);
  /// Leave out the rows of a track that nothing is left of, and that no living row displaces.
  /// @return energy that they had stored [J]
  double forget(const Load& load);
  [[nodiscard]] double stored_in(Eigen::Index column) const;
  /// @return a field of a load's rows on all rows
  [[nodiscard]] HalfField spread(Eigen::Index first, const HalfField& field) const;
  [[nodiscard]] Borne spread(const Load& load) const;
  /// @return displacement of all rows by forces on all rows
  [[nodiscard]] HalfField displaced(const HalfField& force, const MirroredTables& tables,
                                    const std::function<void()>& checkpoint) const;
  /// Find all displacements from the forces.
  void displace(const CreepingTables& tables, const std::function<void()>& checkpoint);
  void find_stored_energy();

  std::optional<Eigen::Index> ring_;
  double instantaneous_;
  std::vector<double> weights_;
  double fading_;                   // time in which all but a millionth of what is retarded has crept back [s]
  Eigen::Index reach_;              // of the tables [rows]
  Eigen::Index first_ = 0;          // row of the first column
  Borne now_;                       // F and K_j F
  std::vector<Retarded> retarded_;  // of every retardation time
  Eigen::ArrayXd idle_;             // time since each row of a track bore a load [s]
  double stored_ = 0.0;
};

}  // namespace viscoroll::detail

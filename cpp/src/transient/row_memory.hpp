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
/// K a_j is kept, which follows the same equation: a step needs one product, K F, and energies are sums.
///
/// Rows have numbers of either sign. Around a ring those that lie whole turns apart are one row. Along a track a row
/// lives until all but a millionth of what is retarded has crept back there; what is out of the reach of living rows is
/// forgotten. So rows go by the time since they bore a load, never by their distance: what rolls may come back to them.
class RowMemory {
 public:
  /// @param[in] body whose tables, spectrum and ring it has
  explicit RowMemory(const CreepingBody& body);

  /// @brief Forces and their displacements, on consecutive rows.
  struct Load {
    Eigen::Index first;
    HalfField force;
    HalfField displacement;
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

  /// @return K h on some rows: the displacement at the end of a step that does not come from its new forces
  [[nodiscard]] HalfField known_displacement(const TimeStep& step, Eigen::Index first, Eigen::Index count) const;

  /// @return K v on some rows: all of the displacement of now
  [[nodiscard]] HalfField displacement(Eigen::Index first, Eigen::Index count) const;

  /// @return F.K F J_0 / 2 + sum J_j a_j.K a_j / 2 [J]
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

  void write(NumberWriter& numbers) const;
  /// @brief Take over what another memory of the same shape has written.
  void read(NumberReader& numbers, const MirroredTables& tables);

  /// @return the same memory on tables with more nodes aside
  [[nodiscard]] RowMemory widened(const MirroredTables& tables) const;

 private:
  struct Retarded {
    HalfField force;
    HalfField displacement;
  };

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
  void set(const Load& load, Retarded& field) const;
  /// @return forces on all rows with their displacements
  [[nodiscard]] Retarded displaced(const HalfField& force, const MirroredTables& tables) const;
  void find_stored_energy();

  std::optional<Eigen::Index> ring_;
  double instantaneous_;
  std::vector<double> weights_;
  double fading_;                   // time in which all but a millionth of what is retarded has crept back [s]
  Eigen::Index reach_;              // of the tables [rows]
  Eigen::Index first_ = 0;          // row of the first column
  Retarded now_;                    // F and K F
  std::vector<Retarded> retarded_;  // of every retardation time
  Eigen::ArrayXd idle_;             // time since each row of a track bore a load [s]
  double stored_ = 0.0;
};

}  // namespace viscoroll::detail

/// @file
/// @brief A viscoelastic body in transient rolling: elastic surfaces on rows of nodes, whose displacements under
/// retarded forces add up to those of the body.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "creep/layer_spectrum.hpp"
#include "creep/mirrored_tables.hpp"
#include "materials/creep_spectrum.hpp"
#include "rolling/body.hpp"
#include "transient/time_step.hpp"

namespace viscoroll::detail {

/// @brief Tables of the displacement of a body under scaled forces.
struct InstantaneousTables {
  std::vector<double> parts;  ///< compliance factor of each of the body's tables
  double share;               ///< factor on `tables`
  std::shared_ptr<const MirroredTables> tables;
};

/// @brief Tables of a body: one table, to which all creep weights apply, if its layers share one relaxation function;
/// else one table for the instantaneous compliance and one for each retardation time.
class CreepTables {
 public:
  /// @param[in] tables tables of equal shape and reach
  explicit CreepTables(std::vector<MirroredTables> tables)
      : tables_(std::make_shared<const std::vector<MirroredTables>>(std::move(tables))) {}

  [[nodiscard]] const std::vector<MirroredTables>& all() const { return *tables_; }
  [[nodiscard]] std::size_t count() const { return tables_->size(); }
  /// @return number of the table that belongs to a retardation time
  [[nodiscard]] std::size_t of_term(std::size_t term) const { return count() == 1 ? 0 : term + 1; }

  [[nodiscard]] Eigen::Index components() const { return tables_->front().components(); }
  [[nodiscard]] Eigen::Index half_nodes() const { return tables_->front().half_nodes(); }
  [[nodiscard]] Eigen::Index height() const { return tables_->front().height(); }
  [[nodiscard]] Eigen::Index reach() const { return tables_->front().reach(); }
  [[nodiscard]] bool dies_out() const { return tables_->front().dies_out(); }
  /// @return relaxed displacement of a node in the middle under a unit force along r [m/N]
  [[nodiscard]] double diagonal_compliance() const;

  /// @brief Combine the tables with a compliance factor for each.
  /// @param[in] parts compliance factor of each table
  /// @param[in] checkpoint called every few milliseconds
  [[nodiscard]] InstantaneousTables instantaneous(std::vector<double> parts,
                                                  const std::function<void()>& checkpoint) const;

 private:
  std::shared_ptr<const std::vector<MirroredTables>> tables_;
};

/// @brief Influence tables of elastic layers with relaxed moduli or, for layers with different relaxation functions, of
/// each of their retardation times, including the effect of free side faces.
/// @param[in] at_rest body with relaxed moduli, without inertia; not rigid
/// @param[in] dissimilar_layers its layers if they have different relaxation functions, else null
/// @param[in] kinematics motion of the material at any speed
/// @param[in] shape of the rows
[[nodiscard]] CreepTables tables_of(const Body& at_rest, const LayerSpectrum* dissimilar_layers,
                                    const ContactKinematics& kinematics, const RowShape& shape);

/// @brief Body whose displacements are those of elastic bodies under retarded forces: of one elastic body if its layers
/// share one relaxation function, else of one for each retardation time.
struct ViscoelasticBody {
  bool rolls;                        ///< whether it is the rolling body, else the counterbody
  CreepSpectrum spectrum;            ///< relative to the tables; all weights are 1 if every time has its own table
  std::optional<Eigen::Index> ring;  ///< number of rows around the body; none for a track
  CreepTables tables;

  /// @return compliance factor of each table for a force that has just been applied
  [[nodiscard]] std::vector<double> instantaneous_factors() const;
  /// @return compliance factor of each table for a force that has acted for an infinite time
  [[nodiscard]] std::vector<double> relaxed_factors() const;
  /// @return compliance factor of each table for the change of a force in a step, at the end of the step
  [[nodiscard]] std::vector<double> step_factors(const TimeStep& step) const;
};

/// @brief Whether all orders of the layers creep in the same way: the layers share one relaxation function, and no
/// viscoelastic layer has a bulk modulus.
/// @param[in] layers at least one
/// @param[in] range times at which they are compared
[[nodiscard]] bool creep_identically(const std::vector<NamedLayer>& layers, const TimeRange& range);

/// @return the rolling body with relaxed moduli, without inertia
[[nodiscard]] RollingBody with_relaxed_moduli(const RollingBody& body);
/// @return the counterbody with relaxed moduli, without inertia
[[nodiscard]] Counterbody with_relaxed_moduli(const Counterbody& on);

}  // namespace viscoroll::detail

/// @file
/// @brief Elastic surfaces whose displacements under retarded forces add up to those of a viscoelastic body.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "transient/mirrored_tables.hpp"
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

}  // namespace viscoroll::detail

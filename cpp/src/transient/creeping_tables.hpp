/// @file
/// @brief The elastic surfaces whose displacements, by forces that lag, add up to those of a body that creeps.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "transient/mirrored_tables.hpp"
#include "transient/time_step.hpp"

namespace viscoroll::detail {

/// @brief What forces displace once parts of them have yielded.
struct YieldingTables {
  std::vector<double> parts;  ///< of the forces, for each of the body's tables
  double share;               ///< times these tables
  std::shared_ptr<const MirroredTables> tables;
};

/// @brief Tables of a body: one, of which every term of its creep takes its weight, where its layers share a relaxation
/// function; else one for what yields at once and one for each retardation time.
class CreepingTables {
 public:
  /// @param[in] tables of one shape and reach
  explicit CreepingTables(std::vector<MirroredTables> tables)
      : tables_(std::make_shared<const std::vector<MirroredTables>>(std::move(tables))) {}

  [[nodiscard]] const std::vector<MirroredTables>& all() const { return *tables_; }
  [[nodiscard]] std::size_t count() const { return tables_->size(); }
  /// @return number of the tables that a retardation time's forces displace by
  [[nodiscard]] std::size_t of_term(std::size_t term) const { return count() == 1 ? 0 : term + 1; }

  [[nodiscard]] Eigen::Index components() const { return tables_->front().components(); }
  [[nodiscard]] Eigen::Index half_nodes() const { return tables_->front().half_nodes(); }
  [[nodiscard]] Eigen::Index height() const { return tables_->front().height(); }
  [[nodiscard]] Eigen::Index reach() const { return tables_->front().reach(); }
  [[nodiscard]] bool dies_out() const { return tables_->front().dies_out(); }
  /// @return displacement of a node in the middle by a unit force that has been there for ever, along r [m/N]
  [[nodiscard]] double own_compliance() const;

  /// @param[in] parts of the forces that have yielded, one for each of the tables
  /// @param[in] checkpoint called every few milliseconds
  [[nodiscard]] YieldingTables yielding(std::vector<double> parts, const std::function<void()>& checkpoint) const;

 private:
  std::shared_ptr<const std::vector<MirroredTables>> tables_;
};

}  // namespace viscoroll::detail

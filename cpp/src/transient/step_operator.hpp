/// @file
/// @brief What forces at the end of a step displace: a sum of elastic surfaces, each by the share that has crept.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "transient/mirrored_tables.hpp"

namespace viscoroll::detail {

/// @brief sum of share_i K_i over tables of the same rows; those of more than one are of one component.
class StepOperator {
 public:
  struct Part {
    double share;
    const MirroredTables* tables;  ///< outlives the sum
  };

  /// @param[in] parts at least one
  explicit StepOperator(std::vector<Part> parts) : parts_(std::move(parts)) {}

  [[nodiscard]] Eigen::Index components() const { return parts_.front().tables->components(); }
  [[nodiscard]] double own_compliance() const;

  /// @brief As `MirroredTables::compliance`.
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& nodes,
                                           const std::array<HalfField, 3>& direction) const;

  /// @brief As `MirroredTables::displacement`.
  [[nodiscard]] HalfField displacement(const HalfField& loads, Eigen::Index first, Eigen::Index last) const;

 private:
  std::vector<Part> parts_;
};

}  // namespace viscoroll::detail

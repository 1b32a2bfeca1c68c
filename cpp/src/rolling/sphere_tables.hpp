/// @file
/// @brief Influence tables of the exact sphere, kept for the load cases of a model.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "influence/sphere_sum.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Threads may share it: tables are summed under a lock, and never change.
class SphereTables {
 public:
  explicit SphereTables(SphereSum sum) : sum_(std::move(sum)) {}

  /// @brief Tables as made for an earlier load case where they reach far enough.
  /// @param[in] request which tables
  /// @param[in] phi_reach,half_theta offsets and thetas that they reach at least
  /// @param[in] execution of the sum
  [[nodiscard]] std::shared_ptr<const std::vector<SphereTable>> tables(const SphereRequest& request, int phi_reach,
                                                                       int half_theta,
                                                                       const Execution& execution) const;

 private:
  struct Set {
    SphereRequest request;
    std::shared_ptr<const std::vector<SphereTable>> tables;
  };

  SphereSum sum_;
  mutable std::timed_mutex mutex_;
  mutable std::vector<Set> sets_;  // the widest of each request
};

}  // namespace viscoroll::detail

/// @file
/// @brief Influence on the exact sphere, kept for the load cases of a model.
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

  /// @return how many values of harmonics it takes
  [[nodiscard]] double values(const SphereRequest& request, int half_theta) const {
    return sum_.values(request, half_theta);
  }

  /// @brief Influence as summed for an earlier load case where it reaches far enough.
  /// @param[in] request which one
  /// @param[in] phi_reach,half_theta offsets and thetas that it reaches at least
  /// @param[in] execution of the sum
  [[nodiscard]] std::shared_ptr<const SphereInfluence> influence(const SphereRequest& request, int phi_reach,
                                                                 int half_theta, const Execution& execution) const;

 private:
  struct Entry {
    SphereRequest request;
    std::shared_ptr<const SphereInfluence> influence;
  };

  SphereSum sum_;
  mutable std::timed_mutex mutex_;
  mutable std::vector<Entry> entries_;  // the widest of each request
};

}  // namespace viscoroll::detail

/// @file
/// @brief Influence of forces on the exact sphere.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "influence/sphere_sum.hpp"
#include "rolling/surface_tables.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief Influence on the exact sphere, reused from an earlier load case if it reaches far enough.
class SphereTables final : public SurfaceTables {
 public:
  /// @param[in] sum computes the influence
  /// @param[in] mesh mesh of the influence
  SphereTables(SphereSum sum, const Mesh& mesh) : sum_(std::move(sum)), mesh_(mesh) {}

  /// @throws MeshTooFine if harmonics and tables have more values than fit into memory
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> operator_on(const SurfaceWindow& nodes,
                                                                   const Formulation& formulation,
                                                                   const Execution& execution) const override;

 private:
  /// @throws MeshTooFine if harmonics and tables have too many values
  void require_few_values(const SphereRequest& request, int phi_reach, int half_theta) const;
  /// @param[in] request kind of influence
  /// @param[in] phi_reach,half_theta offsets and thetas that it reaches at least
  /// @param[in] execution threads, progress and cancellation
  [[nodiscard]] std::shared_ptr<const SphereInfluence> influence(const SphereRequest& request, int phi_reach,
                                                                 int half_theta, const Execution& execution) const;

  struct Entry {
    SphereRequest request;
    std::shared_ptr<const SphereInfluence> influence;
  };

  SphereSum sum_;
  Mesh mesh_;
  mutable std::timed_mutex mutex_;
  mutable std::vector<Entry> entries_;  // the widest one for each request
};

}  // namespace viscoroll::detail

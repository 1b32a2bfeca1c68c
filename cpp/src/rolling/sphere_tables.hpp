/// @file
/// @brief Influence on the exact sphere.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "influence/sphere_sum.hpp"
#include "rolling/surface_tables.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief Influence as summed for an earlier load case, where it reaches far enough.
class SphereTables final : public SurfaceTables {
 public:
  /// @param[in] sum makes influence
  /// @param[in] mesh that it is made on
  SphereTables(SphereSum sum, const Mesh& mesh) : sum_(std::move(sum)), mesh_(mesh) {}

  /// @throws MeshTooFine where harmonics and tables have more values than can be held
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> operator_on(const SurfaceWindow& nodes,
                                                                   const Formulation& formulation,
                                                                   const Execution& execution) const override;

 private:
  /// @throws MeshTooFine where they are too many
  void require_few_values(const SphereRequest& request, int phi_reach, int half_theta) const;
  /// @param[in] request which one
  /// @param[in] phi_reach,half_theta offsets and thetas that it reaches at least
  /// @param[in] execution of the sum
  [[nodiscard]] std::shared_ptr<const SphereInfluence> influence(const SphereRequest& request, int phi_reach,
                                                                 int half_theta, const Execution& execution) const;

  struct Entry {
    SphereRequest request;
    std::shared_ptr<const SphereInfluence> influence;
  };

  SphereSum sum_;
  Mesh mesh_;
  mutable std::timed_mutex mutex_;
  mutable std::vector<Entry> entries_;  // the widest of each request
};

}  // namespace viscoroll::detail

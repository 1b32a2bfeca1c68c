/// @file
/// @brief Influence on the exact sphere, summed from vector spherical harmonics: theory.md section 4.
///
/// It depends on the offset in phi and on both thetas. Degrees up to some hundred are summed one by one; above, where
/// the surface is flat to a wave, the sums over orders of `synthesis.hpp` serve with the local metric.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "influence/synthesis.hpp"
#include "modal/degree_compliance.hpp"
#include "parallel.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Displacements at the nodes (j, k) of a window by unit forces on the nodes (0, k').
class SphereTable {
 public:
  SphereTable(int phi_reach, int theta_nodes)
      : phi_reach_(phi_reach), slices_(static_cast<std::size_t>(2 * phi_reach + 1)) {
    for (Eigen::MatrixXd& slice : slices_) slice.setZero(theta_nodes, theta_nodes);
  }

  /// @return matrix [k, k'] of the offset j in phi
  [[nodiscard]] const Eigen::MatrixXd& slice(int j) const { return slices_[static_cast<std::size_t>(j + phi_reach_)]; }
  [[nodiscard]] Eigen::MatrixXd& slice(int j) { return slices_[static_cast<std::size_t>(j + phi_reach_)]; }
  [[nodiscard]] int phi_reach() const { return phi_reach_; }
  [[nodiscard]] int theta_nodes() const { return static_cast<int>(slices_.front().rows()); }

 private:
  int phi_reach_;
  std::vector<Eigen::MatrixXd> slices_;
};

/// @brief Values of all tables of a window with so many nodes along each side, beyond which it is refused: 4 GB.
constexpr double kMostTableValues = 5e8;

/// @brief Which tables.
struct SphereRequest {
  bool tangential = false;  ///< all nine [3 P + Q] of (r, phi, theta), or r by r alone
  /// Displacements at nodes where false; where true, their derivatives in phi, averaged over patches: with nodal forces
  /// on both sides, the power lost per radian.
  bool power = false;
  PatchLoad patch_load = PatchLoad::flat;
  double collocation = 0.0;  ///< where displacements are taken, see `SurfaceOperator::collocation` [spacings]

  [[nodiscard]] int count() const { return tangential ? 9 : 1; }
  friend bool operator==(const SphereRequest&, const SphereRequest&) = default;
};

/// @brief What the tables of a coating on a mesh are summed from.
class SphereSum {
 public:
  /// @param[in] sphere core and layers, without inertia
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacings, and the highest degree as its truncation
  /// @param[in] exact_degree middle of the step between degrees summed one by one and those of the local metric
  SphereSum(CoatedSphere sphere, double angular_speed, const Mesh& mesh, double exact_degree = kExactDegree);

  /// @brief Sum all degrees and orders.
  /// @param[in] requests which sets of tables; the local metric serves all of them at once
  /// @param[in] phi_reach largest offset in phi
  /// @param[in] half_theta the thetas are those of the nodes -half_theta ... half_theta from the equator
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return a set of tables for each request
  [[nodiscard]] std::vector<std::vector<SphereTable>> tables(const std::vector<SphereRequest>& requests, int phi_reach,
                                                             int half_theta, int threads, Watch& watch) const;

  static constexpr double kExactDegree = 64.0;

 private:
  void add_degrees(const SphereRequest& request, std::vector<SphereTable>& tables, int threads, Watch& watch) const;
  void add_local(const std::vector<SphereRequest>& requests, std::vector<std::vector<SphereTable>>& sets, int threads,
                 Watch& watch) const;

  CoatedSphere sphere_;
  double angular_speed_;
  Mesh mesh_;
  double exact_degree_;  // infinite where the mesh truncates
  int highest_degree_;
};

}  // namespace viscoroll::detail

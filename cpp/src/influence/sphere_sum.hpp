/// @file
/// @brief Influence on the exact sphere, summed from vector spherical harmonics: theory.md section 4.
///
/// It depends on the offset in phi and on both thetas. Degrees up to some hundred are summed one by one, between few
/// thetas, on which waves so long vary no further; above, where the surface is flat to a wave, the sums over orders of
/// `synthesis.hpp` serve with the local metric, as a polynomial in it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "influence/synthesis.hpp"
#include "modal/degree_compliance.hpp"
#include "parallel.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Displacements at offsets in phi and at some thetas by unit forces at those thetas.
class SphereTable {
 public:
  SphereTable(int phi_reach, Eigen::Index thetas)
      : phi_reach_(phi_reach), slices_(static_cast<std::size_t>(2 * phi_reach + 1)) {
    for (Eigen::MatrixXd& slice : slices_) slice.setZero(thetas, thetas);
  }

  /// @return matrix [displaced theta, loaded theta] of the offset j in phi
  [[nodiscard]] const Eigen::MatrixXd& slice(int j) const { return slices_[static_cast<std::size_t>(j + phi_reach_)]; }
  [[nodiscard]] Eigen::MatrixXd& slice(int j) { return slices_[static_cast<std::size_t>(j + phi_reach_)]; }
  [[nodiscard]] int phi_reach() const { return phi_reach_; }
  [[nodiscard]] Eigen::Index thetas() const { return slices_.front().rows(); }

 private:
  int phi_reach_;
  std::vector<Eigen::MatrixXd> slices_;
};

/// @brief Displacements at the nodes (j, k) of a window by unit forces on the nodes (0, k'), in factors:
/// D degrees(j) L^T + sum over n of (s_k s_k')^(n - 1) local_n(j, k - k').
struct SphereInfluence {
  std::vector<SphereTable> degrees;  ///< between some thetas: one for r by r, or nine [3 P + Q] of (r, phi, theta)
  Eigen::MatrixXd displaced;         ///< D: what values at these thetas are at the nodes
  Eigen::MatrixXd loaded;            ///< L: what forces on the nodes are on these thetas
  /// [n * (tables of one power) + entry] in powers of the metric, none where all degrees are in `degrees`
  std::vector<Table> local;
  std::size_t powers = 0;  ///< of the metric
  Eigen::ArrayXd root;     ///< s of every node, the root of sin(theta): the metric of two nodes is s s'

  /// @return tables along (r, phi, theta), or along r alone
  [[nodiscard]] std::size_t components() const { return degrees.size() == 1 ? 1 : 3; }
  [[nodiscard]] int phi_reach() const { return degrees.front().phi_reach(); }
  /// @return number of the node on the equator, the thetas being as many on either side
  [[nodiscard]] int half_theta() const { return static_cast<int>(root.size() - 1) / 2; }
};

/// @brief The same for every other node, on patches of twice the width and length.
/// @param[in] fine influence of nodes, those of the equator and of no offset stay
/// @param[in] downstream share of displacements that is taken an offset further on
/// @param[in] power whether what is displaced is an average over patches, as what is loaded
[[nodiscard]] SphereInfluence with_wide_patches(const SphereInfluence& fine, double downstream, bool power);

/// @return as if it depended on the offset in theta alone, as it does close to the equator: r by r, or all [Entry]
[[nodiscard]] std::vector<Table> tables_around_equator(const SphereInfluence& influence);

/// @brief Values of the tables between thetas of a window, beyond which it is refused: 4 GB.
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

/// @brief Degree up to which all that is summed one by one reaches, by the middle of the step where it ends.
[[nodiscard]] int highest_degree(double exact_degree);

/// @brief What the influence of a coating on a mesh is summed from.
class SphereSum {
 public:
  /// @param[in] sphere core and layers, without inertia
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacings, and the highest degree as its truncation
  /// @param[in] exact_degree middle of the step between degrees summed one by one and those of the local metric
  SphereSum(CoatedSphere sphere, double angular_speed, const Mesh& mesh, double exact_degree = kExactDegree);

  /// @brief Sum all degrees and orders.
  /// @param[in] requests what to sum; the local metric serves all of them at once
  /// @param[in] phi_reach largest offset in phi
  /// @param[in] half_theta the thetas are those of the nodes -half_theta ... half_theta from the equator
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return the influence that each request is for
  [[nodiscard]] std::vector<SphereInfluence> influences(const std::vector<SphereRequest>& requests, int phi_reach,
                                                        int half_theta, int threads, Watch& watch) const;

  /// @return number of thetas between which degrees are summed for nodes up to half_theta from the equator
  [[nodiscard]] int thetas(int half_theta) const;

  static constexpr double kExactDegree = 64.0;

 private:
  void add_degrees(const SphereRequest& request, const Eigen::ArrayXd& thetas, std::vector<SphereTable>& tables,
                   int threads, Watch& watch) const;
  void add_local(const std::vector<SphereRequest>& requests, std::vector<SphereInfluence>& influences, int half_theta,
                 int threads, Watch& watch) const;

  CoatedSphere sphere_;
  double angular_speed_;
  Mesh mesh_;
  double exact_degree_;  // infinite where the mesh truncates
  int highest_degree_;
};

}  // namespace viscoroll::detail

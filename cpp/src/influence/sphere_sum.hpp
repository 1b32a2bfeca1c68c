/// @file
/// @brief Influence on the exact sphere, summed from vector spherical harmonics (docs/theory/influence-tables.md).
///
/// The influence depends on the offset in phi and on theta of both nodes. Degrees up to about a hundred are represented
/// one by one, by their harmonics at the nodes. For higher degrees the surface is flat on the scale of a wave: their
/// influence is a sum over orders (`synthesis.hpp`) in the local metric, represented as a polynomial in the metric.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "base/parallel.hpp"
#include "influence/spherical_order.hpp"
#include "influence/synthesis.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Displacements at the nodes (j, k) of a window due to unit forces on the nodes (0, k'), in factors: the
/// degrees of every order, plus the sum over n of (s_k s_k')^(n - 1) local_n(j, k - k').
struct SphereInfluence {
  std::vector<SphericalOrder> orders;  ///< orders m = 0, 1, ...
  bool tangential;                     ///< components (r, phi, theta), or r alone
  double phi_spacing;                  ///< spacing of the nodes [rad]
  int phi_reach;                       ///< largest offset in phi
  /// [n * (tables of one power) + entry] by powers of the metric; empty if `orders` contains all degrees
  std::vector<Table> local;
  std::size_t powers;   ///< number of powers of the metric
  Eigen::ArrayXd root;  ///< s of every node, the square root of sin(theta); the metric of two nodes is s s'

  [[nodiscard]] std::size_t components() const { return tangential ? 3 : 1; }
  /// @return index of the node on the equator; there are as many thetas on either side
  [[nodiscard]] int half_theta() const { return static_cast<int>(root.size() - 1) / 2; }
};

/// @brief Influence of every other node, on patches of twice the width and length.
/// @param[in] fine influence of all nodes; nodes on the equator and at zero offset are kept
/// @param[in] downstream weight of the displacement one offset downstream
/// @param[in] power whether the displacement is also an average over patches, like the load
[[nodiscard]] SphereInfluence with_wide_patches(const SphereInfluence& fine, double downstream, bool power);

/// @return influence near the equator, where it depends only on the offset in theta: r by r, or all [Entry]
[[nodiscard]] std::vector<Table> tables_around_equator(const SphereInfluence& influence);

/// @brief Largest number of values of harmonics and tables for the nodes of a window: 4 GB. Larger windows are
/// rejected.
constexpr double kMaxSphereValues = 5e8;

/// @brief Quantity and components of an influence.
struct SphereRequest {
  bool tangential = false;  ///< components (r, phi, theta), or r alone
  /// If false, displacements at nodes; if true, their derivatives in phi, averaged over patches. With nodal forces on
  /// both sides these give the dissipated power per radian.
  bool power = false;
  PatchLoad patch_load = PatchLoad::flat;
  double collocation = 0.0;  ///< see `SurfaceOperator::collocation` [spacings]

  /// @return whether both requests have the same loaded components and patch load
  [[nodiscard]] bool has_same_loads_as(const SphereRequest& other) const {
    return patch_load == other.patch_load && tangential == other.tangential;
  }
  friend bool operator==(const SphereRequest&, const SphereRequest&) = default;
};

/// @brief Sum over degrees and orders of a coating on a mesh.
class SphereSum {
 public:
  /// @param[in] sphere layers, without inertia
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacings, with the highest degree as truncation; work is per radian of the rolling body
  /// @param[in] exact_degree middle of the step between degrees that are summed one by one and the local metric
  SphereSum(LayeredBody sphere, double angular_speed, const MeshOnBody& mesh, double exact_degree = kExactDegree);

  /// @brief Sum all degrees and orders.
  /// @param[in] requests influences to compute; one sum in the local metric serves all of them
  /// @param[in] phi_reach largest offset in phi
  /// @param[in] half_theta thetas are those of the nodes -half_theta ... half_theta from the equator
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return one influence per request
  [[nodiscard]] std::vector<SphereInfluence> influences(const std::vector<SphereRequest>& requests, int phi_reach,
                                                        int half_theta, int threads, Watch& watch) const;

  /// @return number of values of harmonics and tables that `influences` computes
  [[nodiscard]] double values(const SphereRequest& request, int phi_reach, int half_theta) const;

  static constexpr double kExactDegree = 64.0;

 private:
  void add_degrees(const std::vector<SphereRequest>& requests, std::vector<SphereInfluence>& influences, int threads,
                   Watch& watch) const;
  /// Compliances of every other degree, without the harmonics.
  [[nodiscard]] EveryOtherDegree every_other(const std::vector<DegreeCompliance>& compliances, int order,
                                             std::size_t first, std::complex<double> factor) const;
  void add_local(const std::vector<SphereRequest>& requests, std::vector<SphereInfluence>& influences, int half_theta,
                 int threads, Watch& watch) const;

  LayeredBody sphere_;
  double angular_speed_;
  MeshOnBody mesh_;
  double exact_degree_;  // infinite if the mesh has a truncation
  int highest_degree_;
};

}  // namespace viscoroll::detail

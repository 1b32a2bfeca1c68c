/// @file
/// @brief Influence on the exact sphere, summed from vector spherical harmonics: docs/theory/influence-tables.md.
///
/// It depends on the offset in phi and on both thetas. Degrees up to some hundred are kept one by one, by what their
/// harmonics are at the nodes; above, where the surface is flat to a wave, the sums over orders of `synthesis.hpp`
/// serve with the local metric, as a polynomial in it.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "influence/spherical_order.hpp"
#include "influence/synthesis.hpp"
#include "parallel.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Displacements at the nodes (j, k) of a window by unit forces on the nodes (0, k'), in factors: the degrees of
/// every order, and the sum over n of (s_k s_k')^(n - 1) local_n(j, k - k').
struct SphereInfluence {
  std::vector<SphericalOrder> orders;  ///< m = 0, 1, ...
  bool tangential;                     ///< along (r, phi, theta), or r by r alone
  double phi_spacing;                  ///< of the nodes [rad]
  int phi_reach;                       ///< largest offset in phi
  /// [n * (tables of one power) + entry] in powers of the metric, none where all degrees are in `orders`
  std::vector<Table> local;
  std::size_t powers;   ///< of the metric
  Eigen::ArrayXd root;  ///< s of every node, the root of sin(theta): the metric of two nodes is s s'

  [[nodiscard]] std::size_t components() const { return tangential ? 3 : 1; }
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

/// @brief Values of harmonics and tables for the nodes of a window, beyond which it is refused: 4 GB.
constexpr double kMostSphereValues = 5e8;

/// @brief Which tables.
struct SphereRequest {
  bool tangential = false;  ///< along (r, phi, theta), or r by r alone
  /// Displacements at nodes where false; where true, their derivatives in phi, averaged over patches: with nodal forces
  /// on both sides, the power lost per radian.
  bool power = false;
  PatchLoad patch_load = PatchLoad::flat;
  double collocation = 0.0;  ///< where displacements are taken, see `SurfaceOperator::collocation` [spacings]

  /// @return whether forces are the same on both
  [[nodiscard]] bool is_on_patches_of(const SphereRequest& other) const {
    return patch_load == other.patch_load && tangential == other.tangential;
  }
  friend bool operator==(const SphereRequest&, const SphereRequest&) = default;
};

/// @brief What the influence of a coating on a mesh is summed from.
class SphereSum {
 public:
  /// @param[in] sphere its layers, without inertia
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacings, and the highest degree as its truncation; work is done per radian of what it is the mesh
  /// of
  /// @param[in] exact_degree middle of the step between degrees summed one by one and those of the local metric
  SphereSum(LayeredBody sphere, double angular_speed, const MeshOnBody& mesh, double exact_degree = kExactDegree);

  /// @brief Sum all degrees and orders.
  /// @param[in] requests what to sum; the local metric serves all of them at once
  /// @param[in] phi_reach largest offset in phi
  /// @param[in] half_theta the thetas are those of the nodes -half_theta ... half_theta from the equator
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return the influence that each request is for
  [[nodiscard]] std::vector<SphereInfluence> influences(const std::vector<SphereRequest>& requests, int phi_reach,
                                                        int half_theta, int threads, Watch& watch) const;

  /// @return number of values of harmonics and tables that serve nodes as in `influences`
  [[nodiscard]] double values(const SphereRequest& request, int phi_reach, int half_theta) const;

  static constexpr double kExactDegree = 64.0;

 private:
  void add_degrees(const std::vector<SphereRequest>& requests, std::vector<SphereInfluence>& influences, int threads,
                   Watch& watch) const;
  /// Of every other degree, but for the harmonics.
  [[nodiscard]] EveryOtherDegree every_other(const std::vector<DegreeCompliance>& compliances, int order,
                                             std::size_t first, std::complex<double> factor) const;
  void add_local(const std::vector<SphereRequest>& requests, std::vector<SphereInfluence>& influences, int half_theta,
                 int threads, Watch& watch) const;

  LayeredBody sphere_;
  double angular_speed_;
  MeshOnBody mesh_;
  double exact_degree_;  // infinite where the mesh truncates
  int highest_degree_;
};

}  // namespace viscoroll::detail

/// @file
/// @brief Tables along phi of the effect of free faces on the influence of an unbounded tread.
///
/// Between the sampled orders the difference is a spline, which is linear in the samples. A table is therefore the sum
/// of the samples times one factor per offset, which contains all orders, patches and moduli. A further speed requires
/// only new factors.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "influence/mesh_on_body.hpp"
#include "influence/order_bands.hpp"
#include "modal/harmonic_body.hpp"
#include "section/side_difference.hpp"

namespace viscoroll::detail {

/// @brief Factors of the sampled orders at offsets along phi.
struct SideFactors {
  int phi_reach;
  /// [offset -phi_reach ... phi_reach, sampled order]; a table is the real part of this times the samples [1/Pa]
  Eigen::MatrixXcd values;
};

/// @brief Averages over patches of two spacings at every `stride`-th offset, same as for a `Table`.
/// @param[in] fine factors of the fine mesh
/// @param[in] stride stride of the offsets [fine spacings]
/// @param[in] downstream weight of the displacement one offset downstream
[[nodiscard]] SideFactors widened(const SideFactors& fine, int stride, double downstream = 0.0);

/// @brief Quantity that is evaluated at the offsets.
struct SideRequest {
  int phi_reach = 0;
  /// Distance downstream of the nodes at which displacement is evaluated [spacings].
  double phi_shift = 0.0;
  bool power = false;  ///< dissipated power per radian instead of displacement, as in `TableRequest`
};

/// @return inverse of the outermost layer's modulus at the orders of a body [1/Pa]
[[nodiscard]] Eigen::VectorXcd outer_softness(const HarmonicBody& body);

/// @brief Sums over all orders, on a mesh and at a speed.
class SideSum {
 public:
  /// @param[in] difference sampled difference, times a modulus
  /// @param[in] bands bands along phi
  /// @param[in] smallest inverse of that modulus at the orders of all bands [1/Pa]
  /// @param[in] mesh mesh on the body
  SideSum(std::shared_ptr<const SampledDifference> difference, std::vector<OrderBand> bands,
          const Eigen::VectorXcd& smallest, const MeshOnBody& mesh);

  [[nodiscard]] const std::shared_ptr<const SampledDifference>& difference() const { return difference_; }
  [[nodiscard]] SideFactors factors(const SideRequest& request) const;

 private:
  std::shared_ptr<const SampledDifference> difference_;
  std::vector<OrderBand> bands_;
  std::vector<Eigen::MatrixXcd> shares_;  // [band][order, sampled order], divided by the modulus
  MeshOnBody mesh_;
};

/// @brief Weights of the samples in the difference at an order, by a cubic spline in ln m.
/// @param[in] sampled 0, then at least four orders at equal ratios, ascending from 1
/// @param[in] orders orders >= 0. Below 1 only 0 itself occurs, where the material is relaxed. Above the last sample
/// the difference decreases like 1/m, as compliances of short waves do.
/// @return [order, sampled order]
[[nodiscard]] Eigen::MatrixXd shares_of_samples(const Eigen::ArrayXd& sampled, const Eigen::ArrayXd& orders);

}  // namespace viscoroll::detail

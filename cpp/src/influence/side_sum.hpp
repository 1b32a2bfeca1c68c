/// @file
/// @brief Tables along phi of what free sides add to the influence of an endless tread.
///
/// Between the sampled orders the difference is a spline, which is linear in the samples: a table is a sum of the
/// samples, each with a factor for every offset that holds all orders, patches and moduli. A speed costs no more than
/// these factors.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "influence/mesh_on_body.hpp"
#include "influence/order_bands.hpp"
#include "modal/harmonic_body.hpp"
#include "section/side_difference.hpp"

namespace viscoroll::detail {

/// @brief What offsets along phi make of sampled orders.
struct SideFactors {
  int phi_reach;
  /// [offset -phi_reach ... phi_reach, sampled order] a table is the real part of this times the samples [1/Pa]
  Eigen::MatrixXcd values;
};

/// @brief Averages over patches of two spacings, at every `stride`-th offset, as of a `Table`.
/// @param[in] downstream share of displacements that is taken an offset further on
[[nodiscard]] SideFactors widened(const SideFactors& fine, int stride, double downstream = 0.0);

/// @brief What is asked for at the offsets.
struct SideRequest {
  int phi_reach = 0;
  double phi_shift = 0.0;  ///< where displacement is taken, downstream of the nodes [spacings]
  bool power = false;      ///< the power lost per radian in place of displacement, as `TableRequest` says
};

/// @return the inverse of the outermost layer's modulus at the orders of a body [1/Pa]
[[nodiscard]] Eigen::VectorXcd outer_softness(const HarmonicBody& body);

/// @brief The sums over all orders, on a mesh and at a speed.
class SideSum {
 public:
  /// @param[in] difference times a modulus
  /// @param[in] bands along phi
  /// @param[in] softness the inverse of that modulus at the orders of all bands [1/Pa]
  /// @param[in] mesh on the body
  SideSum(std::shared_ptr<const SampledDifference> difference, std::vector<OrderBand> bands,
          const Eigen::VectorXcd& softness, const MeshOnBody& mesh);

  [[nodiscard]] const std::shared_ptr<const SampledDifference>& difference() const { return difference_; }
  [[nodiscard]] SideFactors factors(const SideRequest& request) const;

 private:
  std::shared_ptr<const SampledDifference> difference_;
  std::vector<OrderBand> bands_;
  std::vector<Eigen::MatrixXcd> shares_;  // [band][order, sampled order] by the modulus
  MeshOnBody mesh_;
};

/// @brief The shares that samples have in the difference at an order, by a cubic spline in ln m.
/// @param[in] sampled 0, and ascending from 1, at least four
/// @param[in] orders >= 0: below 1 only 0 itself is asked for, where the material is relaxed; above the last the
/// difference falls as compliances of short waves do, like 1/m
/// @return [order, sampled order]
[[nodiscard]] Eigen::MatrixXd shares_of_samples(const Eigen::ArrayXd& sampled, const Eigen::ArrayXd& orders);

}  // namespace viscoroll::detail

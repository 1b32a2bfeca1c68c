/// @file
/// @brief Influence of the free faces of a tread: the difference to the influence of an unbounded tread, which depends
/// on the positions of load and displacement across the tread.
///
/// Between the sampled orders the difference is a spline, which is linear in the samples. A table along phi is
/// therefore the sum of the samples times one factor per offset, which contains all orders, patches and moduli. A
/// further speed requires only new factors.
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "influence/fft.hpp"
#include "influence/mesh_on_body.hpp"
#include "influence/order_bands.hpp"
#include "influence/spectral_product.hpp"
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
[[nodiscard]] Eigen::VectorXcd inverse_outer_modulus(const HarmonicBody& body);

/// @brief Sums over all orders, on a mesh and at a speed.
class SideSum {
 public:
  /// @param[in] difference sampled difference of compliances, multiplied by a modulus
  /// @param[in] bands bands along phi
  /// @param[in] inverse_modulus inverse of that modulus at the orders of all bands [1/Pa]
  /// @param[in] mesh mesh on the body
  SideSum(std::shared_ptr<const SampledDifference> difference, std::vector<OrderBand> bands,
          const Eigen::VectorXcd& inverse_modulus, const MeshOnBody& mesh);

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

/// @brief Positions of columns across the tread.
struct TreadColumns {
  int first;       ///< number of the first column; column 0 is in the middle of the tread
  double spacing;  ///< distance between columns, and width of their patches [m]
};

/// @brief Weights with which the values on the lines enter the mean of a field over the patch of each column. The patch
/// is cut off at the faces of the tread.
/// @param[in] lines distances of the lines from the middle of the tread [m], ascending; the last line is at the face.
/// The first is in the middle, or where the effect of the faces begins; positions nearer to the middle have zero
/// weights.
/// @param[in] columns positions of the columns
/// @param[in] count number of columns
/// @param[in] odd whether the field changes sign across the middle
/// @return [line, column]
[[nodiscard]] Eigen::MatrixXd patch_mean_weights(const Eigen::ArrayXd& lines, const TreadColumns& columns,
                                                 Eigen::Index count, bool odd);

/// @return weights with which the values on the lines enter the value in the middle of each column, [line, column];
/// parameters same as in `patch_mean_weights`
[[nodiscard]] Eigen::MatrixXd node_weights(const Eigen::ArrayXd& lines, const TreadColumns& columns, Eigen::Index count,
                                           bool odd);

/// @brief Product that gathers forces on patches on the few lines of nodes of the section, transforms them along phi,
/// multiplies by one matrix per frequency, and reads the displacements at the columns.
class SideProduct {
 public:
  /// @param[in] shape window
  /// @param[in] columns columns of the window, in the direction of theta
  /// @param[in] difference difference between the sections with and without faces
  /// @param[in] factors factors at offsets across the window
  /// @param[in] average whether the result is a mean over patches (for work) or the value at nodes
  SideProduct(WindowShape shape, const TreadColumns& columns, const SampledDifference& difference,
              const SideFactors& factors, bool average);

  /// @param[in] loads one column per component (r, phi, theta), or r alone, and one row per node
  /// @return displacements in the same layout
  [[nodiscard]] Eigen::ArrayXXd apply(const Eigen::ArrayXXd& loads) const;

  /// @return approximate number of floating-point operations of a product
  [[nodiscard]] double operations() const;

 private:
  /// The even or the odd part about the middle of the tread.
  struct Part {
    std::vector<Eigen::MatrixXd> gathered;  // [component], weights of lines in the forces on columns, [line, column]
    std::vector<Eigen::MatrixXd> read;      // [component], weights of lines in displacements at columns, [line, column]
    std::vector<Eigen::MatrixXcd> spectrum;  // [frequency], for amplitudes component * lines + line
  };

  WindowShape shape_;
  Eigen::Index components_;
  Eigen::Index lines_;
  int period_;  // along phi, long enough to keep images apart
  RealFft fft_;
  std::array<Part, 2> parts_;
};

}  // namespace viscoroll::detail

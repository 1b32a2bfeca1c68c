#include "influence/sampled_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/dense_products.hpp"
#include "modal/chebyshev_panels.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::MatrixXd;

/// Number of angles between which waves are interpolated by polynomials, in a range of half width `half_angle`. The
/// coefficients of cos(x t) vanish beyond the degree x, within some widths x^(1/3) of the edge of a Bessel function.
int sampled_angles(double half_angle, double highest_order) {
  const double x = half_angle * highest_order;
  return static_cast<int>(std::ceil(x + 6.0 * std::cbrt(x) + 6.0));
}

}  // namespace

ChebyshevNodes::ChebyshevNodes(int count)
    : angle(std::numbers::pi * (Eigen::ArrayXd::LinSpaced(count, 0.0, count - 1.0) + 0.5) / count) {}

MatrixXd ChebyshevNodes::interpolation(const Eigen::ArrayXd& targets) const {
  const auto count = static_cast<double>(angle.size());
  const Eigen::RowVectorXd degrees = Eigen::RowVectorXd::LinSpaced(angle.size(), 0.0, count - 1.0);
  const MatrixXd terms = (targets.max(-1.0).min(1.0).acos().matrix() * degrees).array().cos();
  const MatrixXd transform = chebyshev_transform(static_cast<int>(angle.size()));
  return product(terms, transform.transpose());
}

int SampledOffsets::count(int reach, double spacing, double highest_order) {
  return std::min((sampled_angles(reach * spacing, highest_order) + 1) / 2, reach + 1);
}

SampledOffsets::SampledOffsets(int reach, double spacing, double highest_order) {
  const int half = count(reach, spacing, highest_order);
  if (half > reach) {
    sampled = Eigen::ArrayXd::LinSpaced(reach + 1, 0.0, reach) * spacing;
    even = odd = MatrixXd::Identity(reach + 1, reach + 1);
    return;
  }
  const ChebyshevNodes nodes(2 * half);  // the first half is positive, the second half is its mirror image
  sampled = nodes.points().head(half) * (reach * spacing);
  const MatrixXd basis = nodes.interpolation(Eigen::ArrayXd::LinSpaced(reach + 1, 0.0, 1.0));
  even = basis.leftCols(half) + basis.rightCols(half).rowwise().reverse();
  odd = basis.leftCols(half) - basis.rightCols(half).rowwise().reverse();
  odd.row(0).setZero();  // exactly
}

}  // namespace viscoroll::detail

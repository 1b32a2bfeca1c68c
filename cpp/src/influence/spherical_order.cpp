#include "influence/spherical_order.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/dense_products.hpp"
#include "influence/legendre.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

using Harmonic = MatrixXd Harmonics::*;
using Middle = Eigen::ArrayXcd EveryOtherDegree::*;

/// One of the products whose sum is the displacement along a component.
struct Term {
  Harmonic displaced;
  Middle middle;
  Harmonic loaded;
  cplx factor;
};

/// Terms of A C A^H, where A are the components of Y, Psi and Phi.
std::vector<Term> terms(int p, int q) {
  const cplx i(0.0, 1.0);
  constexpr auto kP = &Harmonics::p;
  constexpr auto kD = &Harmonics::d;
  constexpr auto kE = &Harmonics::e;
  constexpr auto kRadial = &EveryOtherDegree::radial;
  constexpr auto kMixed = &EveryOtherDegree::mixed;
  constexpr auto kAlong = &EveryOtherDegree::along;
  constexpr auto kAcross = &EveryOtherDegree::across;
  switch (3 * p + q) {
    case 0:
      return {{kP, kRadial, kP, 1.0}};
    case 1:
      return {{kP, kMixed, kE, -i}};
    case 2:
      return {{kP, kMixed, kD, 1.0}};
    case 3:
      return {{kE, kMixed, kP, i}};
    case 4:
      return {{kE, kAlong, kE, 1.0}, {kD, kAcross, kD, 1.0}};
    case 5:
      return {{kE, kAlong, kD, i}, {kD, kAcross, kE, i}};
    case 6:
      return {{kD, kMixed, kP, 1.0}};
    case 7:
      return {{kD, kAlong, kE, -i}, {kE, kAcross, kD, -i}};
    default:
      return {{kD, kAlong, kD, 1.0}, {kE, kAcross, kE, 1.0}};
  }
}

/// Sign of a harmonic of the degrees m, m + 2, ... at the mirror image of a node about the equator; those of the other
/// degrees have the opposite sign.
double mirrored(Harmonic harmonic) { return harmonic == &Harmonics::d ? -1.0 : 1.0; }

MatrixXd every_other(const MatrixXd& degrees, Index first) {
  return degrees(Eigen::seq(first, Eigen::last, Eigen::fix<2>), Eigen::all);
}

/// Every other column, or means with a quarter of each neighbor.
MatrixXd coarse_columns(const MatrixXd& fine, double mirror, bool wide) {
  const Index count = fine.cols() / 2;  // the last column has two neighbors
  MatrixXd coarse(fine.rows(), count);
  for (Index k = 0; k < count; ++k) {
    coarse.col(k) = fine.col(2 * k);
    if (!wide) continue;
    const double side = k == 0 ? mirror : 1.0;
    coarse.col(k) = 0.5 * fine.col(2 * k) + 0.25 * (side * fine.col(std::abs(2 * k - 1)) + fine.col(2 * k + 1));
  }
  return coarse;
}

std::shared_ptr<const Harmonics> coarse_harmonics(const Harmonics& fine, double even, bool wide) {
  Harmonics coarse{.p = coarse_columns(fine.p, even, wide), .d = {}, .e = {}};
  if (fine.d.cols() > 0) {  // at the highest order one of the two sets of degrees may be empty
    coarse.d = coarse_columns(fine.d, -even, wide);
    coarse.e = coarse_columns(fine.e, even, wide);
  }
  return std::make_shared<const Harmonics>(std::move(coarse));
}

}  // namespace

std::array<Harmonics, 2> harmonics_at(int order, int highest, const Eigen::ArrayXd& theta, bool tangential) {
  LegendreFunctions functions(order, highest, theta);
  std::array<Harmonics, 2> harmonics;
  for (const Index first : {Index{0}, Index{1}}) {
    harmonics[static_cast<std::size_t>(first)].p = every_other(functions.value, first);
  }
  if (!tangential) return harmonics;
  const Index count = functions.value.rows();
  Eigen::ArrayXd scale(count);
  for (Index row = 0; row < count; ++row) {
    const auto degree = static_cast<double>(order + row);
    scale[row] = degree > 0.0 ? 1.0 / std::sqrt(degree * (degree + 1.0)) : 0.0;
  }
  functions.slope.array().colwise() *= scale;
  functions.value = (functions.value.array().colwise() * (scale * order)).rowwise() / theta.sin().transpose();
  for (const Index first : {Index{0}, Index{1}}) {
    harmonics[static_cast<std::size_t>(first)].d = every_other(functions.slope, first);
    harmonics[static_cast<std::size_t>(first)].e = every_other(functions.value, first);
  }
  return harmonics;
}

ThetaPatches::ThetaPatches(Index nodes, double spacing, PatchLoad load, int highest)
    : points_(8 + static_cast<Index>(0.25 * spacing * highest)) {
  const auto [abscissas, weights] = gauss_legendre(static_cast<int>(points_));
  theta_.resize(nodes * points_);
  weight_.resize(theta_.size());
  for (Index k = 0; k < nodes; ++k) {
    const double middle = 0.5 * std::numbers::pi + spacing * static_cast<double>(k);
    theta_.segment(k * points_, points_) = middle + 0.5 * spacing * abscissas;
    auto share = weight_.segment(k * points_, points_);
    // Weights of a unit force on the patch; a uniform traction is weighted by sin(theta).
    share = weights;
    if (load == PatchLoad::flat) share *= theta_.segment(k * points_, points_).sin();
    share /= share.sum();
  }
}

MatrixXd ThetaPatches::means(const MatrixXd& values) const {
  MatrixXd result(values.rows(), values.cols() / points_);
  for (Index k = 0; k < result.cols(); ++k) {
    result.col(k).noalias() = values.middleCols(k * points_, points_) * weight_.segment(k * points_, points_).matrix();
  }
  return result;
}

std::array<Harmonics, 2> ThetaPatches::harmonics(int order, int highest, bool tangential) const {
  std::array<Harmonics, 2> result = harmonics_at(order, highest, theta_, tangential);
  for (Harmonics& harmonics : result) {
    harmonics.p = means(harmonics.p);
    if (!tangential) continue;
    harmonics.d = means(harmonics.d);
    harmonics.e = means(harmonics.e);
  }
  return result;
}

SphericalOrder with_wide_patches(const SphericalOrder& fine, cplx factor, bool wide_displaced) {
  SphericalOrder coarse;
  for (std::size_t side = 0; side < 2; ++side) {
    const EveryOtherDegree& own = fine[side];
    const double even = side == 0 ? 1.0 : -1.0;
    coarse[side] = {.displaced = coarse_harmonics(*own.displaced, even, wide_displaced),
                    .loaded = coarse_harmonics(*own.loaded, even, true),
                    .radial = factor * own.radial,
                    .mixed = factor * own.mixed,
                    .along = factor * own.along,
                    .across = factor * own.across};
  }
  return coarse;
}

Eigen::MatrixXcd sum_between(const SphericalOrder& order, int p, int q, Index half_theta) {
  const Index half = half_theta + 1;
  Eigen::MatrixXcd all = Eigen::MatrixXcd::Zero(2 * half - 1, 2 * half - 1);
  for (const Term& term : terms(p, q)) {
    std::array<Eigen::MatrixXcd, 2> sums;
    for (std::size_t side = 0; side < 2; ++side) {
      const EveryOtherDegree& own = order[side];
      const Eigen::ArrayXcd middle = term.factor * own.*term.middle;
      const auto left = ((*own.displaced).*term.displaced).leftCols(half).transpose();
      const auto right = ((*own.loaded).*term.loaded).leftCols(half);
      sums[side].resize(half, half);
      sums[side].real() = product(left, MatrixXd(middle.real().matrix().asDiagonal() * right));
      sums[side].imag() = product(left, MatrixXd(middle.imag().matrix().asDiagonal() * right));
    }
    const Eigen::MatrixXcd same = sums[0] + sums[1];
    const Eigen::MatrixXcd opposite = sums[0] - sums[1];
    const double displaced_sign = mirrored(term.displaced);
    const double loaded_sign = mirrored(term.loaded);
    const Index rest = half_theta;
    all.bottomRightCorner(half, half) += same;
    all.bottomLeftCorner(half, rest) += loaded_sign * opposite.rightCols(rest).rowwise().reverse();
    all.topRightCorner(rest, half) += displaced_sign * opposite.bottomRows(rest).colwise().reverse();
    all.topLeftCorner(rest, rest) += displaced_sign * loaded_sign * same.bottomRightCorner(rest, rest).reverse();
  }
  return all;
}

Eigen::VectorXcd sum_across_equator(const SphericalOrder& order, int p, int q, int reach) {
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(reach + 1);
  for (const Term& term : terms(p, q)) {
    for (std::size_t side = 0; side < 2; ++side) {
      const EveryOtherDegree& own = order[side];
      const Eigen::VectorXcd middle = (own.*term.middle).matrix();
      const cplx factor = term.factor * mirrored(term.loaded) * (side == 0 ? 1.0 : -1.0);
      const MatrixXd& displaced = (*own.displaced).*term.displaced;
      const MatrixXd& loaded = (*own.loaded).*term.loaded;
      for (int l = 0; l <= reach; ++l) {
        sum[l] +=
            factor * displaced.col((l + 1) / 2).cwiseProduct(loaded.col(l / 2)).cast<cplx>().cwiseProduct(middle).sum();
      }
    }
  }
  return sum;
}

OrderPhases::OrderPhases(int orders, int reach, double spacing) {
  const Eigen::VectorXd offsets = Eigen::VectorXd::LinSpaced(reach + 1, 0.0, reach) * spacing;
  const MatrixXd phase = offsets * Eigen::RowVectorXd::LinSpaced(orders, 0.0, orders - 1.0);
  cosines_ = phase.array().cos();
  sines_ = phase.array().sin();
}

OrderPhases::Sums OrderPhases::operator()(const MatrixXd& real, const MatrixXd& imaginary) const {
  return {.even = product(cosines_, real), .odd = -product(sines_, imaginary)};
}

}  // namespace viscoroll::detail

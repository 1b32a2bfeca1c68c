#include "influence/side_sum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "base/dense_solvers.hpp"
#include "influence/table.hpp"
#include "influence/waves.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

/// Second derivatives of the splines that are 1 at one of the equidistant knots and 0 at the others: [knot, index of
/// that one]. The knot next to the first is not a knot. At the last one the slope is that of a function that decreases
/// like 1/m from there on, because octaves are smooth.
MatrixXd spline_bends(Index knots, double distance) {
  MatrixXd smooth = MatrixXd::Zero(knots, knots);
  MatrixXd bends = MatrixXd::Zero(knots, knots);
  for (Index i = 1; i + 1 < knots; ++i) {
    smooth.row(i).segment(i - 1, 3) << 1.0, 4.0, 1.0;
    bends.row(i).segment(i - 1, 3) << 6.0, -12.0, 6.0;
  }
  smooth.row(0).head(3) << 1.0, -2.0, 1.0;
  smooth.row(knots - 1).tail(2) << 1.0, 2.0;
  bends.row(knots - 1).tail(2) << 6.0, -6.0 * (1.0 + distance);
  return dense_inverse(smooth) * bends / (distance * distance);
}

}  // namespace

SideFactors widened(const SideFactors& fine, int stride, double downstream) {
  const std::array<double, 4> shares = wide_patch_shares(downstream);
  const int last = downstream > 0.0 ? 2 : 1;
  const int reach = (fine.phi_reach - last) / stride;
  SideFactors coarse{.phi_reach = reach, .values = Eigen::MatrixXcd::Zero(2 * reach + 1, fine.values.cols())};
  for (int j = -reach; j <= reach; ++j) {
    for (int offset = -1; offset <= last; ++offset) {
      coarse.values.row(j + reach) +=
          shares[static_cast<std::size_t>(offset + 1)] * fine.values.row(stride * j + offset + fine.phi_reach);
    }
  }
  return coarse;
}

MatrixXd shares_of_samples(const Eigen::ArrayXd& sampled, const Eigen::ArrayXd& orders) {
  const Index knots = sampled.size() - 1;
  const double last = std::log(sampled[knots]);
  const double distance = last / static_cast<double>(knots - 1);
  const MatrixXd bends = spline_bends(knots, distance);
  MatrixXd shares = MatrixXd::Zero(orders.size(), sampled.size());
  for (Index row = 0; row < orders.size(); ++row) {
    if (orders[row] == 0.0) {
      shares(row, 0) = 1.0;
      continue;
    }
    const double place = std::clamp(std::log(orders[row]), 0.0, last);
    const Index knot = std::min(static_cast<Index>(place / distance), knots - 2);
    const double right = place / distance - static_cast<double>(knot);
    const double left = 1.0 - right;
    auto share = shares.row(row).tail(knots);
    share = distance * distance / 6.0 *
            ((left * left - 1.0) * left * bends.row(knot) + (right * right - 1.0) * right * bends.row(knot + 1));
    share[knot] += left;
    share[knot + 1] += right;
    share *= std::min(1.0, sampled[knots] / orders[row]);
  }
  return shares;
}

Eigen::VectorXcd outer_softness(const HarmonicBody& body) {
  Eigen::VectorXcd smallest(static_cast<Index>(body.orders().size()));
  for (Index i = 0; i < smallest.size(); ++i) smallest[i] = 1.0 / body.outer_modulus(static_cast<std::size_t>(i));
  return smallest;
}

SideSum::SideSum(std::shared_ptr<const SampledDifference> difference, std::vector<OrderBand> bands,
                 const Eigen::VectorXcd& smallest, const MeshOnBody& mesh)
    : difference_(std::move(difference)), bands_(std::move(bands)), mesh_(mesh) {
  Index first = 0;
  for (const OrderBand& band : bands_) {
    const Eigen::VectorXcd factors =
        smallest.segment(first, band.orders.size()).array() * (band.weights / (2.0 * std::numbers::pi));
    shares_.emplace_back(factors.asDiagonal() * shares_of_samples(difference_->orders, band.orders).cast<cplx>());
    first += band.orders.size();
  }
}

SideFactors SideSum::factors(const SideRequest& request) const {
  const int reach = request.phi_reach;
  const Index samples = difference_->orders.size();
  SideFactors factors{.phi_reach = reach, .values = Eigen::MatrixXcd::Zero(2 * reach + 1, samples)};
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const OrderBand& band = bands_[b];
    const int band_reach = std::min(reach, band.reach);
    Eigen::VectorXcd received(band.orders.size());
    for (Index i = 0; i < received.size(); ++i) {
      const double m = band.orders[i];
      const double patch = sinc(0.5 * m * mesh_.phi_spacing());
      received[i] = patch * (request.power ? cplx(0.0, mesh_.turns() * m * patch)
                                           : std::polar(1.0, m * mesh_.phi_spacing() * request.phi_shift));
    }
    const Eigen::MatrixXcd summand = received.asDiagonal() * shares_[b];
    const Waves waves = make_waves(band.orders, mesh_.phi_spacing(), band_reach);
    const Eigen::MatrixXcd even = waves.cosines.transpose().cast<cplx>() * summand;
    const Eigen::MatrixXcd odd = waves.sines.transpose().cast<cplx>() * (cplx(0.0, 1.0) * summand);
    factors.values.middleRows(reach, band_reach + 1) += even + odd;
    if (band_reach == 0) continue;
    factors.values.middleRows(reach - band_reach, band_reach) +=
        (even - odd).bottomRows(band_reach).colwise().reverse();
  }
  return factors;
}

}  // namespace viscoroll::detail

#include "modal/measured_moduli.hpp"

#include <cmath>
#include <utility>

#include "modal/harmonic_moduli.hpp"

namespace viscoroll::detail {
namespace {

/// Relative error of an interpolated modulus, that of the series of compliances.
constexpr double kModulusTolerance = 1e-13;

}  // namespace

std::optional<MeasuredModuli> MeasuredModuli::try_make(const HarmonicBody& body, std::span<const std::size_t> orders,
                                                       int max_terms) {
  const std::vector<std::size_t> layers = measured_layers(body.body().layers);
  const auto count = static_cast<Eigen::Index>(orders.size());
  MeasuredModuli moduli;
  moduli.lowest_m_ = body.orders()[orders.front()];
  moduli.highest_m_ = body.orders()[orders.back()];
  moduli.layers_ = static_cast<Eigen::Index>(layers.size());

  Eigen::ArrayXd points(count);
  Eigen::ArrayXXcd rest(count, moduli.layers_);  // moduli minus polynomials
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t order = orders[static_cast<std::size_t>(i)];
    points[i] = moduli.coordinate(body.orders()[order]);
    for (Eigen::Index l = 0; l < moduli.layers_; ++l) {
      rest(i, l) = body.modulus(layers[static_cast<std::size_t>(l)], order);
    }
  }
  const Eigen::ArrayXXd limit = kModulusTolerance * rest.abs();
  Eigen::ArrayXd product = Eigen::ArrayXd::Ones(count);  // product of twice the distances to the nodes
  while (!(rest.abs() <= limit).all()) {
    Eigen::Index node = 0;
    if (std::cmp_equal(moduli.nodes_.size(), max_terms) || product.abs().maxCoeff(&node) == 0.0) return {};
    moduli.nodes_.push_back(points[node]);
    moduli.coefficients_.emplace_back(rest.row(node).transpose() / product[node]);
    rest -= (product.matrix().cast<std::complex<double>>() * moduli.coefficients_.back().matrix().transpose()).array();
    product *= 2.0 * (points - points[node]);
  }
  return moduli;
}

Eigen::ArrayXXcd MeasuredModuli::at(std::span<const double> orders) const {
  Eigen::ArrayXXcd moduli(static_cast<Eigen::Index>(orders.size()), layers_);
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const double x = coordinate(orders[i]);
    Eigen::ArrayXcd sum = Eigen::ArrayXcd::Zero(layers_);
    for (std::size_t j = nodes_.size(); j-- > 0;) sum = coefficients_[j] + 2.0 * (x - nodes_[j]) * sum;
    moduli.row(static_cast<Eigen::Index>(i)) = sum.transpose();
  }
  return moduli;
}

double MeasuredModuli::coordinate(double m) const {
  if (highest_m_ == lowest_m_) return 0.0;
  return 2.0 * std::log(m / lowest_m_) / std::log(highest_m_ / lowest_m_) - 1.0;
}

}  // namespace viscoroll::detail

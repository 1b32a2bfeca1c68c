#include "modal/harmonic_moduli.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <variant>
#include <vector>

#include "modal/chebyshev_panels.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Order below a limit that replaces a given order: nearly the same for low orders, and approaching the limit smoothly
/// for high ones, so that series in ln m converge fast.
double limited(double order, double limit) { return order / std::pow(1.0 + std::pow(order / limit, 4), 0.25); }

}  // namespace

bool is_measured(const ShearModulus& modulus) {
  return std::holds_alternative<MasterCurve>(modulus) || std::holds_alternative<CustomModulus>(modulus);
}

bool is_lossless(const ShearModulus& modulus) {
  struct Visitor {
    static bool are_zero(const std::vector<double>& values) {
      return std::ranges::all_of(values, [](double value) { return value == 0.0; });
    }
    bool operator()(const Elastic& /*spring*/) const { return true; }
    bool operator()(const Prony& series) const { return are_zero(series.weights); }
    bool operator()(const KelvinVoigt& solid) const { return solid.viscosity == 0.0; }
    bool operator()(const FractionalZener& solid) const { return solid.instantaneous_modulus == solid.relaxed_modulus; }
    bool operator()(const HavriliakNegami& solid) const { return solid.instantaneous_modulus == solid.relaxed_modulus; }
    bool operator()(const MasterCurve& table) const { return are_zero(table.loss); }
    bool operator()(const CustomModulus& /*function*/) const { return false; }
  };
  return std::visit(Visitor{}, modulus);
}

std::vector<std::size_t> measured_layers(const std::vector<Layer>& layers) {
  std::vector<std::size_t> measured;
  for (std::size_t j = 0; j < layers.size(); ++j) {
    if (is_measured(layers[j].shear_modulus)) measured.push_back(j);
  }
  return measured;
}

std::vector<std::vector<cplx>> harmonic_moduli(const std::vector<Layer>& layers, double angular_speed,
                                               const std::vector<double>& orders, double measured_order) {
  std::vector<std::vector<cplx>> moduli;
  std::vector<double> omega(orders.size());
  for (const Layer& layer : layers) {
    const bool measured = is_measured(layer.shear_modulus);
    std::ranges::transform(orders, omega.begin(),
                           [&](double m) { return angular_speed * (measured ? limited(m, measured_order) : m); });
    moduli.push_back(modulus_in_rolling(layer.shear_modulus, angular_speed, omega));
  }
  return moduli;
}

std::vector<std::vector<cplx>> resampled_moduli(const std::vector<Layer>& layers, double angular_speed,
                                                const std::vector<double>& orders, const Eigen::ArrayXXcd& measured) {
  std::vector<double> omega(orders.size());
  std::ranges::transform(orders, omega.begin(), [&](double m) { return m * angular_speed; });
  std::vector<std::vector<cplx>> moduli;
  moduli.reserve(layers.size());
  Eigen::Index column = 0;
  for (const Layer& layer : layers) {
    if (is_measured(layer.shear_modulus)) {
      const auto values = measured.col(column++);
      moduli.emplace_back(values.begin(), values.end());
    } else {
      moduli.push_back(modulus_in_rolling(layer.shear_modulus, angular_speed, omega));
    }
  }
  return moduli;
}

double highest_frequency(double angular_speed, const std::vector<double>& orders, double measured_order) {
  const double highest = orders.empty() ? 0.0 : std::ranges::max(orders);
  return angular_speed * std::max(1.0, limited(highest, measured_order));
}

double highest_kink(const ShearModulus& modulus, double low, double high) {
  constexpr double kTolerance = 1e-8;
  constexpr int kUnused = 4;  // number of last terms that must be negligible
  if (!(low < high)) return 0.0;
  const double ratio = std::min(2.0, high / low);
  std::vector<double> frequencies;
  std::vector<double> ends;
  // The octaves overlap by half, because a kink may lie on the border of an octave.
  for (double end = high; ends.empty() || end * std::numbers::sqrt2 > low * ratio; end /= std::numbers::sqrt2) {
    ends.push_back(std::max(end, low * ratio));
    std::ranges::copy(panel_nodes(ends.back() / ratio, ends.back()), std::back_inserter(frequencies));
  }
  std::vector<std::complex<double>> moduli;
  try {
    moduli = complex_modulus(modulus, frequencies);
  } catch (const std::invalid_argument&) {
    return high;  // the evaluation at the orders later reports the frequency without a value
  }
  for (std::size_t octave = 0; octave < ends.size(); ++octave) {
    const Eigen::Map<const Eigen::RowVectorXcd> values(moduli.data() + octave * kPanelNodes, kPanelNodes);
    const Eigen::RowVectorXcd series = values * panel_transform();
    if (series.tail(kUnused).cwiseAbs().maxCoeff() > kTolerance * values.cwiseAbs().maxCoeff()) return ends[octave];
  }
  return 0.0;
}

}  // namespace viscoroll::detail

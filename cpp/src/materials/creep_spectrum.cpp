#include "materials/creep_spectrum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>

#include "base/dense_solvers.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Terms of a Prony series by ascending time; terms of equal times are merged.
std::vector<std::pair<double, double>> merged_terms(const Prony& series) {
  constexpr double kSame = 1e-12;
  std::vector<std::pair<double, double>> terms;  // (time, weight)
  terms.reserve(series.weights.size());
  for (std::size_t k = 0; k < series.weights.size(); ++k) {
    if (series.weights[k] > 0.0) terms.emplace_back(series.relaxation_times[k], series.weights[k]);
  }
  std::ranges::sort(terms);
  std::vector<std::pair<double, double>> merged;
  for (const auto& term : terms) {
    if (!merged.empty() && term.first <= merged.back().first * (1.0 + kSame)) {
      merged.back().second += term.second;
    } else {
      merged.push_back(term);
    }
  }
  return merged;
}

/// Secular equation sum g_k / (1 - tau_k / lambda) = 1, whose roots interlace with the relaxation times.
class SecularEquation {
 public:
  explicit SecularEquation(std::vector<std::pair<double, double>> terms) : terms_(std::move(terms)) {}

  /// Root as its distance, in ln(lambda), from one of the relaxation times, which keeps the digits of close pairs.
  struct Root {
    std::size_t origin;
    double distance;
  };

  [[nodiscard]] Root root_above(std::size_t k, double equilibrium) const {
    const double width =
        k + 1 < terms_.size()
            ? std::log(terms_[k + 1].first / terms_[k].first)
            : std::log1p(std::transform_reduce(terms_.begin(), terms_.end(), 0.0, std::plus<>(),
                                               [](const auto& term) { return term.first * term.second; }) /
                         (equilibrium * terms_[k].first));
    const bool lower_half = k + 1 == terms_.size() || value({k, 0.5 * width}) < 0.0;
    const std::size_t origin = lower_half ? k : k + 1;
    const double sign = lower_half ? 1.0 : -1.0;
    double near = 1e-17 * width;
    double far = lower_half && k + 1 == terms_.size() ? width : 0.5 * width;
    while (far > near * (1.0 + 1e-15)) {
      const double middle = std::sqrt(near * far);
      if (middle <= near || middle >= far) break;
      ((sign * value({origin, sign * middle}) > 0.0) ? near : far) = middle;
    }
    return {.origin = origin, .distance = sign * far};
  }

  [[nodiscard]] double time(const Root& root) const { return terms_[root.origin].first * std::exp(root.distance); }

  /// lambda_j / sum g_k tau_k / (1 - tau_k / lambda_j)^2, in units of 1/G_0
  [[nodiscard]] double weight(const Root& root) const {
    double sum = 0.0;
    for (const auto& [tau, g] : terms_) sum += g * tau / std::pow(excess(tau, root), 2);
    return time(root) / sum;
  }

 private:
  /// 1 - tau / lambda
  [[nodiscard]] double excess(double tau, const Root& root) const {
    return -std::expm1(std::log(tau / terms_[root.origin].first) - root.distance);
  }

  [[nodiscard]] double value(const Root& root) const {
    double sum = -1.0;
    for (const auto& [tau, g] : terms_) sum += g / excess(tau, root);
    return sum;
  }

  std::vector<std::pair<double, double>> terms_;
};

CreepSpectrum spectrum_of(const Prony& series) {
  const auto terms = merged_terms(series);
  const double equilibrium = 1.0 - std::accumulate(series.weights.begin(), series.weights.end(), 0.0);
  CreepSpectrum spectrum{.instantaneous = equilibrium};
  const SecularEquation equation(terms);
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const auto root = equation.root_above(k, equilibrium);
    spectrum.weights.push_back(equilibrium * equation.weight(root));
    spectrum.retardation_times.push_back(equation.time(root));
  }
  return spectrum;
}

/// Spectrum of terms that are resolved in a range of times. Faster terms join the instantaneous compliance, and slower
/// terms form one term that practically does not relax.
class RangedSpectrum {
 public:
  RangedSpectrum(double instantaneous, const TimeRange& range) : range_(range) {
    spectrum_.instantaneous = instantaneous;
  }

  void add(double weight, double time) {
    if (time < range_.shortest / kMargin) {
      spectrum_.instantaneous += weight;
    } else if (time > range_.longest * kMargin) {
      slow_ += weight;
    } else {
      spectrum_.weights.push_back(weight);
      spectrum_.retardation_times.push_back(time);
    }
  }

  [[nodiscard]] CreepSpectrum finished() {
    if (slow_ > 0.0) {
      spectrum_.weights.push_back(slow_);
      spectrum_.retardation_times.push_back(kMargin * kMargin * range_.longest);
    }
    return std::move(spectrum_);
  }

 private:
  static constexpr double kMargin = 10.0;
  TimeRange range_;
  CreepSpectrum spectrum_;
  double slow_ = 0.0;
};

/// Spacing in ln(lambda) at which the trapezoidal rule for the Cole-Cole function is exact to 1e-6: its poles lie pi (1
/// - alpha) / alpha off the axis.
double cole_cole_spacing(double order) {
  constexpr double kDigits = 13.8;  // -ln 1e-6
  return std::min(2.0 * std::pow(std::numbers::pi, 2) * (1.0 - order) / (order * kDigits), 1.0);
}

/// Distribution of the retardation times of 1 / (1 + (s tau)^alpha): K. S. Cole and R. H. Cole, J. Chem. Phys. 9 (1941)
/// 341-351.
CreepSpectrum cole_cole_spectrum(const FractionalZener& solid, const TimeRange& range) {
  const double alpha = solid.order;
  const double share = solid.relaxed_modulus / solid.instantaneous_modulus;
  const double center = solid.relaxation_time * std::pow(1.0 / share, 1.0 / alpha);
  const double spacing = cole_cole_spacing(alpha);
  const auto last = static_cast<int>(std::ceil(40.0 / (alpha * spacing)));
  std::vector<double> density;
  for (int i = -last; i <= last; ++i) {
    density.push_back(std::sin(alpha * std::numbers::pi) /
                      (std::cosh(alpha * spacing * i) + std::cos(alpha * std::numbers::pi)));
  }
  const double total = std::accumulate(density.begin(), density.end(), 0.0);
  RangedSpectrum spectrum(share, range);
  for (int i = -last; i <= last; ++i) {
    spectrum.add((1.0 - share) * density[static_cast<std::size_t>(i + last)] / total, center * std::exp(spacing * i));
  }
  return spectrum.finished();
}

std::vector<double> log_spaced(double low, double high, double per_decade) {
  const auto count = static_cast<int>(std::ceil(per_decade * std::log10(high / low))) + 1;
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    values.push_back(low * std::pow(high / low, i / std::max(1.0, count - 1.0)));
  }
  return values;
}

/// Angular frequencies of a fit: all that a motion with times in the range can excite.
std::vector<double> fitted_frequencies(const ShearModulus& modulus, const TimeRange& range) {
  constexpr double kPerDecade = 8.0;
  double low = 0.1 / range.longest;
  double high = 10.0 / range.shortest;
  if (const auto* curve = std::get_if<MasterCurve>(&modulus)) {
    const auto first = std::ranges::find_if(curve->frequency, [](double w) { return w > 0.0; });
    if (curve->extrapolation == Extrapolation::error) {
      low = std::max(low, *first);
      high = std::min(high, curve->frequency.back());
      if (low >= high) std::tie(low, high) = std::pair(*first, curve->frequency.back());
    }
  }
  return log_spaced(low, high, kPerDecade);
}

/// Nonnegative least squares of the relative compliance: real and imaginary parts at all frequencies, and its relaxed
/// value.
CreepSpectrum fitted_spectrum(const ShearModulus& modulus, const TimeRange& range) {
  constexpr double kTimesPerDecade = 6.0;
  const std::vector<double> frequencies = fitted_frequencies(modulus, range);
  const std::vector<double> times = log_spaced(0.01 / frequencies.back(), 100.0 / frequencies.front(), kTimesPerDecade);
  const auto values = complex_modulus(modulus, frequencies);
  const double relaxed = complex_modulus(modulus, std::array{0.0}).front().real();

  const auto rows = static_cast<Eigen::Index>(frequencies.size());
  Eigen::MatrixXcd terms(rows + 1, static_cast<Eigen::Index>(times.size()) + 1);
  for (Eigen::Index i = 0; i <= rows; ++i) {
    const double omega = i < rows ? frequencies[static_cast<std::size_t>(i)] : 0.0;
    const cplx stiffness = i < rows ? values[static_cast<std::size_t>(i)] / relaxed : 1.0;  // makes errors relative
    terms(i, 0) = stiffness;
    for (Eigen::Index j = 1; j < terms.cols(); ++j) {
      terms(i, j) = stiffness / cplx(1.0, omega * times[static_cast<std::size_t>(j - 1)]);
    }
  }
  Eigen::MatrixXd matrix(2 * terms.rows(), terms.cols());
  matrix << terms.real(), terms.imag();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix.rows());
  right.head(terms.rows()).setOnes();
  const Eigen::VectorXd weights = nonnegative_least_squares(matrix, right);

  const Eigen::VectorXcd compliance = terms * weights.cast<cplx>();
  RangedSpectrum spectrum(weights[0], {.shortest = 0.1 * times.front(), .longest = 10.0 * times.back()});
  for (Eigen::Index j = 1; j < weights.size(); ++j) {
    if (weights[j] > 0.0) spectrum.add(weights[j], times[static_cast<std::size_t>(j - 1)]);
  }
  CreepSpectrum result = spectrum.finished();
  result.error = (compliance.array() - 1.0).abs().maxCoeff();
  return result;
}

CreepSpectrum zener_spectrum(const FractionalZener& solid, const TimeRange& range) {
  constexpr double kFinestSpacing = 0.2;  // finer: a narrow peak, which few fitted times represent better
  if (solid.order == 1.0) {
    return spectrum_of(
        standard_linear_solid(solid.instantaneous_modulus, solid.relaxed_modulus, solid.relaxation_time));
  }
  if (solid.instantaneous_modulus == solid.relaxed_modulus) return {};
  if (cole_cole_spacing(solid.order) >= kFinestSpacing) return cole_cole_spectrum(solid, range);
  return fitted_spectrum(solid, range);
}

}  // namespace

CreepSpectrum creep_spectrum(const ShearModulus& modulus, const TimeRange& range) {
  validate(modulus);
  if (std::holds_alternative<Elastic>(modulus)) return {};
  if (const auto* series = std::get_if<Prony>(&modulus)) return spectrum_of(*series);
  if (const auto* solid = std::get_if<KelvinVoigt>(&modulus)) {
    if (solid->viscosity == 0.0) return {};
    return {.instantaneous = 0.0, .weights = {1.0}, .retardation_times = {solid->viscosity / solid->modulus}};
  }
  if (const auto* solid = std::get_if<FractionalZener>(&modulus)) return zener_spectrum(*solid, range);
  return fitted_spectrum(modulus, range);
}

double difference(const CreepSpectrum& a, const CreepSpectrum& b) {
  const auto creep = [](const CreepSpectrum& spectrum, double time) {
    double value = spectrum.instantaneous;
    for (std::size_t j = 0; j < spectrum.size(); ++j) {
      value -= spectrum.weights[j] * std::expm1(-time / spectrum.retardation_times[j]);
    }
    return value;
  };
  double largest = 0.0;
  for (const auto* spectrum : {&a, &b}) {
    for (const double time : spectrum->retardation_times) {
      largest = std::max(largest, std::abs(creep(a, time) - creep(b, time)));
    }
  }
  return largest;
}

}  // namespace viscoroll::detail

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "base/validate.hpp"
#include "materials/master_curve.hpp"
#include "viscoroll/materials.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll {
namespace {

using detail::reject;
using detail::require_in;
using detail::require_nonnegative;
using detail::require_positive;
using detail::text;
using cplx = std::complex<double>;

std::string joined(std::string_view prefix, std::string_view name) { return std::string(prefix) + std::string(name); }

/// Largest sum of weights. The weights of a fit may exceed 1 by round-off.
constexpr double kLargestSum = 1.0 + 1e-12;

double weight_sum(const Prony& m) { return std::accumulate(m.weights.begin(), m.weights.end(), 0.0); }

struct Validator {
  std::string_view prefix;

  void operator()(const Elastic& m) const { require_positive(joined(prefix, "modulus"), m.modulus, "Pa"); }

  void operator()(const Prony& m) const {
    require_positive(joined(prefix, "instantaneous_modulus"), m.instantaneous_modulus, "Pa");
    if (m.relaxation_times.size() != m.weights.size()) {
      reject(joined(prefix, "relaxation_times"), "as many as weights (" + std::to_string(m.weights.size()) + ")",
             std::to_string(m.relaxation_times.size()));
    }
    for (std::size_t k = 0; k < m.weights.size(); ++k) {
      const std::string index = "[" + std::to_string(k) + "]";
      if (!(m.weights[k] >= 0.0 && m.weights[k] <= kLargestSum)) {
        reject(joined(prefix, "weights") + index, Range{.minimum = 0.0, .maximum = 1.0}, m.weights[k]);
      }
      require_positive(joined(prefix, "relaxation_times") + index, m.relaxation_times[k], "s");
    }
    if (!(weight_sum(m) <= kLargestSum)) {
      reject(joined(prefix, "weights"),
             "such that their sum is <= 1 (the remainder is the relaxed fraction of the modulus)", weight_sum(m));
    }
  }

  void operator()(const KelvinVoigt& m) const {
    require_positive(joined(prefix, "modulus"), m.modulus, "Pa");
    require_nonnegative(joined(prefix, "viscosity"), m.viscosity, "Pa s");
  }

  void operator()(const FractionalZener& m) const { check_dispersion(m); }

  void operator()(const HavriliakNegami& m) const {
    check_dispersion(m);
    require_fraction(joined(prefix, "asymmetry"), m.asymmetry);
  }

  void operator()(const MasterCurve& m) const { detail::validate_table(m, prefix); }

  void operator()(const CustomModulus& m) const {
    if (!m.evaluate) reject(joined(prefix, "evaluate"), "a function", "none");
  }

 private:
  static void require_fraction(const std::string& name, double value) {
    require_in({.minimum = 0.0, .maximum = 1.0, .excludes_minimum = true}, name, value);
  }

  template <class Solid>
  void check_dispersion(const Solid& m) const {
    require_positive(joined(prefix, "relaxed_modulus"), m.relaxed_modulus, "Pa");
    if (!(std::isfinite(m.instantaneous_modulus) && m.instantaneous_modulus >= m.relaxed_modulus)) {
      reject(joined(prefix, "instantaneous_modulus"), ">= relaxed_modulus = " + text(m.relaxed_modulus) + " Pa",
             m.instantaneous_modulus, Range{.unit = "Pa", .minimum = m.relaxed_modulus});
    }
    require_positive(joined(prefix, "relaxation_time"), m.relaxation_time, "s");
    require_fraction(joined(prefix, "order"), m.order);
  }
};

struct Evaluator {
  std::span<const double> omega;
  std::span<cplx> modulus;

  template <class Function>
  void fill(const Function& mu) const {
    for (std::size_t i = 0; i < omega.size(); ++i) modulus[i] = mu(omega[i]);
  }

  void operator()(const Elastic& m) const {
    fill([&](double) { return cplx(m.modulus); });
  }

  void operator()(const Prony& m) const {
    const double equilibrium = std::max(0.0, 1.0 - weight_sum(m));
    fill([&](double w) {
      cplx sum = equilibrium;
      for (std::size_t k = 0; k < m.weights.size(); ++k) {
        const double wt = w * m.relaxation_times[k];
        // i wt / (1 + i wt) = wt (wt + i) / (1 + wt^2); the second form avoids the overflow of wt^2
        sum += wt < 1e100 ? m.weights[k] * wt / (1.0 + wt * wt) * cplx(wt, 1.0) : cplx(m.weights[k], m.weights[k] / wt);
      }
      return m.instantaneous_modulus * sum;
    });
  }

  void operator()(const KelvinVoigt& m) const {
    fill([&](double w) { return cplx(m.modulus, w * m.viscosity); });
  }

  void operator()(const FractionalZener& m) const {
    const double half_pi = std::acos(0.0);
    fill([&](double w) {
      const double size = std::pow(w * m.relaxation_time, m.order);
      if (size > 1e100) return cplx(m.instantaneous_modulus);
      const cplx power = std::polar(size, half_pi * m.order);  // (i w tau)^alpha
      return m.relaxed_modulus + (m.instantaneous_modulus - m.relaxed_modulus) * (power / (1.0 + power));
    });
  }

  void operator()(const HavriliakNegami& m) const {
    const double half_pi = std::acos(0.0);
    fill([&](double w) {
      const double log_size = m.order * (std::log(w) + std::log(m.relaxation_time));
      const double size = std::exp(log_size);
      const cplx power = std::polar(size, half_pi * m.order);  // (i w tau)^alpha
      // ln(1 + power) and 1 - 1 / (1 + power)^beta, without cancellation where the power is small
      const cplx log = size < 1e100 ? cplx(0.5 * std::log1p(2.0 * power.real() + size * size), std::arg(1.0 + power))
                                    : cplx(log_size, half_pi * m.order);
      const cplx exponent = -m.asymmetry * log;
      const double half_sine = std::sin(0.5 * exponent.imag());
      const cplx risen(2.0 * half_sine * half_sine - std::expm1(exponent.real()) * std::cos(exponent.imag()),
                       -std::exp(exponent.real()) * std::sin(exponent.imag()));
      return m.relaxed_modulus + (m.instantaneous_modulus - m.relaxed_modulus) * risen;
    });
  }

  void operator()(const MasterCurve& m) const {
    fill([&](double w) { return detail::interpolate(m, w); });
  }

  void operator()(const CustomModulus& m) const { m.evaluate(omega, modulus); }
};

/// Check that a modulus is finite, has a positive storage modulus, and is passive.
void require_passive(double omega, cplx mu) {
  const std::string where = "shear_modulus at " + text(omega) + " rad/s";
  if (!(std::isfinite(mu.real()) && std::isfinite(mu.imag()))) {
    reject(where, "finite", text(mu.real()) + (mu.imag() < 0 ? " - " : " + ") + text(std::abs(mu.imag())) + "i Pa");
  }
  if (!(mu.real() > 0.0))
    reject(where, "such that the storage modulus is > 0 Pa", mu.real(),
           Range{.unit = "Pa", .minimum = 0.0, .excludes_minimum = true});
  // A negative loss modulus of the size of round-off belongs to a material without loss.
  if (mu.imag() < -1e-12 * mu.real()) reject(where, "passive, such that the loss modulus is >= 0 Pa", mu.imag());
}

}  // namespace

Prony standard_linear_solid(double instantaneous_modulus, double relaxed_modulus, double relaxation_time) {
  require_positive("instantaneous_modulus", instantaneous_modulus, "Pa");
  require_positive("relaxed_modulus", relaxed_modulus, "Pa");
  require_positive("relaxation_time", relaxation_time, "s");
  if (relaxed_modulus > instantaneous_modulus) {
    reject("relaxed_modulus", "<= instantaneous_modulus = " + text(instantaneous_modulus) + " Pa", relaxed_modulus,
           Range{.unit = "Pa", .maximum = instantaneous_modulus});
  }
  // At lower ratios, round-off of the stored weight, 1 - ratio, leaves fewer than four digits of the modulus.
  constexpr double kSmallestRatio = 1e-12;
  if (relaxed_modulus < kSmallestRatio * instantaneous_modulus) {
    reject("relaxed_modulus",
           ">= " + text(kSmallestRatio) + " instantaneous_modulus = " + text(kSmallestRatio * instantaneous_modulus) +
               " Pa",
           relaxed_modulus, Range{.unit = "Pa", .minimum = kSmallestRatio * instantaneous_modulus});
  }
  if (relaxed_modulus == instantaneous_modulus) return {.instantaneous_modulus = instantaneous_modulus};
  return {.instantaneous_modulus = instantaneous_modulus,
          .weights = {1.0 - relaxed_modulus / instantaneous_modulus},
          .relaxation_times = {relaxation_time}};
}

void validate(const ShearModulus& modulus, std::string_view prefix) { std::visit(Validator{prefix}, modulus); }

std::vector<cplx> complex_modulus(const ShearModulus& modulus, std::span<const double> omega) {
  validate(modulus);
  for (const double w : omega) {
    detail::require_in({.unit = "rad/s", .minimum = 0.0}, "omega", w);
  }
  // An entry that a custom function does not write stays NaN, which `require_passive` rejects.
  std::vector<cplx> mu(omega.size(), cplx(std::numeric_limits<double>::quiet_NaN()));
  std::visit(Evaluator{omega, mu}, modulus);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    require_passive(omega[i], mu[i]);
    if (omega[i] == 0.0) mu[i] = mu[i].real();  // since mu*(-w) = conj mu*(w), there is no loss at rest
  }
  return mu;
}

double short_time_modulus(const ShearModulus& modulus, double highest_frequency) {
  require_positive("highest_frequency", highest_frequency, "rad/s");
  if (const auto* m = std::get_if<KelvinVoigt>(&modulus)) {
    return m->viscosity > 0.0 ? std::numeric_limits<double>::infinity() : m->modulus;
  }
  if (const auto* m = std::get_if<Prony>(&modulus)) return m->instantaneous_modulus;
  if (const auto* m = std::get_if<FractionalZener>(&modulus)) return m->instantaneous_modulus;
  if (const auto* m = std::get_if<HavriliakNegami>(&modulus)) return m->instantaneous_modulus;
  if (const auto* m = std::get_if<MasterCurve>(&modulus)) return m->storage.back();
  return complex_modulus(modulus, std::span(&highest_frequency, 1)).front().real();
}

}  // namespace viscoroll

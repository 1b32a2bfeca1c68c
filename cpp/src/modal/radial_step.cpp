#include "modal/radial_step.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kMaxTerms = 80;        // steps are short enough for 40
constexpr double kRoundOff = 1e-17;  // of a term that is left out, relative to the sum

/// Rate of one solution without inertia, less j times the solution: what the series of the next term starts from.
template <class Scalar>
VISCOROLL_PART_OF_CALLER void elastic_rate(const StepLanes<Scalar>& step, const SolutionLanes<Scalar>& z, double j,
                                           SolutionLanes<Scalar>& rate) {
  for (std::size_t l = 0; l < kLanes; ++l) {
    const double k = step.k[l];
    const auto u = z[0][l];
    const auto v_k = z[1][l];
    const auto v_x = z[2][l];
    const auto s = z[3][l];
    const auto tau_k = z[4][l];
    const auto tau_x = z[5][l];
    const auto t = k * v_k - 2.0 * u;
    const auto bt = step.b[l] * t;
    const auto bs = step.b[l] * s;
    const auto gamma_t = 3.0 * t - 4.0 * bt;
    rate[0].set(l, t - 2.0 * bt + bs - j * u);
    rate[1].set(l, (1.0 - j) * v_k - k * u + tau_k);
    rate[2].set(l, (1.0 - j) * v_x + tau_x);
    rate[3].set(l, k * tau_k - 2.0 * gamma_t + (1.0 - j) * s - 4.0 * bs);
    rate[4].set(l, k * (gamma_t - s + 2.0 * bs) + step.membrane[l] * v_k - (2.0 + j) * tau_k);
    rate[5].set(l, step.membrane[l] * v_x - (2.0 + j) * tau_x);
  }
}

/// Displacements of a solution, for the terms of inertia.
template <class Scalar>
using DisplacementLanes = std::array<Lanes<Scalar>, 3>;

/// q M (t_j + 2 x t_{j-1} + x^2 t_{j-2}) of the displacements, added to the rates of the stresses.
template <class Scalar>
VISCOROLL_PART_OF_CALLER void add_inertia(const StepLanes<Scalar>& step, const SolutionLanes<Scalar>& z,
                                          DisplacementLanes<Scalar>& before, DisplacementLanes<Scalar>& before_that,
                                          SolutionLanes<Scalar>& rate) {
  const auto& mass = step.inertia;
  for (std::size_t l = 0; l < kLanes; ++l) {
    const double x = step.growth[l];
    const auto q = step.q[l];
    const auto u = z[0][l] + 2.0 * x * before[0][l] + x * x * before_that[0][l];
    const auto v_k = z[1][l] + 2.0 * x * before[1][l] + x * x * before_that[1][l];
    const auto v_x = z[2][l] + 2.0 * x * before[2][l] + x * x * before_that[2][l];
    rate[3].set(l, rate[3][l] + q * (mass.rr[l] * u + mass.rk[l] * v_k + mass.rx[l] * v_x));
    rate[4].set(l, rate[4][l] + q * (mass.rk[l] * u + mass.kk[l] * v_k + mass.kx[l] * v_x));
    rate[5].set(l, rate[5][l] + q * (mass.rx[l] * u + mass.kx[l] * v_k + mass.xx[l] * v_x));
    for (std::size_t i = 0; i < 3; ++i) {
      before_that[i].set(l, before[i][l]);
      before[i].set(l, z[i][l]);
    }
  }
}

/// Whether a term and the one before are negligible in every component, since the normal displacement of a thin
/// incompressible layer is far smaller than its neighbors; one term alone may vanish by parity.
template <class Scalar>
VISCOROLL_PART_OF_CALLER bool are_negligible(const SolutionLanes<Scalar>& last, const SolutionLanes<Scalar>& before,
                                             const SolutionLanes<Scalar>& sum) {
  std::array<double, kLanes> open{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      const double limit = kRoundOff * size(sum[i][l]);
      open[l] = size(last[i][l]) > limit ? 1.0 : open[l];
      open[l] = size(before[i][l]) > limit ? 1.0 : open[l];
    }
  }
  for (const double lane : open) {
    if (lane != 0.0) return false;
  }
  return true;
}

/// One solution at r (1 + x): (1 + x) dz/dx = (B + q (1 + x)^2 M) z gives the terms t_j = z_j x^j by
/// t_{j+1} = x / (j+1) ((B - j) t_j + q M (t_j + 2 x t_{j-1} + x^2 t_{j-2})).
template <class Scalar>
VISCOROLL_PART_OF_CALLER void sum_series(const StepLanes<Scalar>& step, SolutionLanes<Scalar>& sum) {
  SolutionLanes<Scalar> term = sum;
  SolutionLanes<Scalar> next;
  DisplacementLanes<Scalar> before{};
  DisplacementLanes<Scalar> before_that{};
  for (int j = 0; j < kMaxTerms; ++j) {
    elastic_rate(step, term, static_cast<double>(j), next);
    if (step.has_inertia) add_inertia(step, term, before, before_that, next);
    const double per_term = 1.0 / (j + 1);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t l = 0; l < kLanes; ++l) {
        next[i].set(l, per_term * step.growth[l] * next[i][l]);
        sum[i].set(l, sum[i][l] + next[i][l]);
      }
    }
    if (j % 4 == 3 && are_negligible(next, term, sum)) break;
    term = next;
  }
}

/// D F^-1 by cofactors; it is symmetric, so six entries are all.
template <class Scalar>
VISCOROLL_PART_OF_CALLER void divide(const std::array<SolutionLanes<Scalar>, 3>& z,
                                     SymmetricLanes<Scalar>& compliance) {
  for (std::size_t l = 0; l < kLanes; ++l) {
    const auto f = [&](std::size_t i, std::size_t solution) { return z[solution][3 + i][l]; };
    // Cofactor of stress i in solution p.
    const auto cofactor = [&](std::size_t i, std::size_t p) {
      const std::size_t i1 = (i + 1) % 3;
      const std::size_t i2 = (i + 2) % 3;
      const std::size_t p1 = (p + 1) % 3;
      const std::size_t p2 = (p + 2) % 3;
      return f(i1, p1) * f(i2, p2) - f(i1, p2) * f(i2, p1);
    };
    const auto c00 = cofactor(0, 0);
    const auto c01 = cofactor(0, 1);
    const auto c02 = cofactor(0, 2);
    const auto c10 = cofactor(1, 0);
    const auto c11 = cofactor(1, 1);
    const auto c12 = cofactor(1, 2);
    const auto c20 = cofactor(2, 0);
    const auto c21 = cofactor(2, 1);
    const auto c22 = cofactor(2, 2);
    const auto scale = inverse(f(0, 0) * c00 + f(0, 1) * c01 + f(0, 2) * c02);
    const auto entry = [&](std::size_t i, const auto& c0, const auto& c1, const auto& c2) {
      return scale * (z[0][i][l] * c0 + z[1][i][l] * c1 + z[2][i][l] * c2);
    };
    compliance.rr.set(l, entry(0, c00, c01, c02));
    compliance.rk.set(l, entry(0, c10, c11, c12));
    compliance.rx.set(l, entry(0, c20, c21, c22));
    compliance.kk.set(l, entry(1, c10, c11, c12));
    compliance.kx.set(l, entry(1, c20, c21, c22));
    compliance.xx.set(l, entry(2, c20, c21, c22));
  }
}

template <class Scalar>
VISCOROLL_PART_OF_CALLER void advance_all(const StepLanes<Scalar>& step,
                                          const std::array<SolutionLanes<Scalar>, 3>& start,
                                          SymmetricLanes<Scalar>& compliance) {
  std::array<SolutionLanes<Scalar>, 3> states = start;
  for (SolutionLanes<Scalar>& solution : states) sum_series(step, solution);
  divide(states, compliance);
}

}  // namespace

VISCOROLL_BEST_INSTRUCTIONS
void advance(const StepLanes<double>& step, const std::array<SolutionLanes<double>, 3>& start,
             SymmetricLanes<double>& compliance) {
  advance_all(step, start, compliance);
}

VISCOROLL_BEST_INSTRUCTIONS
void advance(const StepLanes<std::complex<double>>& step,
             const std::array<SolutionLanes<std::complex<double>>, 3>& start,
             SymmetricLanes<std::complex<double>>& compliance) {
  advance_all(step, start, compliance);
}

}  // namespace viscoroll::detail

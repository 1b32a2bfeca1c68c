#include "modal/layer_step.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kMaxTerms = 81;              // steps without short shear waves need at most 40
constexpr double kNegligibleTerm = 1e-17;  // relative size of a negligible term

/// Terms t_j = z_j x^j of a solution in one lane: t_j, t_{j-1} and t_{j-2}.
template <class Scalar>
struct Terms {
  const SolutionLanes<Scalar>& now;
  const SolutionLanes<Scalar>& before;
  const SolutionLanes<Scalar>& earlier;
  double spread;  ///< c x
  std::size_t l;

  /// Term of (1 + c x) z.
  [[nodiscard]] VISCOROLL_PART_OF_CALLER auto grown(std::size_t i) const { return now[i][l] + spread * before[i][l]; }
  /// Term of (1 + c x)^2 z.
  [[nodiscard]] VISCOROLL_PART_OF_CALLER auto grown_twice(std::size_t i) const {
    return now[i][l] + 2.0 * spread * before[i][l] + spread * spread * earlier[i][l];
  }
};

/// Derivatives (B - c j) z in the directions r, k and across k.
/// @param[in] order c j
template <class Scalar>
VISCOROLL_PART_OF_CALLER auto rates_along_k(const StepLanes<Scalar>& step, double order, const Terms<Scalar>& terms) {
  const auto& [z, before, earlier, spread, l] = terms;
  const double along = step.along;
  const double across = step.across;
  const double curved_axes = along + across;
  const double k = step.k[l];
  const auto t = k * z[1][l] - curved_axes * z[0][l];
  const auto bt = step.b[l] * t;
  const auto bs = step.b[l] * z[3][l];
  const auto gamma_t = step.area * t - 4.0 * bt;
  return std::array{t - 2.0 * bt + bs - order * z[0][l],
                    (along - order) * z[1][l] - k * z[0][l] + z[4][l],
                    (across - order) * z[2][l] + z[5][l],
                    k * z[4][l] - curved_axes * gamma_t + (along - order) * z[3][l] - 2.0 * curved_axes * bs,
                    k * (gamma_t - z[3][l] + 2.0 * bs) + step.membrane[l] * z[1][l] - (curved_axes + order) * z[4][l],
                    step.shear[l] * z[2][l] - (2.0 * across + order) * z[5][l]};
}

/// Derivatives (B - j) z in the directions r, phi and z, where kappa = kappa_0 (1 + x).
template <class Scalar>
VISCOROLL_PART_OF_CALLER auto wheel_rates(const StepLanes<Scalar>& step, double order, const Terms<Scalar>& terms) {
  const auto& [z, before, earlier, spread, l] = terms;
  const double m = step.k[l];
  const double kappa = step.kappa[l];
  const auto a_times = [&](const auto& value) { return value - 2.0 * (step.b[l] * value); };
  const auto e = m * z[1][l] - z[0][l];
  const auto kappa_v_z = kappa * terms.grown(2);
  const auto kappa_kappa_v_z = kappa * kappa * terms.grown_twice(2);
  const auto kappa_t = kappa * (m * terms.grown(1) - terms.grown(0)) + kappa_kappa_v_z;
  const auto a_t = a_times(e + kappa_v_z);
  const auto a_s = a_times(z[3][l]);
  return std::array{
      a_t + step.b[l] * z[3][l] - order * z[0][l],
      (1.0 - order) * z[1][l] - m * z[0][l] + z[4][l],
      z[5][l] - kappa * terms.grown(0) - order * z[2][l],
      a_s + m * z[4][l] + kappa * terms.grown(5) - 2.0 * (a_t + e) - order * z[3][l],
      m * (2.0 * (a_t + e) - a_s) + kappa * kappa * terms.grown_twice(1) + m * kappa_v_z - (1.0 + order) * z[4][l],
      2.0 * (a_times(kappa_t) + kappa_kappa_v_z) - kappa * a_times(terms.grown(3)) + m * kappa * terms.grown(1) +
          m * m * z[2][l] - order * z[5][l]};
}

/// Compute the next term of a solution and add it to the sum.
///
/// The terms t_j = z_j x^j of the solution of (1 + c x) dz/dx = (B + q (1 + c x)^2 M) z follow from the recursion
/// t_{j+1} = x / (j+1) ((B - c j) t_j + q M (t_j + 2 c x t_{j-1} + (c x)^2 t_{j-2})). On a wheel, the terms of B that
/// grow with the radius are treated in the same way.
/// @param[in] now,before t_j and t_{j-1}
/// @param[in,out] next t_{j-2}, replaced by t_{j+1}
template <bool IsWheel, bool HasInertia, class Scalar>
VISCOROLL_PART_OF_CALLER void add_term(const StepLanes<Scalar>& step, int j, const SolutionLanes<Scalar>& now,
                                       const SolutionLanes<Scalar>& before, SolutionLanes<Scalar>& next,
                                       SolutionLanes<Scalar>& sum) {
  const double share = 1.0 / (j + 1.0);
  const double order = step.along * j;
  for (std::size_t l = 0; l < kLanes; ++l) {
    const double x = step.growth[l];
    const Terms<Scalar> terms{now, before, next, step.along * x, l};
    auto rates = [&] {
      if constexpr (IsWheel) {
        return wheel_rates(step, order, terms);
      } else {
        return rates_along_k(step, order, terms);
      }
    }();
    if constexpr (HasInertia) {
      const auto& mass = step.inertia;
      const auto q = step.q[l];
      const auto u = terms.grown_twice(0);
      const auto v_k = terms.grown_twice(1);
      const auto v_x = terms.grown_twice(2);
      rates[3] = rates[3] + q * (mass.rr[l] * u + mass.rk[l] * v_k + mass.rx[l] * v_x);
      rates[4] = rates[4] + q * (mass.rk[l] * u + mass.kk[l] * v_k + mass.kx[l] * v_x);
      rates[5] = rates[5] + q * (mass.rx[l] * u + mass.kx[l] * v_k + mass.xx[l] * v_x);
    }
    for (std::size_t i = 0; i < 6; ++i) {
      const auto term = share * x * rates[i];
      next[i].set(l, term);
      sum[i].set(l, sum[i][l] + term);
    }
  }
}

/// Whether the last two terms are negligible in every component. Each component is checked, because the normal
/// displacement of a thin incompressible layer is far smaller than the others; one term alone may vanish by parity.
template <class Scalar>
VISCOROLL_PART_OF_CALLER bool are_negligible(const SolutionLanes<Scalar>& last, const SolutionLanes<Scalar>& before,
                                             const SolutionLanes<Scalar>& sum) {
  std::array<double, kLanes> open{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      const double limit = kNegligibleTerm * size(sum[i][l]);
      open[l] = size(last[i][l]) > limit ? 1.0 : open[l];
      open[l] = size(before[i][l]) > limit ? 1.0 : open[l];
    }
  }
  for (const double lane : open) {
    if (lane != 0.0) return false;
  }
  return true;
}

/// Replace a solution at the inner end by its value at the outer end.
template <bool IsWheel, bool HasInertia, class Scalar>
VISCOROLL_PART_OF_CALLER void sum_series(const StepLanes<Scalar>& step, SolutionLanes<Scalar>& sum) {
  SolutionLanes<Scalar> first = sum;
  SolutionLanes<Scalar> second{};
  SolutionLanes<Scalar> third{};
  for (int j = 0; j < kMaxTerms; j += 3) {
    add_term<IsWheel, HasInertia>(step, j, first, second, third, sum);
    add_term<IsWheel, HasInertia>(step, j + 1, third, first, second, sum);
    add_term<IsWheel, HasInertia>(step, j + 2, second, third, first, sum);
    if (are_negligible(first, second, sum)) break;
  }
}

/// Cofactor of stress i of solution p in F.
template <class Scalar>
VISCOROLL_PART_OF_CALLER auto cofactor(const std::array<SolutionLanes<Scalar>, 3>& z, std::size_t l, std::size_t i,
                                       std::size_t p) {
  const std::size_t i1 = 3 + (i + 1) % 3;
  const std::size_t i2 = 3 + (i + 2) % 3;
  const std::size_t p1 = (p + 1) % 3;
  const std::size_t p2 = (p + 2) % 3;
  return z[p1][i1][l] * z[p2][i2][l] - z[p2][i1][l] * z[p1][i2][l];
}

/// Compute D F^-1 by cofactors. The matrix is symmetric, so six entries suffice.
template <class Scalar>
VISCOROLL_PART_OF_CALLER void divide(const std::array<SolutionLanes<Scalar>, 3>& z,
                                     SymmetricLanes<Scalar>& compliance) {
  for (std::size_t l = 0; l < kLanes; ++l) {
    const auto u0 = z[0][0][l];
    const auto u1 = z[1][0][l];
    const auto u2 = z[2][0][l];
    const auto v0 = z[0][1][l];
    const auto v1 = z[1][1][l];
    const auto v2 = z[2][1][l];
    auto c0 = cofactor(z, l, 0, 0);
    auto c1 = cofactor(z, l, 0, 1);
    auto c2 = cofactor(z, l, 0, 2);
    const auto scale = inverse(z[0][3][l] * c0 + z[1][3][l] * c1 + z[2][3][l] * c2);
    compliance.rr.set(l, scale * (u0 * c0 + u1 * c1 + u2 * c2));
    c0 = cofactor(z, l, 1, 0);
    c1 = cofactor(z, l, 1, 1);
    c2 = cofactor(z, l, 1, 2);
    compliance.rk.set(l, scale * (u0 * c0 + u1 * c1 + u2 * c2));
    compliance.kk.set(l, scale * (v0 * c0 + v1 * c1 + v2 * c2));
    c0 = cofactor(z, l, 2, 0);
    c1 = cofactor(z, l, 2, 1);
    c2 = cofactor(z, l, 2, 2);
    compliance.rx.set(l, scale * (u0 * c0 + u1 * c1 + u2 * c2));
    compliance.kx.set(l, scale * (v0 * c0 + v1 * c1 + v2 * c2));
    compliance.xx.set(l, scale * (z[0][2][l] * c0 + z[1][2][l] * c1 + z[2][2][l] * c2));
  }
}

/// Compute F^-1 by cofactors. Row p contains the amplitude of solution p per stress at the outer end.
template <class Scalar>
VISCOROLL_PART_OF_CALLER void invert_stress(const std::array<SolutionLanes<Scalar>, 3>& z,
                                            MatrixLanes<Scalar>& inverse_stress) {
  for (std::size_t l = 0; l < kLanes; ++l) {
    const auto scale = inverse(z[0][3][l] * cofactor(z, l, 0, 0) + z[1][3][l] * cofactor(z, l, 0, 1) +
                               z[2][3][l] * cofactor(z, l, 0, 2));
    for (std::size_t p = 0; p < 3; ++p) {
      for (std::size_t i = 0; i < 3; ++i) inverse_stress[3 * p + i].set(l, scale * cofactor(z, l, i, p));
    }
  }
}

/// Values of the three solutions at the outer end.
template <class Scalar>
VISCOROLL_PART_OF_CALLER std::array<SolutionLanes<Scalar>, 3> advanced(
    const StepLanes<Scalar>& step, const std::array<SolutionLanes<Scalar>, 3>& start) {
  std::array<SolutionLanes<Scalar>, 3> states = start;
  for (SolutionLanes<Scalar>& solution : states) {
    if (step.is_wheel) {
      step.has_inertia ? sum_series<true, true>(step, solution) : sum_series<true, false>(step, solution);
    } else {
      step.has_inertia ? sum_series<false, true>(step, solution) : sum_series<false, false>(step, solution);
    }
  }
  return states;
}

}  // namespace

VISCOROLL_BEST_INSTRUCTIONS
void advance(const StepLanes<double>& step, const std::array<SolutionLanes<double>, 3>& start,
             SymmetricLanes<double>& compliance) {
  divide(advanced(step, start), compliance);
}

VISCOROLL_BEST_INSTRUCTIONS
void advance(const StepLanes<std::complex<double>>& step,
             const std::array<SolutionLanes<std::complex<double>>, 3>& start,
             SymmetricLanes<std::complex<double>>& compliance) {
  divide(advanced(step, start), compliance);
}

VISCOROLL_BEST_INSTRUCTIONS
void advance(const StepLanes<std::complex<double>>& step,
             const std::array<SolutionLanes<std::complex<double>>, 3>& start,
             SymmetricLanes<std::complex<double>>& compliance, MatrixLanes<std::complex<double>>& inverse_stress) {
  const auto states = advanced(step, start);
  divide(states, compliance);
  invert_stress(states, inverse_stress);
}

}  // namespace viscoroll::detail

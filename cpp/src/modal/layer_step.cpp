#include "modal/layer_step.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kMaxTerms = 81;        // steps are short enough for 40
constexpr double kRoundOff = 1e-17;  // of a term that is left out, relative to the sum

/// The next term of a solution, added to its sum: (1 + c x) dz/dx = (B + q (1 + c x)^2 M) z gives the terms t_j = z_j
/// x^j by t_{j+1} = x / (j+1) ((B - c j) t_j + q M (t_j + 2 c x t_{j-1} + (c x)^2 t_{j-2})).
/// @param[in] now,before t_j and t_{j-1}
/// @param[in,out] next t_{j-2}, which t_{j+1} takes the place of
template <bool HasInertia, class Scalar>
VISCOROLL_PART_OF_CALLER void add_term(const StepLanes<Scalar>& step, int j, const SolutionLanes<Scalar>& now,
                                       const SolutionLanes<Scalar>& before, SolutionLanes<Scalar>& next,
                                       SolutionLanes<Scalar>& sum) {
  const double share = 1.0 / (j + 1.0);
  const double along = step.along;
  const double across = step.across;
  const double area = step.area;
  const double bends = along + across;
  const double order = along * j;
  for (std::size_t l = 0; l < kLanes; ++l) {
    const double k = step.k[l];
    const double x = step.growth[l];
    const auto u = now[0][l];
    const auto v_k = now[1][l];
    const auto v_x = now[2][l];
    const auto s = now[3][l];
    const auto tau_k = now[4][l];
    const auto tau_x = now[5][l];
    const auto t = k * v_k - bends * u;
    const auto bt = step.b[l] * t;
    const auto bs = step.b[l] * s;
    const auto gamma_t = area * t - 4.0 * bt;
    auto s_rate = k * tau_k - bends * gamma_t + (along - order) * s - 2.0 * bends * bs;
    auto tau_k_rate = k * (gamma_t - s + 2.0 * bs) + step.membrane[l] * v_k - (bends + order) * tau_k;
    auto tau_x_rate = step.shear[l] * v_x - (2.0 * across + order) * tau_x;
    if constexpr (HasInertia) {
      const double spread = along * x;
      const auto& mass = step.inertia;
      const auto q = step.q[l];
      const auto u_sum = u + 2.0 * spread * before[0][l] + spread * spread * next[0][l];
      const auto v_k_sum = v_k + 2.0 * spread * before[1][l] + spread * spread * next[1][l];
      const auto v_x_sum = v_x + 2.0 * spread * before[2][l] + spread * spread * next[2][l];
      s_rate = s_rate + q * (mass.rr[l] * u_sum + mass.rk[l] * v_k_sum + mass.rx[l] * v_x_sum);
      tau_k_rate = tau_k_rate + q * (mass.rk[l] * u_sum + mass.kk[l] * v_k_sum + mass.kx[l] * v_x_sum);
      tau_x_rate = tau_x_rate + q * (mass.rx[l] * u_sum + mass.kx[l] * v_k_sum + mass.xx[l] * v_x_sum);
    }
    const std::array rates{t - 2.0 * bt + bs - order * u,
                           (along - order) * v_k - k * u + tau_k,
                           (across - order) * v_x + tau_x,
                           s_rate,
                           tau_k_rate,
                           tau_x_rate};
    for (std::size_t i = 0; i < 6; ++i) {
      const auto term = share * x * rates[i];
      next[i].set(l, term);
      sum[i].set(l, sum[i][l] + term);
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

/// One solution at the outer end.
template <bool HasInertia, class Scalar>
VISCOROLL_PART_OF_CALLER void sum_series(const StepLanes<Scalar>& step, SolutionLanes<Scalar>& sum) {
  SolutionLanes<Scalar> first = sum;
  SolutionLanes<Scalar> second{};
  SolutionLanes<Scalar> third{};
  for (int j = 0; j < kMaxTerms; j += 3) {
    add_term<HasInertia>(step, j, first, second, third, sum);
    add_term<HasInertia>(step, j + 1, third, first, second, sum);
    add_term<HasInertia>(step, j + 2, second, third, first, sum);
    if (are_negligible(first, second, sum)) break;
  }
}

/// Cofactor of stress i in solution p.
template <class Scalar>
VISCOROLL_PART_OF_CALLER auto cofactor(const std::array<SolutionLanes<Scalar>, 3>& z, std::size_t l, std::size_t i,
                                       std::size_t p) {
  const std::size_t i1 = 3 + (i + 1) % 3;
  const std::size_t i2 = 3 + (i + 2) % 3;
  const std::size_t p1 = (p + 1) % 3;
  const std::size_t p2 = (p + 2) % 3;
  return z[p1][i1][l] * z[p2][i2][l] - z[p2][i1][l] * z[p1][i2][l];
}

/// D F^-1 by cofactors; it is symmetric, so six entries are all.
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

/// F^-1 by cofactors: row p is what start p contributes to the stresses at the outer end.
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

/// All three solutions at the outer end.
template <class Scalar>
VISCOROLL_PART_OF_CALLER std::array<SolutionLanes<Scalar>, 3> advanced(
    const StepLanes<Scalar>& step, const std::array<SolutionLanes<Scalar>, 3>& start) {
  std::array<SolutionLanes<Scalar>, 3> states = start;
  for (SolutionLanes<Scalar>& solution : states) {
    step.has_inertia ? sum_series<true>(step, solution) : sum_series<false>(step, solution);
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

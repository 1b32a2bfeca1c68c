#include "modal/flat_layers.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace viscoroll::detail {
namespace {

constexpr double kDepth = 40.0;       // decay lengths beyond which material is out of reach of the surface
constexpr double kLongestStep = 1.2;  // k h of a step: the compliance keeps all digits
constexpr double kLeastDecay = 0.05;

template <class Scalar>
using Matrix2 = Eigen::Matrix<Scalar, 2, 2>;
template <class Scalar>
using Matrix4 = Eigen::Matrix<Scalar, 4, 4>;

double real_part(double value) { return value; }
double real_part(const std::complex<double>& value) { return value.real(); }

/// Compliance of the material of one layer in units of 1 / (mu k).
template <class Scalar>
struct Reduced {
  Matrix2<Scalar> along = Matrix2<Scalar>::Zero();  // (u, v) per (s, tau)
  Scalar across = Scalar(0.0);                      // w per tau_w
};

/// e = rho (k_phi V)^2 / (mu k^2)
template <class Scalar>
Scalar inertia_share(const FlatMedium<Scalar>& medium, double cosine) {
  return Scalar(medium.inertia * cosine * cosine) / medium.mu;
}

template <class Scalar>
Reduced<Scalar> half_space(const FlatMedium<Scalar>& medium, Scalar e) {
  using std::sqrt;
  const Scalar p_s = sqrt(Scalar(1.0) - e);
  const Scalar p_l = sqrt(Scalar(1.0) - medium.b * e);
  // Free of differences of nearly equal numbers at small e.
  const Scalar g = (1.0 + medium.b - medium.b * e) / (1.0 + p_l * p_s);
  const Scalar d = 4.0 - e - 4.0 * g;
  const Scalar mixed = -(2.0 * g - 1.0) / d;
  return {.along = Matrix2<Scalar>{{p_l / d, mixed}, {mixed, p_s / d}}, .across = 1.0 / p_s};
}

/// The transition matrix exp(B x) of (u, v, s, tau).
///
/// B^2 has the eigenvalues y = p_s^2 = 1 - e and z = p_l^2 = 1 - b e, twice each, so that any even function of B is
/// f(y) + f[y, z] (B^2 - y), and the odd part of the exponential is B times one. Divided differences come from the
/// powers' series, since the two meet without inertia.
template <class Scalar>
Matrix4<Scalar> transition(const FlatMedium<Scalar>& medium, Scalar e, double x) {
  const Scalar a = 1.0 - 2.0 * medium.b;
  Matrix4<Scalar> b = Matrix4<Scalar>::Zero();
  b(0, 1) = a;
  b(0, 2) = medium.b;
  b(1, 0) = -1.0;
  b(1, 3) = 1.0;
  b(2, 0) = -e;
  b(2, 3) = 1.0;
  b(3, 1) = 4.0 * (1.0 - medium.b) - e;
  b(3, 2) = -a;
  const Scalar y = 1.0 - e;
  const Scalar z = 1.0 - medium.b * e;
  constexpr int kTerms = 14;  // 1.2^28 / 28! = 5e-28
  Scalar cosh = 0.0;
  Scalar sinh = 0.0;  // over the square root
  Scalar cosh_slope = 0.0;
  Scalar sinh_slope = 0.0;
  Scalar power = 1.0;    // y^j
  Scalar divided = 0.0;  // (y^j - z^j) / (y - z)
  Scalar z_power = 1.0;
  double even = 1.0;  // x^(2j) / (2j)!
  for (int j = 0; j < kTerms; ++j) {
    const double odd = even * x / (2 * j + 1);
    cosh += even * power;
    sinh += odd * power;
    cosh_slope += even * divided;
    sinh_slope += odd * divided;
    divided = y * divided + z_power;
    power *= y;
    z_power *= z;
    even = odd * x / (2 * j + 2);
  }
  const Matrix4<Scalar> unit = Matrix4<Scalar>::Identity();
  const Matrix4<Scalar> rest = b * b - y * unit;
  return cosh * unit + cosh_slope * rest + b * (sinh * unit + sinh_slope * rest);
}

/// Carry the compliance through a layer. @return whether it stayed positive definite, which real ones may ask for
template <class Scalar>
bool carry(const FlatMedium<Scalar>& medium, Scalar e, double k, Reduced<Scalar>& y) {
  const double depth = k * medium.thickness;
  const double steps = std::ceil(depth / kLongestStep);
  const double x = depth / std::max(steps, 1.0);
  const Matrix4<Scalar> t = transition(medium, e, x);
  const Matrix2<Scalar> t11 = t.template topLeftCorner<2, 2>();
  const Matrix2<Scalar> t12 = t.template topRightCorner<2, 2>();
  const Matrix2<Scalar> t21 = t.template bottomLeftCorner<2, 2>();
  const Matrix2<Scalar> t22 = t.template bottomRightCorner<2, 2>();
  bool positive = true;
  for (double step = 0.0; step < steps; step += 1.0) {
    y.along = ((t11 * y.along + t12) * (t21 * y.along + t22).inverse()).eval();
    y.along(0, 1) = y.along(1, 0) = 0.5 * (y.along(0, 1) + y.along(1, 0));
    if constexpr (std::is_same_v<Scalar, double>) {
      positive = positive && y.along(0, 0) > 0.0 && y.along.determinant() > 0.0;
    }
  }
  using std::sqrt;
  using std::tanh;
  const Scalar p = sqrt(Scalar(1.0) - e);
  const Scalar tangent = tanh(depth * p) / p;
  y.across = (y.across + tangent) / (1.0 + p * p * tangent * y.across);
  return positive;
}

/// Where to start.
struct Start {
  std::size_t medium;  ///< the innermost that the surface feels
  bool endless;        ///< whether nothing below it is felt
};

template <class Scalar>
Start start_of(std::span<const FlatMedium<Scalar>> media, double k, double cosine) {
  double depth = 0.0;
  for (std::size_t l = media.size(); l-- > 0;) {
    using std::sqrt;
    const double decay = real_part(sqrt(Scalar(1.0) - inertia_share(media[l], cosine)));
    depth += k * media[l].thickness * std::clamp(decay, kLeastDecay, 1.0);
    if (depth > kDepth) return {.medium = l, .endless = true};
  }
  return {.medium = 0, .endless = false};
}

/// Compliance in units of the last medium, and whether it is positive all the way.
template <class Scalar>
std::pair<Reduced<Scalar>, bool> reduced_compliance(std::span<const FlatMedium<Scalar>> media, double k,
                                                    double cosine) {
  const auto [first, endless] = start_of(media, k, cosine);
  bool positive = true;
  Reduced<Scalar> y;
  for (std::size_t l = first; l < media.size(); ++l) {
    const Scalar e = inertia_share(media[l], cosine);
    if (l > first) {
      y.along *= media[l].mu / media[l - 1].mu;
      y.across *= media[l].mu / media[l - 1].mu;
    }
    if (l == first && endless) {
      y = half_space(media[l], e);
      positive = real_part(y.along(0, 0)) > 0.0;
    } else {
      positive = carry(media[l], e, k, y) && positive;
    }
  }
  return {y, positive};
}

}  // namespace

template <class Scalar>
FlatCompliance<Scalar> flat_compliance(std::span<const FlatMedium<Scalar>> media, double k, double cosine) {
  const Reduced<Scalar> y = reduced_compliance(media, k, cosine).first;
  const Scalar unit = 1.0 / (media.back().mu * k);
  return {.uu = unit * y.along(0, 0), .uk = unit * y.along(0, 1), .kk = unit * y.along(1, 1), .pp = unit * y.across};
}

bool is_subcritical(std::span<const FlatMedium<double>> media, double k) {
  return std::ranges::all_of(media, [](const auto& medium) { return medium.inertia < medium.mu; }) &&
         reduced_compliance(media, k, 1.0).second;
}

template FlatCompliance<double> flat_compliance(std::span<const FlatMedium<double>>, double, double);
template FlatCompliance<std::complex<double>> flat_compliance(std::span<const FlatMedium<std::complex<double>>>, double,
                                                              double);

}  // namespace viscoroll::detail

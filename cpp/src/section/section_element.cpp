#include "section/section_element.hpp"

#include <Eigen/LU>
#include <cmath>
#include <cstddef>

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using StrainRows = Eigen::Matrix<double, 6, kElementUnknowns>;
using VolumeRows = Eigen::Matrix<double, 3, kElementUnknowns>;

enum Strain : Index { kRadial, kHoop, kAxial, kRadialHoop, kHoopAxial, kRadialAxial };

std::array<double, 3> quadratic_slopes(double x) { return {x - 0.5, -2.0 * x, x + 0.5}; }

/// Values and gradients of the nine shape functions at a Gauss point, and the weight of the point.
struct Point {
  Eigen::Matrix<double, kElementNodes, 1> value, along_r, along_z;
  double r;
  double measure;
};

Point point(const std::array<double, kElementNodes>& r, const std::array<double, kElementNodes>& z, double x, double y,
            double weight) {
  const auto across = quadratic_shares(x);
  const auto down = quadratic_shares(y);
  const auto across_slope = quadratic_slopes(x);
  const auto down_slope = quadratic_slopes(y);
  Point p{};
  Eigen::Matrix<double, kElementNodes, 2> local;
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();  // d(r, z)/d(x, y)
  for (Index n = 0; n < kElementNodes; ++n) {
    const auto node = static_cast<std::size_t>(n);
    p.value[n] = across[node % 3] * down[node / 3];
    local(n, 0) = across_slope[node % 3] * down[node / 3];
    local(n, 1) = across[node % 3] * down_slope[node / 3];
    p.r += p.value[n] * r[node];
    jacobian.row(0) += r[node] * local.row(n);
    jacobian.row(1) += z[node] * local.row(n);
  }
  const Eigen::Matrix<double, kElementNodes, 2> gradient = local * jacobian.inverse();
  p.along_r = gradient.col(0);
  p.along_z = gradient.col(1);
  p.measure = weight * std::abs(jacobian.determinant()) * p.r;
  return p;
}

/// Strain rows of order 0, and the part that is multiplied by m.
std::array<StrainRows, 2> strain_rows(const Point& p) {
  std::array<StrainRows, 2> rows{StrainRows::Zero(), StrainRows::Zero()};
  auto& [rest, order] = rows;
  for (Index n = 0; n < kElementNodes; ++n) {
    const Index u = 3 * n;
    const Index v = u + 1;
    const Index w = u + 2;
    const double hoop = p.value[n] / p.r;
    rest(kRadial, u) = p.along_r[n];
    rest(kHoop, u) = hoop;
    rest(kAxial, w) = p.along_z[n];
    rest(kRadialHoop, v) = p.along_r[n] - hoop;
    rest(kHoopAxial, v) = p.along_z[n];
    rest(kRadialAxial, u) = p.along_z[n];
    rest(kRadialAxial, w) = p.along_r[n];
    order(kHoop, v) = -hoop;
    order(kRadialHoop, u) = hoop;
    order(kHoopAxial, w) = hoop;
  }
  return rows;
}

/// Add (a + m b)^T weight (a + m b) to the powers of m, with a = rows[0] and b = rows[1].
template <class Rows, class Weight>
void add_square(const std::array<Rows, 2>& rows, const Weight& weight, PowersOfOrder& powers) {
  const Rows rest = weight * rows[0];
  const Rows order = weight * rows[1];
  const ElementMatrix mixed = rows[0].transpose() * order;
  powers[0] += rows[0].transpose() * rest;
  powers[1] += mixed + mixed.transpose();
  powers[2] += rows[1].transpose() * order;
}

}  // namespace

std::array<double, 3> quadratic_shares(double x) { return {0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)}; }

ElementStiffness element_stiffness(const std::array<double, kElementNodes>& r,
                                   const std::array<double, kElementNodes>& z) {
  const double outer = std::sqrt(0.6);  // three Gauss points
  const std::array<double, 3> abscissas{-outer, 0.0, outer};
  const std::array<double, 3> weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  const Eigen::DiagonalMatrix<double, 6> shear_weights(2.0, 2.0, 2.0, 1.0, 1.0, 1.0);
  ElementStiffness stiffness;
  for (auto* const powers : {&stiffness.shear, &stiffness.volumetric}) powers->fill(ElementMatrix::Zero());
  std::array<VolumeRows, 2> volume{VolumeRows::Zero(), VolumeRows::Zero()};
  Eigen::Matrix3d pressures = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Point p = point(r, z, abscissas[i], abscissas[j], weights[i] * weights[j]);
      const auto strains = strain_rows(p);
      add_square(strains, Eigen::DiagonalMatrix<double, 6>(p.measure * shear_weights.diagonal()), stiffness.shear);
      const Eigen::Vector3d pressure(1.0, abscissas[i], abscissas[j]);
      pressures += p.measure * pressure * pressure.transpose();
      for (std::size_t power = 0; power < 2; ++power) {
        volume[power] += p.measure * pressure * strains[power].topRows<3>().colwise().sum();
      }
    }
  }
  add_square(volume, Eigen::Matrix3d(pressures.inverse()), stiffness.volumetric);
  return stiffness;
}

ElementMatrix at_order(const PowersOfOrder& powers, double m) { return powers[0] + m * (powers[1] + m * powers[2]); }

}  // namespace viscoroll::detail

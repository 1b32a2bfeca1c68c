/// @file
/// @brief All degrees l of one order m on the exact sphere, at the nodes of a mesh: vector spherical harmonics and
/// their compliances. See docs/theory/influence-tables.md.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <memory>

#include "modal/degree_compliance.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Values of the harmonics of one order, or their means over patches: one row per degree, one column per node k
/// = 0, 1, ... from the equator on. The components of Y, Psi and Phi along (r, phi, theta) are (P, 0, 0), (0, i E, D)
/// and (0, D, -i E).
struct Harmonics {
  Eigen::MatrixXd p;
  Eigen::MatrixXd d;  ///< dP/dtheta / sqrt(L), L = l (l + 1); empty if only r by r is needed
  Eigen::MatrixXd e;  ///< m P / (sin(theta) sqrt(L)); empty if only r by r is needed
};

/// @brief Every other degree of an order m. For the degrees m, m + 2, ..., P and E are even about the equator and D is
/// odd; for m + 1, m + 3, ... the reverse holds.
struct EveryOtherDegree {
  std::shared_ptr<const Harmonics> displaced;    ///< harmonics at the displaced nodes
  std::shared_ptr<const Harmonics> loaded;       ///< harmonics of unit forces on patches
  Eigen::ArrayXcd radial, mixed, along, across;  ///< same as in `DegreeCompliance`, but per force [m/N]
};

/// @brief Degrees of an order, those that begin with l = m first.
using SphericalOrder = std::array<EveryOtherDegree, 2>;

/// @param[in] order m
/// @param[in] highest highest degree
/// @param[in] theta angles [rad]
/// @param[in] tangential whether D and E are needed
/// @return harmonics of the degrees m, m + 2, ... and m + 1, m + 3, ... up to the highest
[[nodiscard]] std::array<Harmonics, 2> harmonics_at(int order, int highest, const Eigen::ArrayXd& theta,
                                                    bool tangential);

/// @brief Gauss points on the patches of nodes from the equator on.
class ThetaPatches {
 public:
  /// @param[in] nodes number of nodes; the first lies on the equator
  /// @param[in] spacing spacing of the nodes and width of the patches [rad]
  /// @param[in] load traction on a patch
  /// @param[in] highest highest degree of the waves on it
  ThetaPatches(Eigen::Index nodes, double spacing, PatchLoad load, int highest);

  /// @return means over the patches, weighted so that the force on each is 1
  [[nodiscard]] std::array<Harmonics, 2> harmonics(int order, int highest, bool tangential) const;

 private:
  [[nodiscard]] Eigen::MatrixXd means(const Eigen::MatrixXd& values) const;

  Eigen::Index points_;  // per patch
  Eigen::ArrayXd theta_;
  Eigen::ArrayXd weight_;
};

/// @brief Degrees of an order for every other node.
/// @param[in] fine degrees for all nodes
/// @param[in] factor factor on the compliances
/// @param[in] wide_displaced whether the displacement is also a mean over patches of twice the width, like the load
[[nodiscard]] SphericalOrder with_wide_patches(const SphericalOrder& fine, std::complex<double> factor,
                                               bool wide_displaced);

/// @brief Displacement along the component P due to a force along Q.
/// @param[in] order degrees of the order
/// @param[in] p,q components 0, 1, 2 of (r, phi, theta)
/// @param[in] half_theta number of nodes on either side of the equator
/// @return [displaced node, loaded node], from one side to the other
[[nodiscard]] Eigen::MatrixXcd sum_between(const SphericalOrder& order, int p, int q, Eigen::Index half_theta);

/// @brief Same between nodes on opposite sides of the equator: displaced node (l + 1) / 2 on one side, loaded node l /
/// 2 on the other.
/// @return values at the offsets l = 0, ..., reach
[[nodiscard]] Eigen::VectorXcd sum_across_equator(const SphericalOrder& order, int p, int q, int reach);

/// @brief Sums over orders of Re of e^(i m j spacing) times amplitudes, at offsets j of both signs.
class OrderPhases {
 public:
  /// @param[in] orders number of orders 0, ..., orders - 1
  /// @param[in] reach largest offset
  /// @param[in] spacing spacing of the offsets [rad]
  OrderPhases(int orders, int reach, double spacing);

  /// @brief Values at j are even(j) + odd(j), those at -j are even(j) - odd(j).
  struct Sums {
    Eigen::MatrixXd even;  ///< [offset 0 ... reach, amplitude]
    Eigen::MatrixXd odd;
  };
  /// @param[in] real,imaginary parts of the amplitudes [order, amplitude]
  [[nodiscard]] Sums operator()(const Eigen::MatrixXd& real, const Eigen::MatrixXd& imaginary) const;

 private:
  Eigen::MatrixXd cosines_;  // [offset, order]
  Eigen::MatrixXd sines_;
};

}  // namespace viscoroll::detail

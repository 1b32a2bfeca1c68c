/// @file
/// @brief All degrees l of one order m on the exact sphere, at the nodes of a mesh: vector spherical harmonics, and
/// what their compliances make of them. See docs/theory/influence-tables.md.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <memory>

#include "modal/degree_compliance.hpp"
#include "viscoroll/formulation.hpp"

namespace viscoroll::detail {

/// @brief Values of the harmonics of one order, or means of them over patches: a row for each degree, a column for each
/// node k = 0, 1, ... from the equator on. The components of Y, Psi and Phi along (r, phi, theta) are (P, 0, 0),
/// (0, i E, D) and (0, D, -i E).
struct Harmonics {
  Eigen::MatrixXd p;
  Eigen::MatrixXd d;  ///< dP/dtheta / sqrt(L), or none where only r by r is asked for
  Eigen::MatrixXd e;  ///< m P / (sin(theta) sqrt(L)), or none
};

/// @brief Every other degree of an order m: m, m + 2, ..., of which P and E are even about the equator and D is odd, or
/// m + 1, m + 3, ..., of which the reverse is true.
struct EveryOtherDegree {
  std::shared_ptr<const Harmonics> seen;         ///< of what is displaced
  std::shared_ptr<const Harmonics> loaded;       ///< of what forces of 1 on patches are
  Eigen::ArrayXcd radial, mixed, along, across;  ///< as in `DegreeCompliance`, but by forces [m/N]
};

/// @brief The degrees of an order, those that begin with l = m first.
using SphericalOrder = std::array<EveryOtherDegree, 2>;

/// @return harmonics of the degrees m, m + 2, ... and m + 1, m + 3, ... up to the highest, at some thetas
/// @param[in] tangential whether D and E are asked for
[[nodiscard]] std::array<Harmonics, 2> harmonics_at(int order, int highest, const Eigen::ArrayXd& theta,
                                                    bool tangential);

/// @brief Gauss points on the patches of nodes from the equator on.
class ThetaPatches {
 public:
  /// @param[in] nodes number of them, the one on the equator first
  /// @param[in] spacing of them, and width of the patches [rad]
  /// @param[in] load traction on a patch
  /// @param[in] highest degree of the waves on it
  ThetaPatches(Eigen::Index nodes, double spacing, PatchLoad load, int highest);

  /// @return means over the patches, weighted so that the force on each is 1
  [[nodiscard]] std::array<Harmonics, 2> harmonics(int order, int highest, bool tangential) const;

 private:
  [[nodiscard]] Eigen::MatrixXd means(const Eigen::MatrixXd& values) const;

  Eigen::Index points_;  // of each patch
  Eigen::ArrayXd theta_;
  Eigen::ArrayXd weight_;
};

/// @brief The same for every other node.
/// @param[in] factor by which compliances change
/// @param[in] wide_seen whether what is displaced is a mean over patches of twice the width, as what is loaded
[[nodiscard]] SphericalOrder with_wide_patches(const SphericalOrder& fine, std::complex<double> factor, bool wide_seen);

/// @brief What displaces along the component P under a force along Q.
/// @param[in] order its degrees
/// @param[in] p,q components 0, 1, 2 of (r, phi, theta)
/// @param[in] half_theta number of nodes beside the equator on either side
/// @return [displaced node, loaded node], from one side to the other
[[nodiscard]] Eigen::MatrixXcd sum_between(const SphericalOrder& order, int p, int q, Eigen::Index half_theta);

/// @brief The same between nodes on both sides of the equator, displaced (l + 1) / 2 on one and loaded l / 2 on the
/// other.
/// @return of the offsets l = 0, ..., reach
[[nodiscard]] Eigen::VectorXcd sum_across_equator(const SphericalOrder& order, int p, int q, int reach);

/// @brief Sums over orders, Re of e^(i m j spacing) times amplitudes, at offsets j of either sign.
class OrderPhases {
 public:
  /// @param[in] orders 0, ..., orders - 1
  /// @param[in] reach largest offset
  /// @param[in] spacing [rad]
  OrderPhases(int orders, int reach, double spacing);

  /// @brief Values at j: even(j) + odd(j), at -j: even(j) - odd(j).
  struct Sums {
    Eigen::MatrixXd even;  ///< [offset 0 ... reach, amplitude]
    Eigen::MatrixXd odd;
  };
  /// @param[in] real,imaginary amplitudes [order, amplitude]
  [[nodiscard]] Sums operator()(const Eigen::MatrixXd& real, const Eigen::MatrixXd& imaginary) const;

 private:
  Eigen::MatrixXd cosines_;  // [offset, order]
  Eigen::MatrixXd sines_;
};

}  // namespace viscoroll::detail

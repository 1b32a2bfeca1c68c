/// @file
/// @brief Fields at places inside the layers, due to surface stresses of one order m and many orders n.
///
/// At a given m every entry of the states is a smooth function of n^2, times n if it is odd. A few dozen solutions of
/// the layers give all entries as Chebyshev series in ln(m^2 + n^2), for all n. One set of series serves all m if the
/// layers share one relaxation function, inertia is negligible and both directions of the surface are equivalent: the
/// states along and across the wave vector k then depend on k alone. Under a line contact only n = 0 occurs, without an
/// expansion. The order (0, 0) of flat layers is their uniform state.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "interior/field_components.hpp"
#include "interior/inside.hpp"
#include "modal/chebyshev_panels.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief Surface stresses r sigma of one m and many n in the real form, rows s, tau_phi, tau_theta.
using LoadRows = Eigen::Array<std::complex<double>, 3, Eigen::Dynamic, Eigen::RowMajor>;

/// @brief Whether each component of the surface stress is nonzero.
using LoadedComponents = std::array<bool, 3>;

/// @brief States at boundaries between pieces of the layers, as series for one m.
class DepthSeries {
 public:
  /// Entry of a state: the component of `DepthState`, and its column, the loaded component.
  struct Entry {
    std::size_t component;
    std::size_t column;
    /// Whether exactly one of the two directions is theta; the entry then changes sign with n and has a factor n.
    [[nodiscard]] bool is_odd() const { return (component % 3 == 2) != (column == 2); }
  };

  /// Range of orders n.
  struct Range {
    double lowest;
    double highest;
  };

  /// @param[in] pieces pieces of the layers at order m
  /// @param[in] boundaries boundaries at which states are evaluated
  /// @param[in] m order
  /// @param[in] n range of orders; if the lowest one is 0, order 0 has a panel of its own
  /// @param[in] entries nonzero entries
  /// @param[in] tolerance error of the series, relative to the load for stresses and to the largest displacement for
  /// displacements
  DepthSeries(LayerStack<std::complex<double>> pieces, std::vector<std::size_t> boundaries, double m, Range n,
              std::vector<Entry> entries, double tolerance);

  /// @brief Series for n = 0 alone, for orders m that are solved together.
  /// @param[in] orders pieces and m of each order
  /// @param[in] boundaries,entries same as above
  /// @return one series per order m
  [[nodiscard]] static std::vector<std::shared_ptr<const DepthSeries>> under_line(
      std::span<const OrderInLayers<std::complex<double>>> orders, const std::vector<std::size_t>& boundaries,
      const std::vector<Entry>& entries);

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// @brief Series of all entries at all boundaries, boundary by boundary.
  [[nodiscard]] const std::vector<Panel<std::complex<double>>>& panels() const { return panels_; }
  /// @return whether the series are real
  [[nodiscard]] bool is_real() const { return is_real_; }

 private:
  using Values = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  DepthSeries(double m, const Eigen::VectorXcd& constants, std::vector<Entry> entries);

  void append(double low, double high);
  [[nodiscard]] Values solve(std::span<const double> squares) const;
  [[nodiscard]] bool is_resolved(const Panel<std::complex<double>>& panel) const;

  LayerStack<std::complex<double>> pieces_;
  std::vector<std::size_t> boundaries_;
  double m_;
  std::vector<Entry> entries_;
  double tolerance_;
  std::vector<Panel<std::complex<double>>> panels_;
  bool is_real_;
};

/// @brief Response of the layers to order m at a list of places.
class DepthTransfer {
 public:
  /// @brief Evaluate series at a list of orders.
  /// @param[in] series series for this m, or shared series (those for m = 0)
  /// @param[in] m order
  /// @param[in] n orders, ascending from 0
  /// @param[in] modulus_ratio modulus at order m divided by that of the shared series; 0 if the series are not shared
  DepthTransfer(std::shared_ptr<const DepthSeries> series, double m, const Eigen::ArrayXd& n,
                std::complex<double> modulus_ratio);

  /// @brief State at a boundary under given loads.
  /// @param[in] boundary index in the list of boundaries of the series
  /// @param[in] count number of orders n that are evaluated
  /// @param[in] loads surface stresses
  /// @param[out] state rows u_r, v_phi, v_theta, s, tau_phi, tau_theta
  void state(std::size_t boundary, Eigen::Index count, const LoadRows& loads, ComponentRows& state) const;

 private:
  [[nodiscard]] bool is_shared() const { return modulus_ratio_ != 0.0; }
  [[nodiscard]] ComponentRows values(std::size_t boundary, Eigen::Index count) const;

  std::shared_ptr<const DepthSeries> series_;
  std::complex<double> modulus_ratio_;
  Eigen::Array<std::complex<double>, 1, Eigen::Dynamic> odd_factor_;  // n, or k for shared series
  Eigen::Array<std::complex<double>, 1, Eigen::Dynamic> cosine_;      // cosine of the direction of k, for shared series
  Eigen::Array<std::complex<double>, 1, Eigen::Dynamic> sine_;
  std::vector<Eigen::Index> first_;         // index of the first order n in each panel, and the end
  std::vector<Eigen::MatrixXd> chebyshev_;  // Chebyshev polynomials at the orders of each panel
};

/// @brief Creates the transfers of all orders m of a body to a list of boundaries.
class DepthTransfers {
 public:
  /// Admissible errors.
  struct Accuracy {
    double tolerance;  ///< error of the series, see `DepthSeries`
    double inertia;    ///< rho (Omega r)^2 per modulus below which inertia is neglected and series may be shared
  };

  /// @param[in] body layers at the orders m, ascending; the first is 0 if a direction is periodic
  /// @param[in] cuts pieces of the layers with their boundaries
  /// @param[in] boundaries boundaries at which states are evaluated
  /// @param[in] highest_k largest sqrt(m^2 + n^2) that is evaluated
  /// @param[in] loaded nonzero components of the surface stress
  /// @param[in] accuracy admissible errors
  DepthTransfers(const HarmonicBody& body, const LayerCuts& cuts, std::vector<std::size_t> boundaries, double highest_k,
                 const LoadedComponents& loaded, const Accuracy& accuracy);

  /// @return number of orders m to evaluate together. Under a line contact each has one solution, and several of them
  /// fill the lanes of vector instructions.
  [[nodiscard]] std::size_t at_once() const;

  /// @param[in] first,count range of the orders m
  /// @param[in] n orders, ascending from 0
  [[nodiscard]] std::vector<DepthTransfer> at(std::size_t first, std::size_t count, const Eigen::ArrayXd& n) const;

 private:
  [[nodiscard]] bool can_share(double negligible_inertia) const;
  [[nodiscard]] bool is_line() const { return body_.metric().across == AxisKind::nothing; }

  const HarmonicBody& body_;
  const LayerCuts& cuts_;
  std::vector<std::size_t> boundaries_;
  double tolerance_;
  std::vector<DepthSeries::Entry> entries_;
  std::shared_ptr<const DepthSeries> shared_;  // null if every order m has its own series
};

}  // namespace viscoroll::detail

/// @file
/// @brief What loads of one order m and many orders n make at places inside the layers.
///
/// At a given m every entry of the states is a smooth function of n^2, times n where it is odd: a few dozen solutions
/// of the layers give them as Chebyshev series in ln(m^2 + n^2), for all n. Where layers share one relaxation function,
/// inertia is nothing and the surface is alike in all directions, those along and across k see k alone, whatever m: one
/// set of series serves all. Under a line there is n = 0 alone, and nothing to be expanded.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "interior/field_components.hpp"
#include "interior/layer_cuts.hpp"
#include "modal/chebyshev_panels.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief Surface stresses r sigma of one m and many n in the real form, rows s, tau_phi, tau_theta.
using LoadRows = Eigen::Array<std::complex<double>, 3, Eigen::Dynamic, Eigen::RowMajor>;

/// @brief Which components are loaded at all.
using LoadedComponents = std::array<bool, 3>;

/// @brief States at boundaries between pieces of the layers, as series of one m.
class DepthSeries {
 public:
  /// An entry of a state: component of `DepthState`, and column, the loaded component.
  struct Entry {
    std::size_t component;
    std::size_t column;
    /// One of the two directions is theta, so that the entry changes sign with n: it holds a factor n.
    [[nodiscard]] bool is_odd() const { return (component % 3 == 2) != (column == 2); }
  };

  /// Orders n.
  struct Range {
    double lowest;
    double highest;
  };

  /// @param[in] pieces at order m
  /// @param[in] boundaries where states are wanted
  /// @param[in] m order
  /// @param[in] n smallest and largest n that is asked for; 0 is a place apart, where it is the smallest
  /// @param[in] entries that are not zero
  /// @param[in] tolerance of the series, relative to the load for stresses and to the largest displacement
  DepthSeries(LayerStack<std::complex<double>> pieces, std::vector<std::size_t> boundaries, double m, Range n,
              std::vector<Entry> entries, double tolerance);

  /// @brief Those of n = 0 alone, of orders m that are solved side by side.
  /// @param[in] orders pieces and m of each
  /// @param[in] boundaries,entries likewise
  [[nodiscard]] static std::vector<std::shared_ptr<const DepthSeries>> under_line(
      std::span<const OrderInLayers<std::complex<double>>> orders, const std::vector<std::size_t>& boundaries,
      const std::vector<Entry>& entries);

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// @brief Series of all entries at all boundaries, boundary by boundary.
  [[nodiscard]] const std::vector<Panel<std::complex<double>>>& panels() const { return panels_; }
  /// @return whether the series are
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

/// @brief The layers' answer to order m at a list of places.
class DepthTransfer {
 public:
  /// @brief Evaluate series at a list of orders.
  /// @param[in] series of this m; or those of m = 0, if `modulus_ratio` says how much stiffer the layers are here
  /// @param[in] m order
  /// @param[in] n orders, ascending from 0
  /// @param[in] modulus_ratio modulus at order m per that of the shared series; 0 where they are not shared
  DepthTransfer(std::shared_ptr<const DepthSeries> series, double m, const Eigen::ArrayXd& n,
                std::complex<double> modulus_ratio);

  /// @brief The state at a boundary under given loads.
  /// @param[in] boundary place in the list of those of the series
  /// @param[in] count how many of the orders n
  /// @param[in] loads on the surface
  /// @param[out] state rows u_r, v_phi, v_theta, s, tau_phi, tau_theta
  void state(std::size_t boundary, Eigen::Index count, const LoadRows& loads, ComponentRows& state) const;

 private:
  [[nodiscard]] bool is_shared() const { return modulus_ratio_ != 0.0; }
  [[nodiscard]] ComponentRows values(std::size_t boundary, Eigen::Index count) const;

  std::shared_ptr<const DepthSeries> series_;
  std::complex<double> modulus_ratio_;
  Eigen::Array<std::complex<double>, 1, Eigen::Dynamic> odd_factor_;  // n, or k of shared series
  Eigen::Array<std::complex<double>, 1, Eigen::Dynamic> cosine_;      // of the direction of k, of shared series
  Eigen::Array<std::complex<double>, 1, Eigen::Dynamic> sine_;
  std::vector<Eigen::Index> first_;         // order n of each panel, and the end
  std::vector<Eigen::MatrixXd> chebyshev_;  // of each panel
};

/// @brief Makes the transfers of all orders m of a body to a list of boundaries.
class DepthTransfers {
 public:
  /// What may be left out.
  struct Accuracy {
    double tolerance;  ///< of series, see `DepthSeries`
    double inertia;    ///< rho (Omega r)^2 per modulus, where without it series are shared
  };

  /// @param[in] body layers at the orders m, ascending; the first is 0 where a way is a ring
  /// @param[in] cuts with the boundaries
  /// @param[in] boundaries where states are wanted
  /// @param[in] highest_k largest order that is asked for, of m and n together
  /// @param[in] loaded components of the surface stress that are not zero
  /// @param[in] accuracy what may be left out
  DepthTransfers(const HarmonicBody& body, const LayerCuts& cuts, std::vector<std::size_t> boundaries, double highest_k,
                 const LoadedComponents& loaded, const Accuracy& accuracy);

  /// @return how many orders m are best asked for at once: under a line each has one solution, and lanes are for
  /// several
  [[nodiscard]] std::size_t at_once() const;

  /// @param[in] first,count numbers of the orders m
  /// @param[in] n orders, ascending from 0
  [[nodiscard]] std::vector<DepthTransfer> at(std::size_t first, std::size_t count, const Eigen::ArrayXd& n) const;

 private:
  [[nodiscard]] bool can_share(double negligible_inertia) const;
  [[nodiscard]] bool is_line() const { return body_.metric().across == Way::nothing; }

  const HarmonicBody& body_;
  const LayerCuts& cuts_;
  std::vector<std::size_t> boundaries_;
  double tolerance_;
  std::vector<DepthSeries::Entry> entries_;
  std::shared_ptr<const DepthSeries> shared_;  // none where every order m has series of its own
};

}  // namespace viscoroll::detail

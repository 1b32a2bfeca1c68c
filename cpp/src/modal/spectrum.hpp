/// @file
/// @brief The surface compliance of many orders (m, n), cheaply.
///
/// At a given m every entry of the compliance is a smooth function of n^2, known once it is known at a few points. A
/// `Spectrum` gives it as Chebyshev series on panels of k^2 = m^2 + n^2, which `OrderValues` sums.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "modal/chebyshev_panels.hpp"
#include "modal/harmonic_body.hpp"
#include "parallel.hpp"

namespace viscoroll::detail {

/// @brief The six independent entries of the compliance; the others are C_phir = -C_rphi, C_thetar = -C_rtheta and
/// C_thetaphi = C_phitheta. Those with one theta are odd in n, the others even.
enum class Entry { rr, rphi, rtheta, phiphi, phitheta, thetatheta };
constexpr int kEntries = 6;

/// @return whether the entry is odd in n
[[nodiscard]] constexpr bool is_odd(Entry entry) { return entry == Entry::rtheta || entry == Entry::phitheta; }

/// @brief An entry of the 3 x 3 matrix as one of the independent ones.
struct SignedEntry {
  Entry entry;
  double sign;
};

/// @return how C_PQ is stored, with P and Q in the order (r, phi, theta)
[[nodiscard]] constexpr SignedEntry entry_of(std::size_t p, std::size_t q) {
  constexpr std::array<std::array<Entry, 3>, 3> kEntryOf{{{Entry::rr, Entry::rphi, Entry::rtheta},
                                                          {Entry::rphi, Entry::phiphi, Entry::phitheta},
                                                          {Entry::rtheta, Entry::phitheta, Entry::thetatheta}}};
  return {kEntryOf[p][q], q == 0 && p > 0 ? -1.0 : 1.0};
}

/// @brief Sizes by which errors of the entries are judged. The compliance is positive definite, so C_rphi and C_rtheta
/// are at most the geometric mean of their diagonal neighbors, and may be far smaller by cancellation.
/// @param[in] rr,phiphi sizes of these two entries
/// @param[in] m_divisor,n_divisor what C_rphi, C_rtheta and C_phitheta are divided by for each theta and phi
[[nodiscard]] inline std::array<double, kEntries> entry_sizes(double rr, double phiphi, double m_divisor,
                                                              double n_divisor) {
  const double mixed = std::sqrt(rr * phiphi);
  return {rr, mixed / m_divisor, mixed / n_divisor, phiphi, phiphi / (m_divisor * n_divisor), phiphi};
}

/// @brief The last terms of a resolved Chebyshev series, relative to the entry's size: above the noise of the layer
/// recursion.
constexpr double kSeriesTolerance = 1e-13;

/// @return the same for series of a body's compliances: a crown multiplies the noise
[[nodiscard]] inline double series_tolerance(const HarmonicBody& body) {
  return kSeriesTolerance * body.body().crown.proportion;
}

/// @brief Below this k^2 lies order (0, 0) alone. It has a panel of its own, for a small core makes it a spike: the
/// coating then turns about the core almost freely.
constexpr double kZeroOrder = 0.5;

/// @return of k^2 what order (0, 0) stands for; straight across a wheel, where orders n are any, of the longest waves
[[nodiscard]] constexpr double end_of_zero_order(const Metric& metric) {
  constexpr double kLongestWave = 1e-10;
  return metric.is_wheel() ? kLongestWave : kZeroOrder;
}

/// @brief Compliance of one m: row e of a panel is entry e in the real form of layer_system.hpp [m/Pa], divided by n
/// where the entry is odd.
using OrderSeries = std::vector<Panel<std::complex<double>>>;

/// @brief The orders m of a body. Immutable after construction: threads may share it.
class Spectrum {
 public:
  virtual ~Spectrum() = default;

  /// @brief Series of one order.
  /// @param[in] i number of the order m in the body's list
  /// @param[out] series panels that cover n in [0, highest_n]; storage is reused
  virtual void series(std::size_t i, OrderSeries& series) const = 0;
};

/// @brief Relative error of a compliance that inertia may leave where nothing else is asked for: next to round-off.
constexpr double kInertiaTolerance = 1e-12;

/// @brief Choose how to obtain the spectrum of a body, and prepare it.
/// @param[in] body layers at the orders m; around a center (0, 0) is the only order below 1/2, on a plane none is 0
/// @param[in] highest_n largest order n that is asked for
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @param[in] inertia_tolerance relative error of the compliance that may be left of inertia: small inertia then takes
/// a term or two, or none
[[nodiscard]] std::unique_ptr<Spectrum> make_spectrum(const HarmonicBody& body, double highest_n, int threads,
                                                      Watch& watch, double inertia_tolerance = kInertiaTolerance);

/// @brief Sums the series of one order m at a list of orders n. Several entries share the work on the coordinates.
class OrderValues {
 public:
  /// @param[in] m the order of `series`
  /// @param[in] n orders, ascending from 0, within the panels
  /// @param[in] series from `Spectrum::series`, which outlives this object
  OrderValues(double m, const Eigen::ArrayXd& n, const OrderSeries& series);

  /// @param[in] entry which entry
  /// @param[out] values physical compliance C_PQ(m, n) [m/Pa] at every n
  void evaluate(Entry entry, Eigen::ArrayXcd& values) const;

 private:
  const Eigen::ArrayXd& n_;
  const OrderSeries& series_;
  std::vector<Eigen::Index> first_;  // of the orders n on each panel, and the end of the last
  Eigen::ArrayXd coordinate_;        // of every order n on its panel
};

}  // namespace viscoroll::detail

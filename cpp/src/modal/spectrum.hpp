/// @file
/// @brief Series for the surface compliance of many orders (m, n).
///
/// At a given m every entry of the compliance is a smooth function of n^2, which a few samples determine. A `Spectrum`
/// provides it as Chebyshev series on panels of k^2 = m^2 + n^2, which `OrderValues` sums.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "base/dense_products.hpp"
#include "base/parallel.hpp"
#include "modal/chebyshev_panels.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief The six independent entries of the compliance. The others are C_phir = -C_rphi, C_thetar = -C_rtheta and
/// C_thetaphi = C_phitheta. Entries with a single theta are odd in n, the others are even.
enum class Entry { rr, rphi, rtheta, phiphi, phitheta, thetatheta };
constexpr int kEntries = 6;

/// @return whether the entry is odd in n
[[nodiscard]] constexpr bool is_odd(Entry entry) { return entry == Entry::rtheta || entry == Entry::phitheta; }

/// @return factor of the real form of layer_system.hpp in the entry
[[nodiscard]] constexpr std::complex<double> phase_of(Entry entry) {
  return entry == Entry::rphi || entry == Entry::rtheta ? std::complex<double>(0.0, -1.0) : 1.0;
}

/// @brief An entry of the 3 x 3 matrix, as an independent entry with a sign.
struct SignedEntry {
  Entry entry;
  double sign;
};

/// @return independent entry and sign of C_PQ, with P and Q in the order (r, phi, theta)
[[nodiscard]] constexpr SignedEntry entry_of(std::size_t p, std::size_t q) {
  constexpr std::array<std::array<Entry, 3>, 3> kEntryOf{{{Entry::rr, Entry::rphi, Entry::rtheta},
                                                          {Entry::rphi, Entry::phiphi, Entry::phitheta},
                                                          {Entry::rtheta, Entry::phitheta, Entry::thetatheta}}};
  return {kEntryOf[p][q], q == 0 && p > 0 ? -1.0 : 1.0};
}

/// @brief Sizes of the entries, to which their errors are compared.
///
/// The compliance is positive definite, so that C_rphi and C_rtheta are at most the geometric mean of their diagonal
/// neighbors; they may be far smaller by cancellation.
/// @param[in] rr,phiphi sizes of these two entries
/// @param[in] m_divisor,n_divisor divisors of the entries of mixed directions: m_divisor if one of the directions is
/// phi, n_divisor if one is theta, both for C_phitheta
[[nodiscard]] inline std::array<double, kEntries> entry_sizes(double rr, double phiphi, double m_divisor,
                                                              double n_divisor) {
  const double mixed = std::sqrt(rr * phiphi);
  return {rr, mixed / m_divisor, mixed / n_divisor, phiphi, phiphi / (m_divisor * n_divisor), phiphi};
}

/// @brief Largest size of the last terms of a resolved Chebyshev series, relative to the size of the entry. It is above
/// the round-off of the layer recursion.
constexpr double kSeriesTolerance = 1e-13;

/// @return tolerance of the series of a body's compliances; a crown multiplies the round-off
[[nodiscard]] inline double series_tolerance(const HarmonicBody& body) {
  return kSeriesTolerance * body.body().crown.proportion;
}

/// @brief Value of k^2 below which (0, 0) is the only order. This order has a panel of its own: on a small core, around
/// which the coating rotates almost freely, its compliance is far larger than that of other orders.
constexpr double kZeroOrder = 0.5;

/// @return value of k^2 below which the compliance of order (0, 0) is used; on a wheel, whose orders n are continuous,
/// that of the longest waves
[[nodiscard]] constexpr double end_of_zero_order(const Metric& metric) {
  constexpr double kLongestWave = 1e-10;
  return metric.is_wheel() ? kLongestWave : kZeroOrder;
}

/// @brief Compliance of one order m. Row e of a panel is entry e in the real form of layer_system.hpp [m/Pa], divided
/// by n if the entry is odd in n.
using OrderSeries = std::vector<Panel<std::complex<double>>>;

/// @brief Real values of an entry, one matrix [order m, order n] for each term of a sum: see `Spectrum::terms`.
using EntryTerms = std::vector<RowMajorMatrix>;

/// @brief Compliance series of all orders m of a body. It is immutable after construction, so that threads may share
/// it.
class Spectrum {
 public:
  virtual ~Spectrum() = default;

  /// @brief Compute the series of one order.
  /// @param[in] i index of the order m in the body's list
  /// @param[out] series panels that cover n in [0, highest_n]; the storage is reused
  virtual void series(std::size_t i, OrderSeries& series) const = 0;

  /// @brief Terms of an entry, if the compliance is a sum of a few real functions with complex factors:
  /// C_PQ(m, n) = sum_j factor(entry, i, j) terms[j](i, n), where i is the index of m. The functions do not depend on
  /// the speed.
  /// @param[in] entry entry of the compliance
  /// @param[in] n orders n, ascending, >= 0
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return one matrix [order m, order n] for each term; null if the compliance is not such a sum
  [[nodiscard]] virtual std::shared_ptr<const EntryTerms> terms(Entry /*entry*/, const Eigen::ArrayXd& /*n*/,
                                                                int /*threads*/, Watch& /*watch*/) const {
    return nullptr;
  }
  /// @return numbers that, with an entry and the orders n, determine `terms`; empty if `terms` returns null
  [[nodiscard]] virtual std::vector<double> terms_key() const { return {}; }
  /// @return factor of a term [m/Pa], see `terms`; no later term has a larger one than the first
  [[nodiscard]] virtual std::complex<double> factor(Entry /*entry*/, std::size_t /*i*/, std::size_t /*term*/) const {
    return 0.0;
  }
};

/// @brief Default relative error of the compliance due to omitted terms of the inertia series, close to round-off.
constexpr double kInertiaTolerance = 1e-12;

/// @brief Select the spectrum that suits a body and prepare it.
/// @param[in] body layers at the orders m; around a center 0 is the only order below 1/2, on a plane all orders are > 0
/// @param[in] highest_n largest order n that is evaluated
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @param[in] inertia_tolerance relative error of the compliance due to omitted inertial terms; small inertia needs at
/// most a few terms
[[nodiscard]] std::unique_ptr<Spectrum> make_spectrum(const HarmonicBody& body, double highest_n, int threads,
                                                      Watch& watch, double inertia_tolerance = kInertiaTolerance);

/// @brief Values of the series of one order m at a list of orders n. All entries share the coordinates.
class OrderValues {
 public:
  /// @param[in] m order of `series`
  /// @param[in] n orders n, ascending, >= 0, within the panels
  /// @param[in] series result of `Spectrum::series`, which must outlive this object
  OrderValues(double m, const Eigen::ArrayXd& n, const OrderSeries& series);

  /// @brief Evaluate one entry.
  /// @param[in] entry entry of the compliance
  /// @param[out] values physical compliance C_PQ(m, n) [m/Pa] at every n
  void evaluate(Entry entry, Eigen::ArrayXcd& values) const;

 private:
  const Eigen::ArrayXd& n_;
  const OrderSeries& series_;
  std::vector<Eigen::Index> first_;  // index of the first order n on each panel, and the end of the last panel
  Eigen::ArrayXd coordinate_;        // coordinate of every order n on its panel
};

}  // namespace viscoroll::detail

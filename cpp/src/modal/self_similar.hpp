/// @file
/// @brief Spectrum of spheres and planes whose layers share one relaxation function. One response serves all orders m.
#pragma once

#include <complex>
#include <memory>
#include <optional>
#include <vector>

#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Spectrum of layers with the moduli mu_l*(w) = c_l g(w) and real, constant Poisson's ratios.
///
/// Without inertia the compliance is F(k) / g(m Omega), where F is real and, except for the rotation from the direction
/// of k to phi and theta, a function of k^2 = m^2 + n^2 only. Inertia enters through
/// eta = rho Omega^2 r_o^2 / g(m Omega), the complex square of a Mach number, which is small in most rolling. F is
/// analytic in eta, and its j-th coefficient is a polynomial in m^2 of degree at most j + 1 at a given k^2, so that a
/// few terms represent all orders:
///
///     C_mn = 1/g(m Omega) sum_j eta^j sum_i m^(2i) f_ji(k^2).
class SelfSimilarSpectrum final : public Spectrum {
 public:
  /// @param[in] body layers at the orders m
  /// @param[in] highest_n largest order n that is evaluated
  /// @param[in] inertia_tolerance relative size of the omitted terms of the inertia series
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return spectrum; none for wheels, for layers that do not share one relaxation function, for bodies with inertia
  /// that are not spheres, and for speeds at which a few terms of the series do not suffice
  [[nodiscard]] static std::unique_ptr<SelfSimilarSpectrum> try_make(const HarmonicBody& body, double highest_n,
                                                                     double inertia_tolerance, int threads,
                                                                     Watch& watch);

  void series(std::size_t i, OrderSeries& series) const override;
  [[nodiscard]] std::shared_ptr<const EntryTerms> terms(Entry entry, const Eigen::ArrayXd& n, int threads,
                                                        Watch& watch) const override;
  [[nodiscard]] std::vector<double> terms_key() const override;
  [[nodiscard]] std::complex<double> factor(Entry entry, std::size_t i, std::size_t term) const override;

  /// @brief Series that do not depend on the speed.
  struct Response {
    std::optional<int> inertia_order;   ///< largest j; none if a few terms do not suffice
    std::vector<Panel<double>> panels;  ///< row (entry, j, i), see row_of
  };

 private:
  SelfSimilarSpectrum() = default;

  /// Call function(panel) for the panels of an order m.
  template <class Function>
  void for_panels(double m, const Function& function) const;

  std::shared_ptr<const Response> response_;
  std::vector<double> properties_;  // all numbers that determine the response
  double highest_n_ = 0.0;
  std::vector<double> orders_;                     // m
  std::vector<std::complex<double>> per_modulus_;  // 1 / g(m Omega) [1/Pa], for each m
  std::vector<std::complex<double>> inertia_;      // eta in the unit of the response, for each m
};

}  // namespace viscoroll::detail

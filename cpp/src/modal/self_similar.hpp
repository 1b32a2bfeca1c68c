/// @file
/// @brief Spectrum of spheres and planes whose layers share one relaxation function: one response for all orders m.
#pragma once

#include <memory>
#include <vector>

#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Compliance of layers with moduli mu_l*(w) = c_l g(w) and real, constant Poisson's ratios.
///
/// Without inertia it is F(k) / g(m Omega), F real and (but for the rotation from the direction of k to phi and theta)
/// a function of k^2 = m^2 + n^2 alone. Inertia enters by eta = rho Omega^2 r_o^2 / g(m Omega), the complex square of a
/// Mach number, tiny in most rolling. F is analytic in eta, and its j-th coefficient is a polynomial of degree j + 1 in
/// m^2 at a given k^2, so a few terms serve every order:
///
///     C_mn = 1/g(m Omega) sum_j eta^j sum_i m^(2i) f_ji(k^2).
class SelfSimilarSpectrum final : public Spectrum {
 public:
  /// @param[in] body layers of a sphere, or of a plane without inertia, at the orders m
  /// @param[in] highest_n largest order n that is asked for
  /// @param[in] inertia_tolerance relative size of the terms of the inertia series that are left out
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return nothing for layers that are not self-similar, or too fast for a few terms of the series
  [[nodiscard]] static std::unique_ptr<SelfSimilarSpectrum> try_make(const HarmonicBody& body, double highest_n,
                                                                     double inertia_tolerance, int threads,
                                                                     Watch& watch);

  void series(std::size_t i, OrderSeries& series) const override;

 private:
  SelfSimilarSpectrum() = default;

  int inertia_order_ = 0;  // largest j
  double highest_n_ = 0.0;
  std::vector<double> orders_;                 // m
  std::vector<std::complex<double>> modulus_;  // g(m Omega) [Pa], for each m
  std::vector<std::complex<double>> inertia_;  // eta / largest |eta|, for each m
  std::vector<Panel<double>> panels_;          // row (entry, j, i), see row_of
};

}  // namespace viscoroll::detail

/// @file
/// @brief Spectrum of a plane whose layers and base share one relaxation function: one response for all orders m.
#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "modal/harmonic_plane.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Compliance of a plane without inertia, with moduli mu_l*(w) = c_l g(w) and real, constant Poisson's ratios:
/// real functions of k alone over g.
class SelfSimilarPlane final : public Spectrum {
 public:
  /// @return nothing for a plane that is not self-similar
  [[nodiscard]] static std::unique_ptr<SelfSimilarPlane> try_make(const HarmonicPlane& plane, double highest_n);

  void series(std::size_t i, OrderSeries& series) const override;

 private:
  SelfSimilarPlane() = default;

  std::vector<double> orders_;                 // m
  std::vector<std::complex<double>> modulus_;  // g [Pa], for each m
  std::vector<Panel<double>> panels_;          // over k^2, of uu, uk/k, kk, pp and (kk - pp)/k^2
};

}  // namespace viscoroll::detail

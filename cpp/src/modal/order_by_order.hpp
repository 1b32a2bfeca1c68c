/// @file
/// @brief Spectrum of any coating: each order m sampled along n by itself.
#pragma once

#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Solves the layers at the Chebyshev nodes of every order m: about thirty solutions in place of N_t.
class OrderByOrderSpectrum final : public Spectrum {
 public:
  explicit OrderByOrderSpectrum(const HarmonicCoating& coating) : coating_(coating) {}

  void series(int m, OrderSeries& series) const override;

 private:
  HarmonicCoating coating_;
};

}  // namespace viscoroll::detail

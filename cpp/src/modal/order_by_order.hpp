/// @file
/// @brief Spectrum of any coating: each order m sampled along n by itself.
#pragma once

#include <utility>

#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Solves the layers at the Chebyshev nodes of every order m: about thirty solutions in place of N_t.
class OrderByOrderSpectrum final : public Spectrum {
 public:
  OrderByOrderSpectrum(HarmonicCoating coating, double highest_n)
      : coating_(std::move(coating)), highest_n_(highest_n) {}

  void series(std::size_t i, OrderSeries& series) const override;

 private:
  HarmonicCoating coating_;
  double highest_n_;
};

}  // namespace viscoroll::detail

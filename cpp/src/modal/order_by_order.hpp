/// @file
/// @brief Spectrum of any body that samples every order m separately along n.
#pragma once

#include <memory>
#include <utility>

#include "modal/harmonic_body.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Spectrum that solves the layers at the Chebyshev nodes of every order m: about thirty solutions in place of
/// N_t.
class OrderByOrderSpectrum final : public Spectrum {
 public:
  OrderByOrderSpectrum(std::shared_ptr<const HarmonicBody> body, double highest_n)
      : body_(std::move(body)), highest_n_(highest_n) {}

  void series(std::size_t i, OrderSeries& series) const override;

 private:
  std::shared_ptr<const HarmonicBody> body_;
  double highest_n_;
};

}  // namespace viscoroll::detail

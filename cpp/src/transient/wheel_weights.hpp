/// @file
/// @brief Weights of all orders of a wheel, which are functions of both m and n.
#pragma once

#include <vector>

#include "base/parallel.hpp"
#include "transient/layer_spectrum.hpp"
#include "transient/weight_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Weights C_0(m, n), C_1(m, n), ... of layers without inertia. At a given k^2 = m^2 + n^2 they vary little with
/// the direction of k and are nearly polynomials in m^2 / k^2. They are stored as Chebyshev series in m^2 / k^2 and in
/// ln k^2; for m = 0, in ln k^2 only.
class WheelWeights final : public OrderWeights {
 public:
  /// @param[in] layers layers of a wheel, or of a cylinder under one
  /// @param[in] highest_m,highest_n range of the orders; m is 0 or at least 1
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  WheelWeights(const LayerSpectrum& layers, double highest_m, double highest_n, int threads, Watch& watch);

  void series(std::size_t weight, double m, double highest_n, OrderSeries& series) const override;

 private:
  std::vector<Panel<double>> zero_;    // m = 0: row (weight, entry)
  std::vector<Panel<double>> panels_;  // row (weight, term in m^2 / k^2, entry)
};

}  // namespace viscoroll::detail

/// @file
/// @brief Weights of all orders of a sphere or a plane, as functions of k^2 = m^2 + n^2 only.
#pragma once

#include <vector>

#include "base/parallel.hpp"
#include "transient/layer_spectrum.hpp"
#include "transient/weight_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Weights C_0(k), C_1(k), ... of layers without inertia, as Chebyshev series in ln k^2.
class WeightPanels final : public OrderWeights {
 public:
  /// @param[in] layers of a sphere or a plane
  /// @param[in] lowest_m,highest_m,highest_n range of the orders
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  WeightPanels(const LayerSpectrum& layers, double lowest_m, double highest_m, double highest_n, int threads,
               Watch& watch);

  void series(std::size_t weight, double m, double highest_n, OrderSeries& series) const override;

 private:
  std::vector<Panel<double>> panels_;  // row kFunctions * weight + function
};

}  // namespace viscoroll::detail

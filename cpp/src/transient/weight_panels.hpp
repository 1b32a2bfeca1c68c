/// @file
/// @brief The weights of all orders of a sphere or a plane, as functions of k^2 = m^2 + n^2 alone.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "modal/spectrum.hpp"
#include "parallel.hpp"
#include "transient/layer_spectrum.hpp"

namespace viscoroll::detail {

/// @brief C_0(k), C_1(k), ... of layers without inertia, as Chebyshev series in ln k^2.
class WeightPanels {
 public:
  /// @param[in] layers of a sphere or a plane
  /// @param[in] lowest_m,highest_m,highest_n of the orders asked for
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  WeightPanels(const LayerSpectrum& layers, double lowest_m, double highest_m, double highest_n, int threads,
               Watch& watch);

  /// @brief Series of one weight at an order m, as `Spectrum::series`.
  void series(std::size_t weight, double m, double highest_n, OrderSeries& series) const;

 private:
  std::vector<Panel<double>> panels_;  // row kFunctions * weight + function
};

/// @brief One of the weights at a list of orders, as if it were the compliance of a body.
class WeightSpectrum final : public Spectrum {
 public:
  /// @param[in] panels of all weights
  /// @param[in] weight its number
  /// @param[in] orders m
  /// @param[in] highest_n largest order n that is asked for
  WeightSpectrum(std::shared_ptr<const WeightPanels> panels, std::size_t weight, std::vector<double> orders,
                 double highest_n)
      : panels_(std::move(panels)), weight_(weight), orders_(std::move(orders)), highest_n_(highest_n) {}

  void series(std::size_t i, OrderSeries& series) const override {
    panels_->series(weight_, orders_[i], highest_n_, series);
  }

 private:
  std::shared_ptr<const WeightPanels> panels_;
  std::size_t weight_;
  std::vector<double> orders_;
  double highest_n_;
};

}  // namespace viscoroll::detail

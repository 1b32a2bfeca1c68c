/// @file
/// @brief One of the weights of layers at a list of orders, in the form of the compliance of a body.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Weights C_0, C_1, ... of all orders. Immutable: threads may share it.
class OrderWeights {
 public:
  virtual ~OrderWeights() = default;

  /// @brief Series of one weight at an order, same as in `Spectrum::series`.
  /// @param[in] weight number of the weight
  /// @param[in] m order along
  /// @param[in] highest_n largest order n that is evaluated
  /// @param[out] series panels that cover n in [0, highest_n]
  virtual void series(std::size_t weight, double m, double highest_n, OrderSeries& series) const = 0;
};

/// @brief Spectrum of one weight.
class WeightSpectrum final : public Spectrum {
 public:
  /// @param[in] weights all weights
  /// @param[in] weight number of the weight
  /// @param[in] orders orders m
  /// @param[in] highest_n largest order n that is evaluated
  WeightSpectrum(std::shared_ptr<const OrderWeights> weights, std::size_t weight, std::vector<double> orders,
                 double highest_n)
      : weights_(std::move(weights)), weight_(weight), orders_(std::move(orders)), highest_n_(highest_n) {}

  void series(std::size_t i, OrderSeries& series) const override {
    weights_->series(weight_, orders_[i], highest_n_, series);
  }

 private:
  std::shared_ptr<const OrderWeights> weights_;
  std::size_t weight_;
  std::vector<double> orders_;
  double highest_n_;
};

}  // namespace viscoroll::detail

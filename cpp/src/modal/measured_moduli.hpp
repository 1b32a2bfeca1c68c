/// @file
/// @brief Interpolation of measured moduli between the orders of a run.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief Measured moduli of layers on a run of orders without kinks, as polynomials in ln m.
///
/// The polynomials interpolate the moduli at some of the orders. These are Leja points: each one maximizes the product
/// of the distances to the previous ones, which makes the interpolation well conditioned. Points are added until the
/// polynomials agree with the moduli at all orders of the run. Between the orders the polynomials supply moduli without
/// an evaluation of the user's function.
class MeasuredModuli {
 public:
  /// @brief Moduli of no layer.
  MeasuredModuli() = default;

  /// @brief Interpolate the moduli of a run.
  /// @param[in] body layers at the orders m
  /// @param[in] orders indices of the orders of the run, at least one, with m > 0 ascending
  /// @param[in] max_terms largest number of terms of a polynomial
  /// @return polynomials; none if `max_terms` terms do not agree with the moduli at every order of the run
  [[nodiscard]] static std::optional<MeasuredModuli> try_make(const HarmonicBody& body,
                                                              std::span<const std::size_t> orders, int max_terms);

  /// @brief Evaluate the polynomials.
  /// @param[in] orders orders m within the run
  /// @return moduli [Pa], a row for each order and a column for each of `measured_layers`
  [[nodiscard]] Eigen::ArrayXXcd at(std::span<const double> orders) const;

 private:
  [[nodiscard]] double coordinate(double m) const;

  double lowest_m_ = 1.0;
  double highest_m_ = 1.0;
  // Newton's form: sum_j coefficients_[j] prod_{i < j} 2 (x - nodes_[i]), x from -1 to 1
  std::vector<double> nodes_;
  std::vector<Eigen::ArrayXcd> coefficients_;  // for each term, one number for each layer
  Eigen::Index layers_ = 0;
};

}  // namespace viscoroll::detail

/// @file
/// @brief Moduli of which only values are known, between those values.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {

/// @brief The measured moduli of layers on a run of orders without kinks: polynomials of ln m.
///
/// They go through the values at some of the orders, taken one after another where the product of the distances to
/// those before is largest (Leja's points, on which a polynomial is well conditioned), until they meet the values at
/// all others. Between the orders they stand for moduli that nobody has asked for.
class MeasuredModuli {
 public:
  /// @brief Those of no layer.
  MeasuredModuli() = default;

  /// @brief Those of a run.
  /// @param[in] body layers at the orders m
  /// @param[in] orders numbers of the orders of the run, at least one, with m > 0 ascending
  /// @param[in] most_terms of a polynomial
  /// @return nothing where so many terms do not meet the moduli at every order of the run
  [[nodiscard]] static std::optional<MeasuredModuli> try_make(const HarmonicBody& body,
                                                              std::span<const std::size_t> orders, int most_terms);

  /// @param[in] orders m within the run
  /// @return moduli [Pa], a row for each order and a column for each of `measured_layers`
  [[nodiscard]] Eigen::ArrayXXcd at(std::span<const double> orders) const;

 private:
  [[nodiscard]] double coordinate(double m) const;

  double lowest_m_ = 1.0;
  double highest_m_ = 1.0;
  // Newton's form: sum_j coefficients_[j] prod_{i < j} 2 (x - nodes_[i]), x from -1 to 1
  std::vector<double> nodes_;
  std::vector<Eigen::ArrayXcd> coefficients_;  // of each layer
  Eigen::Index layers_ = 0;
};

}  // namespace viscoroll::detail

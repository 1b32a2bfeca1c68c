/// @file
/// @brief What transforms cost at one length and another: a fit to measured times, of each library's own.
#pragma once

namespace viscoroll::detail {

/// @brief Nanoseconds for each number of a line, to and fro: a part of every line and one for each factor of its
/// length.
///
/// Only ratios matter, to choose among lengths: from machine to machine they differ less than the times.
struct FftCost {
  double least;
  double factor_2;
  double factor_3;
  double factor_5;
  double factor_7;
};

// Each defined beside the transform that was measured.
extern const FftCost kComplexFftCost;
extern const FftCost kRealFftCost;

}  // namespace viscoroll::detail

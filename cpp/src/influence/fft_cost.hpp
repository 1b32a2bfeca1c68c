/// @file
/// @brief Cost of a transform as a function of its length, fitted to measured times of each library.
#pragma once

namespace viscoroll::detail {

/// @brief Time [ns] per number of a line for a forward and a backward transform: a constant plus a contribution of each
/// prime factor of the length.
///
/// Only ratios matter, since the cost is used to choose among lengths. Ratios differ less between machines than times
/// do.
struct FftCost {
  double least;
  double factor_2;
  double factor_3;
  double factor_5;
  double factor_7;
};

// Defined next to the transform that was measured.
extern const FftCost kComplexFftCost;
extern const FftCost kRealFftCost;

}  // namespace viscoroll::detail

/// @file
/// @brief Lengths at which products are fast: a power of two may take less time than a shorter length with many
/// factors.
#include <limits>

#include "influence/fft.hpp"

namespace viscoroll::detail {
namespace {

// Both axes are transformed, each as real lines. The time per number of a period is that of this axis, plus that of the
// other axis at a typical length, plus that of the product, which is limited by memory.
constexpr int kTypicalLength = 1024;
constexpr double kProduct = 4.0;  // [ns], in the units of the costs

/// @return time per number of a line [ns], or infinity if the length has other factors
double time_per_number(int length, const FftCost& cost) {
  double time = cost.least;
  const auto divide = [&](int factor, double more) {
    for (; length % factor == 0; length /= factor) time += more;
  };
  divide(2, cost.factor_2);
  divide(3, cost.factor_3);
  divide(5, cost.factor_5);
  divide(7, cost.factor_7);
  return length == 1 ? time : std::numeric_limits<double>::infinity();
}

int fastest(int length, const FftCost& own) {
  const double rest = time_per_number(kTypicalLength, kRealFftCost) + kProduct;
  int best = length;
  double least = std::numeric_limits<double>::infinity();
  // Costs were measured at even lengths. The candidates up to twice the length contain a power of two.
  for (int candidate = length + length % 2; candidate <= 2 * length; candidate += 2) {
    const double time = candidate * (time_per_number(candidate, own) + rest);
    if (time < least) {
      best = candidate;
      least = time;
    }
  }
  return best;
}

}  // namespace

int ComplexFft::fast_length(int length) { return fastest(length, kComplexFftCost); }

int RealFft::fast_length(int length) { return fastest(length, kRealFftCost); }

}  // namespace viscoroll::detail

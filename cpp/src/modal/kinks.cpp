#include "modal/kinks.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "modal/chebyshev_panels.hpp"

namespace viscoroll::detail {

double highest_kink(const ShearModulus& modulus, double low, double high) {
  constexpr double kTolerance = 1e-8;
  constexpr int kUnused = 4;  // number of last terms that must be negligible
  if (!(low < high)) return 0.0;
  const double ratio = std::min(2.0, high / low);
  std::vector<double> frequencies;
  std::vector<double> ends;
  // The octaves overlap by half, because a kink may lie on the border of an octave.
  for (double end = high; ends.empty() || end * std::numbers::sqrt2 > low * ratio; end /= std::numbers::sqrt2) {
    ends.push_back(std::max(end, low * ratio));
    std::ranges::copy(panel_nodes(ends.back() / ratio, ends.back()), std::back_inserter(frequencies));
  }
  std::vector<std::complex<double>> moduli;
  try {
    moduli = complex_modulus(modulus, frequencies);
  } catch (const std::invalid_argument&) {
    return high;  // the evaluation at the orders later reports the frequency without a value
  }
  for (std::size_t octave = 0; octave < ends.size(); ++octave) {
    const Eigen::Map<const Eigen::RowVectorXcd> values(moduli.data() + octave * kPanelNodes, kPanelNodes);
    const Eigen::RowVectorXcd series = values * panel_transform();
    if (series.tail(kUnused).cwiseAbs().maxCoeff() > kTolerance * values.cwiseAbs().maxCoeff()) return ends[octave];
  }
  return 0.0;
}

}  // namespace viscoroll::detail

#include "contact/traction_law.hpp"

#include <array>
#include <cmath>

namespace viscoroll::detail {
namespace {

/// Spacings per cohesive length. With three or more, a mesh causes no hysteresis of its own (docs/theory/adhesion.md).
/// With four, the edges of an elastic roller still stick to nodes so much that Newton's method fails on the path to the
/// largest tension; with six it reaches it to half a percent.
constexpr double kSpacingsPerLength = 6.0;

/// Fractions of the rolling speed at which works are tabulated: powers of 1/sqrt(2), from 1 downwards.
constexpr int kFractions = 21;

}  // namespace

double Attraction::resolved_length() const { return std::max(cohesive_length, kSpacingsPerLength * spacing); }

double Attraction::peak_of(double length) const { return std::sqrt(modulus * work / length); }

TractionLaw Attraction::law(double length, double center) const {
  const double peak = peak_of(length);
  TractionLaw law{.peak = peak, .work = Eigen::ArrayXd(x.size())};
  const bool is_line = z.isZero(0.0);
  const int count = is_line ? 1 : kFractions;
  std::array<WorksAtEdges, kFractions> table{};
  for (int i = 0; i < count; ++i) table[static_cast<std::size_t>(i)] = works(peak, std::pow(2.0, -0.5 * i));
  for (Eigen::Index node = 0; node < x.size(); ++node) {
    const double ahead = x[node] - center;
    const double distance = std::hypot(ahead, z[node]);
    // Works are interpolated linearly in the logarithm of the speed, since they change over decades of it.
    const double place = distance > 0.0 && !is_line
                             ? std::clamp(-2.0 * std::log2(std::abs(ahead) / distance), 0.0, kFractions - 1.001)
                             : 0.0;
    const auto low = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(low);
    const auto& slower = table[is_line ? 0 : low + 1];
    law.work[node] = ahead > 0.0 ? (1.0 - share) * table[low].closing + share * slower.closing
                                 : (1.0 - share) * table[low].opening + share * slower.opening;
  }
  return law;
}

}  // namespace viscoroll::detail

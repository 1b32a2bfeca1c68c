#include "contact/traction_law.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace viscoroll::detail {
namespace {

/// Fractions of the rolling speed at which works are tabulated: powers of 1/sqrt(2), from 1 downwards.
constexpr int kFractions = 21;

}  // namespace

double Attraction::resolved_zone() const { return std::max(kSpacingsPerZone * spacing, shortest_zone); }

TractionLaw Attraction::law(double zone, const ContactSize& contact) const {
  TractionLaw law{.peak = Eigen::ArrayXd(x.size()), .work = Eigen::ArrayXd(x.size())};
  const bool is_line = z.isZero(0.0);
  std::array<std::optional<EdgeLaws>, kFractions> table{};
  const auto laws_at = [&](std::size_t i) -> const EdgeLaws& {
    if (!table[i]) table[i] = laws(zone, std::pow(2.0, -0.5 * static_cast<double>(i)), contact);
    return *table[i];
  };
  for (Eigen::Index node = 0; node < x.size(); ++node) {
    const double ahead = x[node] - contact.center;
    const double distance = std::hypot(ahead, z[node]);
    // Laws are interpolated linearly in the logarithm of the speed, since they change over decades of it.
    const double place = distance > 0.0 && !is_line
                             ? std::clamp(-2.0 * std::log2(std::abs(ahead) / distance), 0.0, kFractions - 1.001)
                             : 0.0;
    const auto low = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(low);
    const EdgeLaws& faster = laws_at(low);
    const EdgeLaws& slower = laws_at(is_line ? 0 : low + 1);
    const auto& [faster_edge, slower_edge] =
        ahead > 0.0 ? std::pair(faster.closing, slower.closing) : std::pair(faster.opening, slower.opening);
    law.peak[node] = std::lerp(faster_edge.peak, slower_edge.peak, share);
    law.work[node] = std::lerp(faster_edge.work, slower_edge.work, share);
  }
  return law;
}

}  // namespace viscoroll::detail

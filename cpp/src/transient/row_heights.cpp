#include "transient/row_heights.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "base/validate.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// A profile of zeros is the smooth surface, to the last digit.
std::optional<HeightProfile> unless_smooth(const std::optional<HeightProfile>& profile) {
  if (!profile || std::ranges::all_of(profile->height, [](double height) { return height == 0.0; }))
    return std::nullopt;
  return profile;
}

double largest_of(const std::optional<HeightProfile>& profile) {
  return profile ? *std::ranges::max_element(profile->height) : 0.0;
}

/// Reject a tread that does not close around the body. Its texture may repeat a whole number of times.
void require_fit(const HeightProfile& tread, double circumference) {
  constexpr double kRoundOff = 1e-6;
  const double first = tread.distance.front();
  const double last = tread.distance.back();
  if (tread.periodic) {
    const double times = circumference / (last - first);
    if (std::abs(times - std::round(times)) <= kRoundOff * times && times > 0.5) return;
    reject("tread.distance",
           "such that the circumference, " + rounded(circumference) + " m, is a multiple of the period",
           "a period of " + text(last - first) + " m");
  }
  if (first >= 0.0 && last <= circumference * (1.0 + kRoundOff)) return;
  reject("tread.distance", "in [0, " + rounded(circumference) + "] m, the circumference",
         text(first) + " to " + text(last) + " m", Range{.unit = "m", .minimum = 0.0, .maximum = circumference});
}

/// Number that identifies a profile: a hash of its bits, shortened to the precision of the numbers of a state.
double key_of(const std::optional<HeightProfile>& profile) {
  if (!profile) return 0.0;
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a, by 64-bit words
  const auto add = [&](double value) {
    hash ^= std::bit_cast<std::uint64_t>(value);
    hash *= 1099511628211U;
    hash ^= hash >> 32U;
  };
  for (const double distance : profile->distance) add(distance);
  for (const double height : profile->height) add(height);
  add(profile->periodic ? 1.0 : 0.0);
  return static_cast<double>(hash >> 11U) + 1.0;
}

}  // namespace

SurfaceHeights::SurfaceHeights(const HistoryOptions& options, const SurfaceGrid& grid)
    : grid_(grid),
      rows_around_(std::lround(2.0 * std::numbers::pi / grid.phi_spacing)),
      ground_(unless_smooth(options.ground)),
      tread_(unless_smooth(options.tread)),
      largest_(largest_of(ground_) + largest_of(tread_)) {
  if (tread_) require_fit(*tread_, 2.0 * std::numbers::pi * grid.radius);
}

RowHeights SurfaceHeights::at(const TrackRows& rows) const {
  if (are_smooth()) return {};
  const double spacing = grid_.radius * grid_.phi_spacing;
  const auto distance = [&](Index row) { return -(static_cast<double>(row) + rows.shift) * spacing; };
  RowHeights heights{.ground = ArrayXd::Zero(rows.count), .tread = ArrayXd::Zero(rows.count)};
  for (Index i = 0; i < rows.count; ++i) {
    const Index row = rows.first + i;
    if (ground_) heights.ground[i] = height_at(*ground_, distance(row) + rows.ahead);
    if (!tread_) continue;
    // The same row always has the same distance, to the last digit.
    const Index around = ((row % rows_around_) + rows_around_) % rows_around_;
    const double place = static_cast<double>(rows_around_ - around) - rows.shift;
    heights.tread[i] = height_at(*tread_, (place < static_cast<double>(rows_around_) ? place : 0.0) * spacing);
  }
  return heights;
}

void SurfaceHeights::write(NumberWriter& numbers) const {
  numbers.put(key_of(ground_));
  numbers.put(key_of(tread_));
}

void SurfaceHeights::require_same(NumberReader& numbers) const {
  const double ground = numbers.get();
  const double tread = numbers.get();
  if (ground != key_of(ground_)) reject("start", "a state with the same ground", "a state with another ground");
  if (tread != key_of(tread_)) reject("start", "a state with the same tread", "a state with another tread");
}

}  // namespace viscoroll::detail

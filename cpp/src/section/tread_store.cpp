#include "section/tread_store.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace viscoroll::detail {
namespace {

/// As many as a study takes turns with; some megabytes each.
constexpr std::size_t kKept = 8;

/// All that a difference depends on.
using Key = std::vector<double>;

Key key_of(const CoatedWheel& wheel, const HarmonicBody& body, bool tangential) {
  Key key{tangential ? 1.0 : 0.0, wheel.core_radius, wheel.width, wheel.crown_radius,
          wheel.hub == Hub::crowned ? 1.0 : 0.0};
  for (const Layer& layer : wheel.layers) key.push_back(layer.thickness);
  for (std::size_t order = 0; order < body.orders().size(); ++order) {
    for (const auto& [shear, lame] : section_media(body, order)) {
      key.insert(key.end(), {shear.real(), shear.imag(), lame.real(), lame.imag()});
    }
  }
  return key;
}

/// But for the round-off of ratios of moduli.
bool are_alike(const Key& first, const Key& second) {
  constexpr double kRoundOff = 1e-12;
  return std::ranges::equal(first, second, [](double a, double b) {
    return a == b || std::abs(a - b) <= kRoundOff * std::max(std::abs(a), 1.0);
  });
}

class TreadStore {
 public:
  [[nodiscard]] std::shared_ptr<const SampledDifference> find(const Key& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) { return are_alike(entry.first, key); });
    return found == entries_.end() ? nullptr : found->second;
  }

  void add(Key key, std::shared_ptr<const SampledDifference> difference) {
    const std::scoped_lock lock(mutex_);
    entries_.emplace_front(std::move(key), std::move(difference));
    if (entries_.size() > kKept) entries_.pop_back();
  }

 private:
  using Entry = std::pair<Key, std::shared_ptr<const SampledDifference>>;

  std::mutex mutex_;
  std::deque<Entry> entries_;  // the latest first
};

TreadStore& treads() {
  static TreadStore store;
  return store;
}

}  // namespace

std::shared_ptr<const SampledDifference> kept_difference(const CoatedWheel& wheel, const HarmonicBody& body,
                                                         bool tangential, int threads, Watch& watch) {
  Key key = key_of(wheel, body, tangential);
  if (auto kept = treads().find(key)) return kept;
  // Not under the lock: others may want another tread meanwhile.
  auto difference =
      std::make_shared<const SampledDifference>(SideDifference(wheel, tangential).sampled(body, threads, watch));
  treads().add(std::move(key), difference);
  return difference;
}

}  // namespace viscoroll::detail

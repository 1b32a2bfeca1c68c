#include "section/tread_cache.hpp"

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

/// Largest number of cached treads. A study that alternates among a few treads then finds all of them in the cache. A
/// tread takes a few megabytes, or about ten times as much if its layers have different relaxation functions.
constexpr std::size_t kMaxTreads = 8;
constexpr Eigen::Index kMaxNumbers = 16777216;  // largest number of complex numbers in the cache, 256 MB

/// All numbers that determine the difference between a tread with faces and an endless one.
using Key = std::vector<double>;

Key key_of(const CoatedWheel& wheel, bool tangential, const std::vector<double>& numbers) {
  Key key{tangential ? 1.0 : 0.0, wheel.core_radius, wheel.width, wheel.crown_radius,
          wheel.hub == Hub::crowned ? 1.0 : 0.0};
  for (const Layer& layer : wheel.layers) key.push_back(layer.thickness);
  key.insert(key.end(), numbers.begin(), numbers.end());
  return key;
}

/// Whether two keys are equal to within the round-off of ratios of moduli. An infinite number, such as the crown radius
/// of a flat tread, only equals another infinite number of the same sign.
bool are_equal(const Key& first, const Key& second) {
  constexpr double kRoundOff = 1e-12;
  return std::ranges::equal(first, second, [](double a, double b) {
    return a == b || std::abs(a - b) <= kRoundOff * std::max(std::min(std::abs(a), std::abs(b)), 1.0);
  });
}

using Differences = std::shared_ptr<const std::vector<SampledDifference>>;

class TreadCache {
 public:
  [[nodiscard]] Differences find(const Key& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) { return are_equal(entry.first, key); });
    return found == entries_.end() ? nullptr : found->second;
  }

  void add(Key key, Differences differences) {
    const std::scoped_lock lock(mutex_);
    entries_.emplace_front(std::move(key), std::move(differences));
    while (entries_.size() > 1 && (entries_.size() > kMaxTreads || numbers() > kMaxNumbers)) entries_.pop_back();
  }

 private:
  using Entry = std::pair<Key, Differences>;

  /// Number of complex numbers in the cache.
  [[nodiscard]] Eigen::Index numbers() const {
    Eigen::Index sum = 0;
    for (const auto& [key, differences] : entries_) {
      for (const SampledDifference& one : *differences) {
        for (const Eigen::MatrixXcd& part : one.parts) sum += part.size();
      }
    }
    return sum;
  }

  std::mutex mutex_;
  std::deque<Entry> entries_;  // the most recently added first
};

TreadCache& treads() {
  static TreadCache store;
  return store;
}

}  // namespace

Differences cached_differences(const CoatedWheel& wheel, bool tangential, const std::vector<double>& numbers,
                               const std::function<std::vector<SampledDifference>()>& compute) {
  Key key = key_of(wheel, tangential, numbers);
  if (auto cached = treads().find(key)) return cached;
  // The computation does not hold the lock, so that other threads can use the cache meanwhile.
  auto differences = std::make_shared<const std::vector<SampledDifference>>(compute());
  treads().add(std::move(key), differences);
  return differences;
}

std::shared_ptr<const SampledDifference> cached_difference(const CoatedWheel& wheel, const HarmonicBody& body,
                                                           bool tangential, int threads, Watch& watch) {
  std::vector<double> numbers;
  for (std::size_t order = 0; order < body.orders().size(); ++order) {
    for (const auto& [shear, lame] : section_media(body, order)) {
      numbers.insert(numbers.end(), {shear.real(), shear.imag(), lame.real(), lame.imag()});
    }
  }
  const auto differences = cached_differences(wheel, tangential, numbers, [&] {
    return std::vector{SideDifference(wheel, tangential).sampled(body, threads, watch)};
  });
  return {differences, &differences->front()};
}

}  // namespace viscoroll::detail

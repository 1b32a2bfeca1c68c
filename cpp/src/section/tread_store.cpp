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

/// Number of cached treads, enough for those among which a study alternates. Each takes some megabytes, or about ten
/// times as many for layers with different relaxation functions.
constexpr std::size_t kKept = 8;
constexpr Eigen::Index kMostNumbers = 16777216;  // largest number of complex numbers in the cache, 256 MB

/// All numbers on which a difference depends.
using Key = std::vector<double>;

Key key_of(const CoatedWheel& wheel, bool tangential, const std::vector<double>& numbers) {
  Key key{tangential ? 1.0 : 0.0, wheel.core_radius, wheel.width, wheel.crown_radius,
          wheel.hub == Hub::crowned ? 1.0 : 0.0};
  for (const Layer& layer : wheel.layers) key.push_back(layer.thickness);
  key.insert(key.end(), numbers.begin(), numbers.end());
  return key;
}

/// Whether two keys are equal except for the round-off of ratios of moduli. Infinite numbers, such as the radius of a
/// missing crown, are equal to themselves only.
bool are_alike(const Key& first, const Key& second) {
  constexpr double kRoundOff = 1e-12;
  return std::ranges::equal(first, second, [](double a, double b) {
    return a == b || std::abs(a - b) <= kRoundOff * std::max(std::min(std::abs(a), std::abs(b)), 1.0);
  });
}

using Differences = std::shared_ptr<const std::vector<SampledDifference>>;

class TreadStore {
 public:
  [[nodiscard]] Differences find(const Key& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) { return are_alike(entry.first, key); });
    return found == entries_.end() ? nullptr : found->second;
  }

  void add(Key key, Differences differences) {
    const std::scoped_lock lock(mutex_);
    entries_.emplace_front(std::move(key), std::move(differences));
    while (entries_.size() > 1 && (entries_.size() > kKept || numbers() > kMostNumbers)) entries_.pop_back();
  }

 private:
  using Entry = std::pair<Key, Differences>;

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
  std::deque<Entry> entries_;  // the most recent first
};

TreadStore& treads() {
  static TreadStore store;
  return store;
}

}  // namespace

Differences kept_differences(const CoatedWheel& wheel, bool tangential, const std::vector<double>& numbers,
                             const std::function<std::vector<SampledDifference>()>& find) {
  Key key = key_of(wheel, tangential, numbers);
  if (auto kept = treads().find(key)) return kept;
  // Without the lock, because other threads may need another tread meanwhile.
  auto differences = std::make_shared<const std::vector<SampledDifference>>(find());
  treads().add(std::move(key), differences);
  return differences;
}

std::shared_ptr<const SampledDifference> kept_difference(const CoatedWheel& wheel, const HarmonicBody& body,
                                                         bool tangential, int threads, Watch& watch) {
  std::vector<double> numbers;
  for (std::size_t order = 0; order < body.orders().size(); ++order) {
    for (const auto& [shear, lame] : section_media(body, order)) {
      numbers.insert(numbers.end(), {shear.real(), shear.imag(), lame.real(), lame.imag()});
    }
  }
  const auto kept = kept_differences(wheel, tangential, numbers, [&] {
    return std::vector{SideDifference(wheel, tangential).sampled(body, threads, watch)};
  });
  return {kept, &kept->front()};
}

}  // namespace viscoroll::detail

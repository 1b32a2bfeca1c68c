/// @file
/// @brief Results that were computed last in this process, found by the numbers that determine them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace viscoroll::detail {

/// @brief Cache of the results that were added last. Threads may share it.
template <class Value>
class RecentCache {
 public:
  /// All numbers that determine a result.
  using Key = std::vector<double>;

  /// @param[in] most largest number of results
  /// @param[in] largest_size largest sum of their sizes, unless there is only one result
  RecentCache(std::size_t most, std::size_t largest_size) : most_(most), largest_size_(largest_size) {}

  /// @return the result of a key that is equal to within the round-off of ratios; null if there is none
  [[nodiscard]] std::shared_ptr<const Value> find(const Key& key) {
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find_if(entries_, [&](const Entry& entry) { return are_equal(entry.key, key); });
    return found == entries_.end() ? nullptr : found->value;
  }

  void add(Key key, std::shared_ptr<const Value> value, std::size_t size) {
    const std::scoped_lock lock(mutex_);
    entries_.push_front({std::move(key), std::move(value), size});
    while (entries_.size() > 1 && (entries_.size() > most_ || this->size() > largest_size_)) entries_.pop_back();
  }

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const Value> value;
    std::size_t size;
  };

  /// An infinite number, such as the crown radius of a flat tread, only equals another infinite number of the same
  /// sign.
  static bool are_equal(const Key& first, const Key& second) {
    constexpr double kRoundOff = 1e-12;
    return std::ranges::equal(first, second, [](double a, double b) {
      return a == b || std::abs(a - b) <= kRoundOff * std::max(std::min(std::abs(a), std::abs(b)), 1.0);
    });
  }

  [[nodiscard]] std::size_t size() const {
    std::size_t sum = 0;
    for (const Entry& entry : entries_) sum += entry.size;
    return sum;
  }

  std::size_t most_;
  std::size_t largest_size_;
  std::mutex mutex_;
  std::deque<Entry> entries_;  // the most recently added first
};

}  // namespace viscoroll::detail

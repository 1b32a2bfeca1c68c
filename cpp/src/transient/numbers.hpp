/// @file
/// @brief Conversion between a state and a sequence of numbers.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "base/validate.hpp"

namespace viscoroll::detail {

/// @brief Largest row index to either side; positions of rows beyond it are lost in round-off.
inline constexpr double kMaxRows = 1e15;

/// @brief Writer that appends numbers to a sequence.
class NumberWriter {
 public:
  explicit NumberWriter(std::vector<double>& numbers) : numbers_(numbers) {}

  void put(double number) { numbers_.push_back(number); }
  void put(const Eigen::MatrixXd& matrix) {
    put(static_cast<double>(matrix.rows()));
    put(static_cast<double>(matrix.cols()));
    numbers_.insert(numbers_.end(), matrix.data(), matrix.data() + matrix.size());
  }
  void put(const std::vector<double>& values) {
    put(static_cast<double>(values.size()));
    numbers_.insert(numbers_.end(), values.begin(), values.end());
  }
  void put(const std::vector<Eigen::Index>& indices) { put(std::vector<double>(indices.begin(), indices.end())); }

 private:
  std::vector<double>& numbers_;
};

/// @brief Reader of numbers that a `NumberWriter` has written. All members throw InvalidInput if the numbers
/// do not form a state.
class NumberReader {
 public:
  explicit NumberReader(std::span<const double> numbers) : rest_(numbers) {}

  /// @return a finite number
  [[nodiscard]] double get() {
    const double number = get_if_any();
    require(std::isfinite(number));
    return number;
  }

  /// @return a number, or NaN if there is none
  [[nodiscard]] double get_if_any() {
    require(!rest_.empty());
    const double number = rest_.front();
    rest_ = rest_.subspan(1);
    return number;
  }

  /// @return a count of at most `most`
  [[nodiscard]] Eigen::Index count(double most = 1e9) { return whole(get(), most); }

  /// @return a row index of either sign
  [[nodiscard]] Eigen::Index row() {
    const double number = get();
    if (!(std::abs(number) <= kMaxRows && number == std::floor(number))) refuse();
    return static_cast<Eigen::Index>(number);
  }

  [[nodiscard]] Eigen::MatrixXd matrix() {
    const Eigen::Index rows = count();
    const Eigen::Index columns = count();
    const auto values = take(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    return Eigen::Map<const Eigen::MatrixXd>(values.data(), rows, columns);
  }

  [[nodiscard]] std::vector<double> values() {
    const auto taken = take(static_cast<std::size_t>(count()));
    std::vector<double> values(taken.size());
    std::ranges::copy(taken, values.begin());
    return values;
  }

  /// @return indices of at most `most`
  [[nodiscard]] std::vector<Eigen::Index> indices(Eigen::Index most) {
    const auto taken = take(static_cast<std::size_t>(count()));
    std::vector<Eigen::Index> indices(taken.size());
    std::ranges::transform(taken, indices.begin(),
                           [&](double value) { return whole(value, static_cast<double>(most)); });
    return indices;
  }

  /// Reject numbers that are not consistent.
  static void require(bool holds) {
    if (!holds) refuse();
  }

  void finish() const {
    if (!rest_.empty()) refuse();
  }

 private:
  [[noreturn]] static void refuse() { reject("start", "a state of a rolling history", "invalid numbers"); }

  [[nodiscard]] static Eigen::Index whole(double number, double most) {
    require(number >= 0.0 && number <= most && number == std::floor(number));
    return static_cast<Eigen::Index>(number);
  }

  [[nodiscard]] std::span<const double> take(std::size_t count) {
    require(count <= rest_.size());
    const auto taken = rest_.first(count);
    require(std::ranges::all_of(taken, [](double number) { return std::isfinite(number); }));
    rest_ = rest_.subspan(count);
    return taken;
  }

  std::span<const double> rest_;
};

}  // namespace viscoroll::detail

#include "transient/common_times.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using std::numbers::pi;

/// Times in the intervals at which errors are evaluated; they are densest at the ends of the intervals, as are the
/// extrema of such products.
Eigen::ArrayXd sampled(std::span<const TimeRange> intervals) {
  constexpr double kFewest = 64.0;  // per interval
  constexpr double kPerEFold = 64.0;
  std::vector<double> times;
  for (const auto& [shortest, longest] : intervals) {
    const double width = std::log(longest / shortest);
    const int count = width > 0.0 ? static_cast<int>(std::max(kFewest, kPerEFold * width)) : 0;
    for (int i = 0; i <= count; ++i) {
      const double share = count > 0 ? 0.5 - 0.5 * std::cos(pi * i / count) : 0.0;
      times.push_back(i == count ? longest : shortest * std::exp(share * width));
    }
  }
  return Eigen::Map<const Eigen::ArrayXd>(times.data(), static_cast<Eigen::Index>(times.size()));
}

/// Error of a list of times over sampled times; it is 0 at the times of the list.
class Misfit {
 public:
  Misfit(Eigen::ArrayXd times, double longest) : times_(std::move(times)), values_(1.0 - times_ / longest) {}

  void add(double time) { values_ *= ((times_ - time) / (times_ + time)).abs(); }

  struct Largest {
    double time;
    double value;
  };
  [[nodiscard]] Largest largest() const {
    Eigen::Index at = 0;
    const double value = times_.size() > 0 ? values_.maxCoeff(&at) : 0.0;
    return {.time = times_.size() > 0 ? times_[at] : 0.0, .value = value};
  }

 private:
  Eigen::ArrayXd times_;
  Eigen::ArrayXd values_;
};

}  // namespace

std::vector<double> common_times(std::span<const TimeRange> intervals, std::span<const double> exact,
                                 double tolerance) {
  constexpr double kAsGoodAsExact = 1e-6;  // closer times would have weights that cancel
  std::vector<double> times{intervals.back().longest};
  Misfit anywhere(sampled(intervals), times.front());
  Misfit of_exact(Eigen::Map<const Eigen::ArrayXd>(exact.data(), static_cast<Eigen::Index>(exact.size())),
                  times.front());
  const auto add_until = [&](const Misfit& misfit, double limit) {
    for (auto worst = misfit.largest(); worst.value > limit; worst = misfit.largest()) {
      times.push_back(worst.time);
      anywhere.add(worst.time);
      of_exact.add(worst.time);
    }
  };
  add_until(of_exact, kAsGoodAsExact);
  // All terms lag by less than a quarter of a turn, so that the modulus of their sum is at least 1/sqrt(2) of the sum
  // of their moduli.
  add_until(anywhere, tolerance / std::numbers::sqrt2);
  std::ranges::sort(times);
  return times;
}

Eigen::VectorXcd shares(std::span<const double> times, const cplx& lambda) {
  const double longest = times.back();
  Eigen::VectorXcd shares(static_cast<Eigen::Index>(times.size()));
  for (std::size_t j = 0; j < times.size(); ++j) {
    const double own = times[j];
    cplx share = own == longest ? 1.0 : (longest - lambda) / (longest - own) * (2.0 * own) / (lambda + own);
    for (const double other : times.first(times.size() - 1)) {
      if (other != own) share *= (lambda - other) / (lambda + other) * ((own + other) / (own - other));
    }
    shares[static_cast<Eigen::Index>(j)] = share;
  }
  return shares;
}

Contour contour_around(std::span<const TimeRange> intervals, double left) {
  // The functions phi_j grow with the angle of lambda up to a quarter of a turn and have their poles at half a turn. A
  // third of half a turn requires few points and loses few digits.
  constexpr double kHeight = pi / 3.0;
  const double half_width = 0.5 * std::log(intervals.back().longest / intervals.front().shortest);
  const cplx center = 0.5 * std::log(intervals.back().longest * intervals.front().shortest);
  const double half_length = std::hypot(half_width, kHeight);
  const double decay = half_width > 0.0 ? std::asinh(kHeight / half_width) : left;
  constexpr double kFewest = 0.4;  // for the poles outside, three times as far from a single time as the contour
  const int count = static_cast<int>(std::ceil(std::max(0.5 * left / decay, kFewest * left)));
  Contour contour;
  for (int q = 0; q < count; ++q) {
    const double angle = pi * (q + 0.5) / count;  // the lower half is the conjugate of the upper one
    const cplx place(half_length * std::cos(angle), kHeight * std::sin(angle));
    const cplx step(-half_length * std::sin(angle), kHeight * std::cos(angle));
    contour.times.push_back(std::exp(center + place));
    contour.weights.push_back(step / cplx(0.0, count));
  }
  return contour;
}

}  // namespace viscoroll::detail

#include "creep/layer_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "modal/compliance_recursion.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using std::numbers::pi;

/// Spectrum with an instantaneous compliance. In a fit without one, the shortest time, far below all relevant times,
/// takes its place.
CreepSpectrum with_instantaneous_part(CreepSpectrum creep) {
  if (creep.instantaneous > 0.0) return creep;
  creep.instantaneous = creep.weights.front();
  creep.weights.erase(creep.weights.begin());
  creep.retardation_times.erase(creep.retardation_times.begin());
  return creep;
}

/// Relaxation times, which are the poles of a modulus, ascending: one below each retardation time [s].
std::vector<double> relaxation_times(const CreepSpectrum& creep) {
  // Between its poles, the compliance falls from infinity above one retardation time to minus infinity below the next.
  const CreepFunction modulus{.relaxed = 1.0, .creep = creep};
  std::vector<double> times;
  times.reserve(creep.size());
  for (std::size_t j = 0; j < creep.size(); ++j) {
    const double retardation = creep.retardation_times[j];
    // Below the shortest time the compliance is positive where time / (retardation - time) < J_0.
    double below =
        j > 0 ? creep.retardation_times[j - 1] : retardation * creep.instantaneous / (1.0 + creep.instantaneous);
    double above = retardation;
    for (;;) {
      const double middle = std::sqrt(below * above);
      if (middle <= below || middle >= above) break;
      (modulus.at(middle) > 0.0 ? below : above) = middle;
    }
    times.push_back(above);
  }
  return times;
}

/// Relative difference of times that are equal up to round-off.
constexpr double kSame = 1e-9;

/// Times at which a modulus changes its sign.
std::vector<double> changes(std::span<const CreepFunction> moduli) {
  std::vector<double> times;
  for (const CreepFunction& modulus : moduli) {
    const auto& own = modulus.creep.retardation_times;
    times.insert(times.end(), own.begin(), own.end());
    const auto poles = relaxation_times(modulus.creep);
    times.insert(times.end(), poles.begin(), poles.end());
  }
  std::ranges::sort(times);
  return times;
}

bool is_mixed(std::span<const CreepFunction> moduli, bool has_elastic_part, double time) {
  const auto is_negative = [time](const CreepFunction& modulus) { return modulus.at(time) < 0.0; };
  const bool all = !has_elastic_part && std::ranges::all_of(moduli, is_negative);
  return !all && std::ranges::any_of(moduli, is_negative);
}

/// Ascending intervals; intervals that touch are merged.
std::vector<TimeRange> joined(std::vector<TimeRange> intervals) {
  std::ranges::sort(intervals, {}, &TimeRange::shortest);
  std::vector<TimeRange> result;
  for (const TimeRange& interval : intervals) {
    if (result.empty() || interval.shortest > result.back().longest * (1.0 + kSame)) {
      result.push_back(interval);
    } else {
      result.back().longest = std::max(result.back().longest, interval.longest);
    }
  }
  return result;
}

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

/// Whether a viscoelastic layer has an elastic bulk modulus.
bool has_elastic_bulk(const Layer& layer, const CreepFunction& modulus) {
  return layer.bulk_modulus.has_value() && modulus.creep.size() > 0;
}

std::vector<TimeRange> intervals_of(const LayeredBody& body, const std::vector<CreepFunction>& moduli) {
  bool has_elastic_part = false;
  for (std::size_t l = 0; l < moduli.size(); ++l) {
    has_elastic_part = has_elastic_part || has_elastic_bulk(body.layers[l], moduli[l]);
  }
  return retardation_intervals(moduli, has_elastic_part);
}

template <class Scalar, class Modulus>
LayerStack<Scalar> stack_at(const LayeredBody& body, const std::vector<CreepFunction>& moduli, const Modulus& modulus) {
  std::vector<Scalar> values;
  values.reserve(moduli.size());
  for (const CreepFunction& layer : moduli) values.push_back(modulus(layer));
  constexpr double kStill = 0.0;  // without inertia
  return body.stack(values, kStill);
}

template <class Scalar>
std::vector<Matrix3<Scalar>> solved(std::span<const OrderInLayers<Scalar>> orders, const Crown& crown) {
  std::vector<Matrix3<Scalar>> compliances(orders.size());
  crowned_compliances<Scalar>(orders, crown, compliances);
  return compliances;
}

LayeredBody relaxed(LayeredBody body, const std::vector<CreepFunction>& moduli) {
  for (std::size_t l = 0; l < moduli.size(); ++l) {
    body.layers[l].shear_modulus = Elastic{moduli[l].relaxed};
    body.layers[l].density = 0.0;
  }
  return body;
}

std::vector<double> at_equal_ratios(double low, double high, int count) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    values.push_back(std::min(low * std::pow(high / low, i / (count - 1.0)), high));
  }
  return values;
}

}  // namespace

std::vector<CreepFunction> creep_functions(const std::vector<Layer>& layers, const TimeRange& range) {
  std::vector<CreepFunction> moduli;
  moduli.reserve(layers.size());
  for (const Layer& layer : layers) {
    const ShearModulus& modulus = layer.shear_modulus;
    moduli.push_back({.relaxed = complex_modulus(modulus, std::array{0.0}).front().real(),
                      .creep = with_instantaneous_part(creep_spectrum(modulus, range))});
  }
  return moduli;
}

std::vector<TimeRange> retardation_intervals(std::span<const CreepFunction> moduli, bool has_elastic_part) {
  std::vector<TimeRange> intervals;
  const std::vector<double> times = changes(moduli);
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (times[i + 1] <= times[i] * (1.0 + kSame)) continue;
    if (is_mixed(moduli, has_elastic_part, std::sqrt(times[i] * times[i + 1]))) {
      intervals.push_back({.shortest = times[i], .longest = times[i + 1]});
    }
  }
  for (const CreepFunction& modulus : moduli) {
    for (const double time : modulus.creep.retardation_times) intervals.push_back({.shortest = time, .longest = time});
  }
  return joined(std::move(intervals));
}

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

Contour contour_around(std::span<const TimeRange> intervals, double e_folds) {
  // The functions phi_j grow with the angle of lambda up to a quarter of a turn and have their poles at half a turn. A
  // third of half a turn requires few points and loses few digits.
  constexpr double kHeight = pi / 3.0;
  const double half_width = 0.5 * std::log(intervals.back().longest / intervals.front().shortest);
  const cplx center = 0.5 * std::log(intervals.back().longest * intervals.front().shortest);
  const double half_length = std::hypot(half_width, kHeight);
  const double decay = half_width > 0.0 ? std::asinh(kHeight / half_width) : e_folds;
  constexpr double kFewest = 0.4;  // for the poles outside, three times as far from a single time as the contour
  const int count = static_cast<int>(std::ceil(std::max(0.5 * e_folds / decay, kFewest * e_folds)));
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

LayerSpectrum::LayerSpectrum(LayeredBody body, const TimeRange& range, double tolerance)
    : body_(std::move(body)), moduli_(creep_functions(body_.layers, range)) {
  at_rest_ = relaxed(body_, moduli_);
  const std::vector<TimeRange> intervals = intervals_of(body_, moduli_);
  // Orders that do not reach below the outermost layer creep as this layer does, and their kernels are singular. With
  // weights at the own times of this layer only, the tables of the other times stay smooth.
  times_ = common_times(intervals, moduli_.back().creep.retardation_times, tolerance);
  constexpr double kToTheLastDigit = 40.0;
  WeighedContour contour = this->contour(kToTheLastDigit);
  for (const cplx& time : contour.times) on_contour_.push_back(layers_at(time));
  sums_ = std::move(contour.sums);
}

LayerSpectrum::WeighedContour LayerSpectrum::contour(double e_folds) const {
  Contour contour = contour_around(intervals_of(body_, moduli_), e_folds);
  WeighedContour weighed{.times = std::move(contour.times), .sums = {}};
  weighed.sums.resize(static_cast<Index>(times_.size()), static_cast<Index>(weighed.times.size()));
  for (std::size_t q = 0; q < weighed.times.size(); ++q) {
    weighed.sums.col(static_cast<Index>(q)) = contour.weights[q] * shares(times_, weighed.times[q]);
  }
  return weighed;
}

LayerStack<cplx> LayerSpectrum::layers_at(const cplx& time) const {
  return stack_at<cplx>(body_, moduli_, [&](const CreepFunction& layer) { return layer.at(time); });
}

LayerStack<double> LayerSpectrum::layers_at_once() const {
  return stack_at<double>(body_, moduli_, [](const CreepFunction& layer) { return layer.instantaneous(); });
}

LayerSpectrum LayerSpectrum::with_orders_of(double radius) const {
  LayerSpectrum other = *this;
  other.body_.metric.radius = other.at_rest_.metric.radius = radius;
  for (auto& stack : other.on_contour_) stack.metric.radius = radius;
  return other;
}

std::vector<std::vector<Eigen::Matrix3d>> LayerSpectrum::weights_of(std::span<const SurfaceOrder> orders) const {
  const auto at_once = layers_at_once();
  std::vector<OrderInLayers<double>> at_instant;
  std::vector<OrderInLayers<cplx>> creeping;
  for (const SurfaceOrder& order : orders) at_instant.push_back({.layers = at_once, .m = order.m, .n = order.n});
  for (const auto& stack : on_contour_) {
    for (const SurfaceOrder& order : orders) creeping.push_back({.layers = stack, .m = order.m, .n = order.n});
  }
  const auto instantaneous = solved<double>(at_instant, body_.crown);
  const auto compliances = solved<cplx>(creeping, body_.crown);

  std::vector<std::vector<Eigen::Matrix3d>> weights(orders.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    weights[i].push_back(instantaneous[i]);
    for (Index j = 0; j < sums_.rows(); ++j) {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (Index q = 0; q < sums_.cols(); ++q) {
        sum += (sums_(j, q) * compliances[static_cast<std::size_t>(q) * orders.size() + i]).real();
      }
      weights[i].push_back(sum);
    }
  }
  return weights;
}

Eigen::Matrix3cd LayerSpectrum::compliance(std::span<const Eigen::Matrix3d> weights, double omega) const {
  Eigen::Matrix3cd sum = weights.front().cast<cplx>();
  for (std::size_t j = 0; j < times_.size(); ++j) {
    sum += weights[j + 1].cast<cplx>() / cplx(1.0, omega * times_[j]);
  }
  return sum;
}

double LayerSpectrum::error(const TimeRange& range) const {
  const std::vector<SurfaceOrder> orders = compared_orders(body_);
  const std::vector<double> frequencies = compared_frequencies(body_.layers, range);
  const auto weights = weights_of(orders);
  double largest = 0.0;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    for (const double omega : frequencies) {
      const Eigen::Matrix3cd exact = compliance_at(body_, orders[i], omega);
      const Eigen::Array33d apart = (compliance(weights[i], omega) - exact).cwiseAbs();
      const Eigen::Array3d size = exact.diagonal().cwiseAbs().cwiseSqrt();
      largest = std::max(largest, (apart / (size.matrix() * size.matrix().transpose()).array()).maxCoeff());
    }
  }
  return largest;
}

std::vector<double> compared_frequencies(const std::vector<Layer>& layers, const TimeRange& range) {
  constexpr int kCount = 25;
  double low = 1.0 / range.longest;
  double high = 1.0 / range.shortest;
  for (const Layer& layer : layers) {
    const auto* curve = std::get_if<MasterCurve>(&layer.shear_modulus);
    if (curve == nullptr) continue;
    low = std::max(low, *std::ranges::find_if(curve->frequency, [](double w) { return w > 0.0; }));
    high = std::max(std::min(high, curve->frequency.back()), low);
  }
  return at_equal_ratios(low, high, kCount);
}

std::vector<SurfaceOrder> compared_orders(const LayeredBody& body) {
  constexpr int kCount = 25;
  constexpr double kLongest = 0.05;   // wave number times the total thickness
  constexpr double kShortest = 20.0;  // times the smallest thickness: such waves do not reach below that layer
  constexpr double kLowest = 2.0;     // orders 0 and 1 are rigid motions around a center
  double thickness = 0.0;
  double thinnest = std::numeric_limits<double>::infinity();
  for (const Layer& layer : body.layers) {
    if (std::isfinite(layer.thickness)) thickness += layer.thickness;
    thinnest = std::min(thinnest, layer.thickness);
  }
  if (thickness == 0.0) thickness = thinnest = body.metric.radius;  // a half-space, which is the same at all orders
  const double low = std::max(kLongest * body.metric.radius / thickness, body.metric.is_curved() ? kLowest : 0.0);
  const double high = std::max(kShortest * body.metric.radius / thinnest, low);
  std::vector<SurfaceOrder> orders;
  for (const double order : at_equal_ratios(low, high, kCount)) orders.push_back({.m = order, .n = 0.0});
  return orders;
}

Eigen::Matrix3cd compliance_at(const LayeredBody& body, const SurfaceOrder& order, double omega) {
  std::vector<cplx> moduli;
  moduli.reserve(body.layers.size());
  for (const Layer& layer : body.layers) {
    moduli.push_back(complex_modulus(layer.shear_modulus, std::array{omega}).front());
  }
  const LayerStack<cplx> stack = body.stack(moduli, 0.0);
  const OrderInLayers<cplx> in_layers{.layers = stack, .m = order.m, .n = order.n};
  return solved<cplx>(std::span(&in_layers, 1), body.crown).front();
}

}  // namespace viscoroll::detail

#include "modal/harmonic_body.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "base/invalid_speed.hpp"
#include "base/validate.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_moduli.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Reject a speed at which the shear waves of a damped layer are too short for the steps through it.
void require_resolved_waves(const HarmonicBody& body) {
  const double longest = body.metric().is_curved() ? std::log1p(kStepRatio) : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < body.orders().size(); ++i) {
    const double m = body.orders()[i];
    const LayerStack<cplx> stack = body.layers_at(i);
    for (const Medium<cplx>& medium : stack.media) {
      if (medium.inertia == 0.0 || medium.is_half_space()) continue;
      const double mach = std::sqrt(std::abs(stack.mach2(medium)));
      const double step = std::min(longest, body.metric().depth(medium.outer, medium.inner));
      if (mach * std::min(m * step, kStepExponent) <= kWaveExponent) continue;
      throw InvalidSpeed(body.angular_speed(),
                         {.before = "so low that no layer moves faster than about 5 times its shear-wave speed "
                                    "(shorter waves are not resolved)",
                          .remark = ", at which a layer moves at " + rounded(mach) + " times its shear-wave speed"});
    }
  }
}

/// Compute the compliances of a wheel without inertia whose layers share one relaxation function, with real numbers.
/// @param[in] layers layers in units of the modulus of the innermost one
void solve_real(const HarmonicBody& body, const LayerStack<double>& layers, std::span<const IndexedOrder> orders,
                std::span<Eigen::Matrix3cd> compliances) {
  std::vector<OrderInLayers<double>> in_layers;
  in_layers.reserve(orders.size());
  for (const auto& [i, n] : orders) in_layers.push_back({.layers = layers, .m = body.orders()[i], .n = n});
  std::vector<Eigen::Matrix3d> solved(orders.size());
  crowned_compliances<double>(in_layers, body.body().crown, solved);
  for (std::size_t j = 0; j < orders.size(); ++j) {
    compliances[j] = solved[j].cast<cplx>() / body.modulus(0, orders[j].i);
  }
}

/// Real ratio of the moduli of two layers, if it is the same at every order.
std::optional<double> common_ratio(const HarmonicBody& body, std::size_t layer, std::size_t reference) {
  constexpr double kRoundOff = 1e-14;
  const cplx ratio = body.modulus(layer, 0) / body.modulus(reference, 0);
  if (std::abs(ratio.imag()) > kRoundOff * std::abs(ratio)) return std::nullopt;
  for (std::size_t i = 0; i < body.orders().size(); ++i) {
    const cplx expected = ratio * body.modulus(reference, i);
    if (std::abs(body.modulus(layer, i) - expected) > kRoundOff * std::abs(expected)) return std::nullopt;
  }
  return ratio.real();
}

/// Whether the Poisson's ratio of a layer is real and the same at every order.
bool has_constant_poisson_ratio(const HarmonicBody& body, std::size_t layer) {
  const Layer& properties = body.body().layers[layer];
  return properties.poisson_ratio || std::holds_alternative<Elastic>(properties.shear_modulus);
}

}  // namespace

void require_layers_and_speed(const LayeredBody& body, double angular_speed) {
  if (body.layers.empty()) {
    const bool is_curved = body.metric.is_curved();
    reject("layers", is_curved ? "a list of at least one layer" : "a list of at least one layer unless base is given",
           is_curved ? "none" : "neither");
  }
  require_positive("angular_speed", angular_speed, "rad/s");
}

HarmonicBody::HarmonicBody(LayeredBody body, double angular_speed, std::vector<double> orders, double measured_order)
    : body_(std::move(body)), angular_speed_(angular_speed), orders_(std::move(orders)) {
  require_layers_and_speed(body_, angular_speed);
  moduli_ = harmonic_moduli(body_.layers, angular_speed, orders_, measured_order);
  require_subcritical(body_, angular_speed, highest_frequency(angular_speed, orders_, measured_order));
  require_damped_waves(*this);
  require_resolved_waves(*this);
}

double HarmonicBody::stiffest_modulus() const {
  const auto highest = static_cast<std::size_t>(std::ranges::max_element(orders_) - orders_.begin());
  double stiffest = 0.0;
  for (const auto& layer : moduli_) stiffest = std::max(stiffest, std::abs(layer[highest]));
  return stiffest;
}

HarmonicBody HarmonicBody::resampled(std::vector<double> orders, const Eigen::ArrayXXcd& measured) const {
  HarmonicBody other = *this;
  other.orders_ = std::move(orders);
  other.moduli_ = resampled_moduli(body_.layers, angular_speed_, other.orders_, measured);
  return other;
}

LayerStack<cplx> HarmonicBody::layers_at(std::size_t i) const {
  std::vector<cplx> moduli;
  moduli.reserve(moduli_.size());
  for (const auto& layer : moduli_) moduli.push_back(layer[i]);
  return body_.stack(moduli, angular_speed_);
}

void HarmonicBody::compliances(std::span<const IndexedOrder> orders, std::span<Eigen::Matrix3cd> compliances) const {
  const bool is_light = std::ranges::all_of(body_.layers, [](const Layer& layer) { return layer.density == 0.0; });
  const auto shared = metric().is_wheel() && is_light ? layers_per_modulus(*this, 0, 0.0) : std::nullopt;
  if (shared) return solve_real(*this, *shared, orders, compliances);
  std::map<std::size_t, LayerStack<cplx>> stacks;
  std::vector<OrderInLayers<cplx>> in_layers;
  in_layers.reserve(orders.size());
  for (const auto& [i, n] : orders) {
    auto stack = stacks.find(i);
    if (stack == stacks.end()) stack = stacks.emplace(i, layers_at(i)).first;
    in_layers.push_back({.layers = stack->second, .m = orders_[i], .n = n});
  }
  crowned_compliances<cplx>(in_layers, body_.crown, compliances);
}

Eigen::Matrix3cd HarmonicBody::compliance(const IndexedOrder& order) const {
  Eigen::Matrix3cd compliance;
  compliances(std::span(&order, 1), std::span(&compliance, 1));
  return compliance;
}

HarmonicBody body_at_order_zero(LayeredBody body, double angular_speed) {
  return {std::move(body), angular_speed, std::vector<double>{0.0}};
}

void require_orders(Curvature curvature) {
  if (curvature == Curvature::exact) {
    reject("curvature", "SPHERE or PAPER, which have orders (m, n)", "EXACT");
  }
}

std::optional<LayerStack<double>> layers_per_modulus(const HarmonicBody& body, std::size_t reference,
                                                     double highest_density) {
  const auto at_rest = body.layers_at(0);
  LayerStack<double> layers{.metric = at_rest.metric, .inner_boundary = at_rest.inner_boundary, .media = {}};
  for (std::size_t l = 0; l < at_rest.media.size(); ++l) {
    const std::optional<double> ratio = common_ratio(body, l, reference);
    if (!ratio || !has_constant_poisson_ratio(body, l)) return std::nullopt;
    const double share = highest_density > 0.0 ? body.body().layers[l].density / highest_density : 0.0;
    const Medium<cplx>& medium = at_rest.media[l];
    layers.media.push_back({.inner = medium.inner,
                            .outer = medium.outer,
                            .mu = *ratio,
                            .b = medium.b.real(),
                            .inertia = share / (body.radius() * body.radius())});
  }
  return layers;
}

}  // namespace viscoroll::detail

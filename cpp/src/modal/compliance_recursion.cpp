#include "modal/compliance_recursion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <vector>

#include "modal/depth_cut.hpp"
#include "modal/layer_stack.hpp"
#include "modal/layer_step.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

// Depths in e-folds of a solution.
constexpr double kDepth = 24.0;        // deeper material does not affect the surface
constexpr double kDepthInside = 36.0;  // deeper fields due to surface tractions are negligible

/// Compliance of a half-space for waves with k = 1, in units of 1 / modulus (docs/theory/planes-and-pairs.md).
template <class Scalar>
struct HalfSpaceCompliance {
  Scalar normal, mixed, along, across;

  /// @param[in] b ratio of the shear modulus to the confined modulus
  /// @param[in] mach2 square of the Mach number of shear waves in the direction of k
  HalfSpaceCompliance(const Scalar& b, const Scalar& mach2) {
    using std::sqrt;
    const Scalar p_s = sqrt(1.0 - mach2);
    const Scalar p_l = sqrt(1.0 - b * mach2);
    // This form contains no differences of nearly equal numbers at low speeds.
    const Scalar g = (1.0 + b - b * mach2) / (1.0 + p_l * p_s);
    const Scalar d = 4.0 - mach2 - 4.0 * g;
    normal = p_l / d;
    mixed = -(2.0 * g - 1.0) / d;
    along = p_s / d;
    across = 1.0 / p_s;
  }
};

/// Recursion for up to kLanes orders at the same time.
template <class Scalar>
class Batch {
 public:
  explicit Batch(std::span<const OrderInLayers<Scalar>> orders, double depth = kDepth) : orders_(orders) {
    step_.along = Metric::curvature_flag(metric().along);
    step_.across = Metric::curvature_flag(metric().across);
    step_.area = metric().is_sphere() ? 3.0 : 4.0;
    step_.is_wheel = metric().is_wheel();
    for (std::size_t l = 0; l < kLanes; ++l) {
      const double m = at(l).m;
      const double n = at(l).n;
      deepest_[l] = deepest_position(at(l).layers, m, n, depth);
      step_.k.set(l, step_.is_wheel ? m : order(l));
      const double stiffness = metric().membrane_stiffness(m * m + n * n);
      step_.membrane.set(l, metric().is_sphere() ? stiffness : 0.0);
      step_.shear.set(l, stiffness);
      const auto [cosine, sine] = direction(l);
      const double turns = step_.along;
      step_.inertia.rr.set(l, -turns - m * m);
      step_.inertia.rk.set(l, 2.0 * turns * m * cosine);
      step_.inertia.rx.set(l, -2.0 * turns * m * sine);
      step_.inertia.kk.set(l, -m * m - turns * cosine * cosine);
      step_.inertia.kx.set(l, turns * cosine * sine);
      step_.inertia.xx.set(l, -m * m - turns * sine * sine);
    }
  }

  /// Carry Y, in units of 1 / modulus of the layer, through all layers.
  /// @param[in] visit called after every step; false stops the recursion
  /// @return false if `visit` stopped the recursion
  template <class Visit>
  bool carry(const Visit& visit) {
    for (std::size_t layer = 0; layer < media(0).size(); ++layer) {
      const int steps = enter(layer);
      if (media(0)[layer].is_half_space() && !visit(*this)) return false;
      for (int step = 0; step < steps; ++step) {
        advance(step_, start(), compliance_);
        leave_step();
        if (!visit(*this)) return false;
      }
    }
    return true;
  }

  /// Carry Y through all layers, and report it at the outer boundary of every layer with the matrix that carries
  /// stresses down through the layer.
  /// @param[in] keep called with the lane, Y in the layer's unit, and the product of all F^-1 of the layer
  template <class Keep>
  void carry_with_inverses(const Keep& keep) {
    std::array<Matrix3<Scalar>, kLanes> down;
    MatrixLanes<Scalar> inverse_stress;
    for (std::size_t layer = 0; layer < media(0).size(); ++layer) {
      const int steps = enter(layer);
      for (std::size_t l = 0; l < kLanes; ++l) {
        // An order that starts above the layer's inner end is negligible there.
        const bool whole = inner_[l] == media(l)[layer].inner;
        down[l] = whole ? Matrix3<Scalar>(Matrix3<Scalar>::Identity()) : Matrix3<Scalar>(Matrix3<Scalar>::Zero());
      }
      for (int step = 0; step < steps; ++step) {
        advance(step_, start(), compliance_, inverse_stress);
        for (std::size_t l = 0; l < kLanes; ++l) {
          Matrix3<Scalar> inverse;
          for (std::size_t i = 0; i < 9; ++i) {
            inverse(static_cast<int>(i) / 3, static_cast<int>(i) % 3) = inverse_stress[i].value(l);
          }
          down[l] *= inverse;
        }
        leave_step();
      }
      for (std::size_t l = 0; l < kLanes; ++l) keep(l, matrix(l), down[l]);
    }
  }

  /// Rotation from the directions r, k and across k to r, phi and theta.
  [[nodiscard]] Eigen::Matrix3d turn(std::size_t l) const {
    const auto [cosine, sine] = direction(l);
    return Eigen::Matrix3d{{1.0, 0.0, 0.0}, {0.0, cosine, -sine}, {0.0, sine, cosine}};
  }

  /// Surface compliance of one lane [m/Pa] in the directions r, phi, theta.
  [[nodiscard]] Matrix3<Scalar> surface_compliance(std::size_t l) const {
    const Eigen::Matrix3d turn = this->turn(l);
    Matrix3<Scalar> y = turn.cast<Scalar>() * matrix(l) * turn.transpose().cast<Scalar>();
    if (!inner_surface().is_core && order(l) == 0.0)
      y.template bottomRightCorner<2, 2>().setZero();  // no mean rotation
    return y * (metric().radius / media(l).back().mu);
  }

  /// Whether Y is positive definite in all lanes.
  [[nodiscard]] bool is_positive() const {
    for (std::size_t l = 0; l < kLanes; ++l) {
      if (!started_[l]) continue;
      const Matrix3<Scalar> y = matrix(l);
      const Scalar minor = y(0, 0) * y(1, 1) - y(0, 1) * y(1, 0);
      if (!(y(0, 0) > 0.0 && minor > 0.0 && y.determinant() > 0.0)) return false;
    }
    return true;
  }

 private:
  /// Order of a lane. Unused lanes repeat the last order.
  [[nodiscard]] const OrderInLayers<Scalar>& at(std::size_t l) const {
    return orders_[std::min(l, orders_.size() - 1)];
  }
  [[nodiscard]] const std::vector<Medium<Scalar>>& media(std::size_t l) const { return at(l).layers.media; }
  [[nodiscard]] const Metric& metric() const { return at(0).layers.metric; }
  /// k at the surface.
  [[nodiscard]] double order(std::size_t l) const { return std::hypot(at(l).m, at(l).n); }
  /// Order across at a position.
  [[nodiscard]] double kappa(std::size_t l, double position) const { return at(l).n * metric().shrinkage(position); }
  /// k at a position.
  [[nodiscard]] double order_at(std::size_t l, double position) const {
    return std::hypot(at(l).m, kappa(l, position));
  }
  /// Cosine and sine of the angle between phi and the first tangential direction of the equations.
  [[nodiscard]] std::array<double, 2> direction(std::size_t l) const {
    const double k = order(l);
    if (step_.is_wheel || k == 0.0) return {1.0, 0.0};
    return {at(l).m / k, at(l).n / k};
  }
  [[nodiscard]] InnerSurface inner_surface() const { return detail::inner_surface(at(0).layers.inner_boundary); }

  [[nodiscard]] Matrix3<Scalar> matrix(std::size_t l) const {
    const auto& y = compliance_;
    return Matrix3<Scalar>{{y.rr.value(l), y.rk.value(l), y.rx.value(l)},
                           {y.rk.value(l), y.kk.value(l), y.kx.value(l)},
                           {y.rx.value(l), y.kx.value(l), y.xx.value(l)}};
  }

  /// Prepare the steps through a layer and convert Y to its unit.
  /// @return number of steps; 0 for a half-space or a layer that does not affect the surface
  int enter(std::size_t layer) {
    int steps = 0;
    for (std::size_t l = 0; l < kLanes; ++l) {
      const Medium<Scalar>& medium = media(l)[layer];
      inner_[l] = medium.is_half_space() ? medium.outer : std::clamp(deepest_[l], medium.inner, medium.outer);
      extent_[l] = metric().depth(medium.outer, inner_[l]);
      const double longest = std::min(metric().is_curved() ? std::log1p(kStepRatio) : extent_[l],
                                      kStepExponent / (order_at(l, medium.outer) + step_.along));
      if (extent_[l] > 0.0) steps = std::max(steps, static_cast<int>(std::ceil(extent_[l] / longest)));
    }
    step_.has_inertia = false;
    for (std::size_t l = 0; l < kLanes; ++l) {
      const Medium<Scalar>& medium = media(l)[layer];
      if (layer > 0) scale(l, medium.mu / media(l)[layer - 1].mu);
      if (medium.is_half_space()) start_from_half_space(l, medium);
      step_.b.set(l, medium.b);
      const double length = metric().length(inner_[l]);
      step_.q.set(l, medium.inertia * length * length / medium.mu);
      step_.kappa.set(l, kappa(l, inner_[l]));
      const double growth = extent_[l] / std::max(steps, 1);
      step_.growth.set(l, metric().is_curved() ? std::expm1(growth) : growth);
      step_.has_inertia = step_.has_inertia || medium.inertia != 0.0;
      at_free_surface_[l] = layer == 0 && inner_surface().is_free && inner_[l] == medium.inner;
    }
    return steps;
  }

  void start_from_half_space(std::size_t l, const Medium<Scalar>& medium) {
    const double k = order(l);
    const double cosine = at(l).m / k;
    const HalfSpaceCompliance<Scalar> y(medium.b, at(l).layers.mach2(medium) * (cosine * cosine));
    compliance_.rr.set(l, y.normal / k);
    compliance_.rk.set(l, y.mixed / k);
    compliance_.kk.set(l, y.along / k);
    compliance_.xx.set(l, y.across / k);
    started_[l] = true;
  }

  void leave_step() {
    for (std::size_t l = 0; l < kLanes; ++l) {
      const double ratio = 1.0 + step_.along * step_.growth.value(l);
      step_.q.set(l, ratio * ratio * step_.q.value(l));
      step_.kappa.set(l, ratio * step_.kappa.value(l));
      at_free_surface_[l] = false;
      started_[l] = started_[l] || extent_[l] > 0.0;
    }
  }

  void scale(std::size_t l, const Scalar& factor) {
    auto& y = compliance_;
    for (Lanes<Scalar>* entry : {&y.rr, &y.rk, &y.rx, &y.kk, &y.kx, &y.xx}) entry->set(l, factor * entry->value(l));
  }

  /// Starting states of a step: unit stresses with the displacements Y that they cause, or unit displacements at a free
  /// surface. A solid ball starts like one on a tiny core, since solutions that are not regular at the center decay.
  [[nodiscard]] std::array<SolutionLanes<Scalar>, 3> start() const {
    const auto& y = compliance_;
    std::array<SolutionLanes<Scalar>, 3> states{{{y.rr, y.rk, y.rx}, {y.rk, y.kk, y.kx}, {y.rx, y.kx, y.xx}}};
    for (std::size_t l = 0; l < kLanes; ++l) {
      for (std::size_t i = 0; i < 3; ++i) {
        // Order (0, 0) starts from stresses along the surface, because the coating can rotate freely as a whole.
        const bool free = at_free_surface_[l] && (order(l) > 0.0 || i == 0);
        states[i][free ? i : 3 + i].set(l, 1.0);
      }
    }
    return states;
  }

  std::span<const OrderInLayers<Scalar>> orders_;
  StepLanes<Scalar> step_;
  SymmetricLanes<Scalar> compliance_;
  std::array<double, kLanes> deepest_{};  // position below which material does not affect the surface
  std::array<double, kLanes> inner_{};    // position at which the recursion enters the layer
  std::array<double, kLanes> extent_{};   // from there to the outer boundary, in e-folds of an order 1
  std::array<bool, kLanes> at_free_surface_{};
  std::array<bool, kLanes> started_{};
};

/// Results of the outward recursion for one order.
struct KeptOrder {
  std::vector<Matrix3<cplx>> compliance;  // Y at the outer boundary of each layer, in units of 1 / modulus of the layer
  std::vector<Matrix3<cplx>> down;        // matrix that carries stresses down through each layer
};

/// States of one order in the directions r, k and across k, from the surface down.
std::vector<DepthState> descend(const OrderInLayers<cplx>& order, const KeptOrder& kept) {
  const auto& media = order.layers.media;
  const auto [has_core, free_inside] = inner_surface(order.layers.inner_boundary);
  const bool uniform = order.m == 0.0 && order.n == 0.0;
  std::vector<DepthState> states(media.size() + 1, DepthState::Zero());
  Matrix3<cplx> stress = Matrix3<cplx>::Identity();
  for (std::size_t layer = media.size(); layer-- > 0;) {
    DepthState& state = states[layer + 1];
    state.topRows<3>() = kept.compliance[layer] * stress / media[layer].mu;
    state.bottomRows<3>() = stress;
    stress = kept.down[layer] * stress;
  }
  DepthState& inner = states.front();
  if (free_inside) {
    // The first step started from displacements, but from stresses along the surface in order (0, 0), which rotates
    // freely.
    const int free = uniform ? 1 : 3;
    inner.topRows(free) = stress.topRows(free) / media.front().mu;
    inner.bottomRows(3 - free) = stress.bottomRows(3 - free);
  } else {
    inner.bottomRows<3>() = stress;
  }
  if (!has_core && uniform) {
    // Subtract the mean rotation of the surface.
    const Eigen::Matrix<cplx, 2, 3> turning = states.back().middleRows<2>(1) / media.back().outer;
    inner.middleRows<2>(1) -= media.front().inner * turning;
    for (std::size_t layer = 0; layer < media.size(); ++layer) {
      states[layer + 1].middleRows<2>(1) -= media[layer].outer * turning;
    }
  }
  return states;
}

/// Layers without inertia in another metric.
/// @param[in] surface position of the surface in that metric
template <class Scalar>
LayerStack<Scalar> moved(const LayerStack<Scalar>& layers, const Metric& metric, double surface) {
  LayerStack<Scalar> moved{.metric = metric, .inner_boundary = layers.inner_boundary, .media = layers.media};
  const double shift = surface - layers.media.back().outer;
  for (Medium<Scalar>& medium : moved.media) {
    medium.inner += shift;
    medium.outer += shift;
    medium.inertia = 0.0;
  }
  return moved;
}

/// Orders with the same wave numbers in another metric, and their layers.
template <class Scalar>
class MovedOrders {
 public:
  /// @param[in] metric the other metric; that of a wheel is rotated, so that m and n are exchanged
  MovedOrders(std::span<const OrderInLayers<Scalar>> orders, const Metric& metric) {
    const double scale = metric.radius / orders.front().layers.metric.radius;
    for (const OrderInLayers<Scalar>& order : orders) {
      auto stack = stacks_.find(&order.layers);
      if (stack == stacks_.end()) {
        stack = stacks_.emplace(&order.layers, moved(order.layers, metric, metric.surface())).first;
      }
      const double m = metric.is_wheel() ? order.n : order.m;
      const double n = metric.is_wheel() ? order.m : order.n;
      orders_.push_back({.layers = stack->second, .m = scale * m, .n = scale * n});
    }
  }

  [[nodiscard]] std::vector<Matrix3<Scalar>> compliances() const {
    std::vector<Matrix3<Scalar>> compliances(orders_.size());
    surface_compliances<Scalar>(orders_, compliances);
    return compliances;
  }

 private:
  std::map<const LayerStack<Scalar>*, LayerStack<Scalar>> stacks_;
  std::vector<OrderInLayers<Scalar>> orders_;
};

/// Add the effect of a crown that is not flat.
template <class Scalar>
void add_crown(std::span<const OrderInLayers<Scalar>> orders, const Crown& crown,
               std::span<Matrix3<Scalar>> compliances) {
  if (orders.empty()) return;
  const LayerStack<Scalar>& layers = orders.front().layers;
  const auto crowned = MovedOrders<Scalar>(orders, {.radius = crown.radius, .across = AxisKind::line}).compliances();
  const auto plane =
      MovedOrders<Scalar>(orders, {.radius = layers.metric.radius, .along = AxisKind::line, .across = AxisKind::line})
          .compliances();
  const Eigen::PermutationMatrix<3> turned(Eigen::Vector3i(0, 2, 1));
  for (std::size_t i = 0; i < orders.size(); ++i) {
    compliances[i] += crown.proportion * (turned * crowned[i] * turned - plane[i]);
  }
}

}  // namespace

template <class Scalar>
void surface_compliances(std::span<const OrderInLayers<Scalar>> orders, std::span<Matrix3<Scalar>> compliances) {
  for (std::size_t first = 0; first < orders.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, orders.size() - first);
    Batch<Scalar> batch(orders.subspan(first, count));
    batch.carry([](const Batch<Scalar>&) { return true; });
    for (std::size_t l = 0; l < count; ++l) compliances[first + l] = batch.surface_compliance(l);
  }
}

void depth_states(std::span<const OrderInLayers<cplx>> orders, std::span<std::vector<DepthState>> states) {
  std::array<KeptOrder, kLanes> kept;
  for (std::size_t first = 0; first < orders.size(); first += kLanes) {
    const std::size_t count = std::min(kLanes, orders.size() - first);
    Batch<cplx> batch(orders.subspan(first, count), kDepthInside);
    for (KeptOrder& order : kept) order = {};
    batch.carry_with_inverses([&](std::size_t l, const Matrix3<cplx>& y, const Matrix3<cplx>& down) {
      kept[l].compliance.push_back(y);
      kept[l].down.push_back(down);
    });
    for (std::size_t l = 0; l < count; ++l) {
      const Eigen::Matrix3cd turn = batch.turn(l).cast<cplx>();
      states[first + l] = descend(orders[first + l], kept[l]);
      for (DepthState& state : states[first + l]) {
        state.topRows<3>() = turn * state.topRows<3>() * turn.transpose();
        state.bottomRows<3>() = turn * state.bottomRows<3>() * turn.transpose();
      }
    }
  }
}

template <class Scalar>
Matrix3<Scalar> surface_compliance(const LayerStack<Scalar>& layers, double m, double n) {
  const OrderInLayers<Scalar> order{.layers = layers, .m = m, .n = n};
  Matrix3<Scalar> compliance;
  surface_compliances<Scalar>(std::span(&order, 1), std::span(&compliance, 1));
  return compliance;
}

bool are_subcritical(std::span<const OrderInLayers<double>> orders) {
  for (std::size_t first = 0; first < orders.size(); first += kLanes) {
    Batch<double> batch(orders.subspan(first, std::min(kLanes, orders.size() - first)));
    if (!batch.carry([](const Batch<double>& b) { return b.is_positive(); })) return false;
  }
  return true;
}

template void surface_compliances(std::span<const OrderInLayers<double>>, std::span<Matrix3<double>>);
template void surface_compliances(std::span<const OrderInLayers<std::complex<double>>>,
                                  std::span<Matrix3<std::complex<double>>>);
template Matrix3<double> surface_compliance(const LayerStack<double>&, double, double);
template Matrix3<std::complex<double>> surface_compliance(const LayerStack<std::complex<double>>&, double, double);

template <class Scalar>
void crowned_compliances(std::span<const OrderInLayers<Scalar>> orders, const Crown& crown,
                         std::span<Matrix3<Scalar>> compliances) {
  surface_compliances<Scalar>(orders, compliances);
  if (!crown.is_flat()) add_crown<Scalar>(orders, crown, compliances);
}

template void crowned_compliances(std::span<const OrderInLayers<double>>, const Crown&, std::span<Matrix3<double>>);
template void crowned_compliances(std::span<const OrderInLayers<std::complex<double>>>, const Crown&,
                                  std::span<Matrix3<std::complex<double>>>);

}  // namespace viscoroll::detail

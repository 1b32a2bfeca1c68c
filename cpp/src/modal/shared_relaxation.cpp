#include "modal/shared_relaxation.hpp"

#include <cmath>
#include <complex>
#include <variant>

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

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

// Public interface for single orders inside the layers.
#include <cmath>
#include <string>

#include "base/parallel.hpp"
#include "base/validate.hpp"
#include "interior/field_components.hpp"
#include "interior/inside.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll {
namespace {

using cplx = std::complex<double>;

/// Convert from the real form, in which components and loads along phi and theta are divided by i.
cplx physical(cplx value, std::size_t component, int load) {
  const cplx i(0.0, 1.0);
  if (detail::is_imaginary(component)) value *= i;
  return load == 0 ? value : -i * value;
}

}  // namespace

std::vector<cplx> order_fields(const LayeredShape& shape, double angular_speed, std::span<const int> m,
                               std::span<const int> n, std::span<const Place> places, double radius,
                               Curvature curvature, const Observer& observer) {
  constexpr int kHighestOrder = 1000000;
  if (m.size() != n.size()) {
    detail::reject("n", "as long as m (" + std::to_string(m.size()) + ")", std::to_string(n.size()));
  }
  std::vector<double> magnitudes;
  for (const int order : m) {
    detail::require_count("m", order, -kHighestOrder, kHighestOrder);
    magnitudes.push_back(std::abs(order));
  }
  const bool across = !std::holds_alternative<CoatedCylinder>(shape);
  for (const int order : n) {
    if (!across && order != 0) detail::reject("n", "0 for a cylinder", std::to_string(order));
  }
  const auto inside = detail::inside_of(shape, angular_speed, radius, !across, curvature);
  const detail::HarmonicBody body(inside.body, inside.angular_speed, magnitudes);
  const detail::LayerCuts cuts(body.body(), places);

  detail::Watch watch(observer);
  std::vector<cplx> values(m.size() * places.size() * kFieldComponents * 3);
  detail::parallel_for(m.size(), 0, watch, "solving layers", [&](std::size_t i, const detail::Worker&) {
    // The fields are real, so order (-m, n) is the conjugate of order (m, -n).
    const bool conjugate = m[i] < 0;
    const Eigen::ArrayXd order = Eigen::ArrayXd::Constant(1, conjugate ? -n[i] : n[i]);
    const auto layers = body.layers_at(i);
    const auto pieces = cuts.pieces(layers);
    const detail::OrderInLayers<cplx> in_layers{.layers = pieces, .m = magnitudes[i], .n = order[0]};
    std::vector<detail::DepthState> states;
    detail::depth_states(std::span(&in_layers, 1), std::span(&states, 1));
    cplx* out = values.data() + i * places.size() * kFieldComponents * 3;
    for (std::size_t place = 0; place < places.size(); ++place, out += kFieldComponents * 3) {
      for (int load = 0; load < 3; ++load) {
        const detail::ComponentRows state = body.radius() * states[cuts.boundary(place)].col(load).array();
        detail::ComponentRows fields;
        detail::field_components(layers, places[place], magnitudes[i], order, state, fields);
        for (std::size_t c = 0; c < kFieldComponents; ++c) {
          const cplx value = physical(fields(static_cast<Eigen::Index>(c), 0), c, load);
          out[3 * c + static_cast<std::size_t>(load)] = conjugate ? std::conj(value) : value;
        }
      }
    }
  });
  return values;
}

}  // namespace viscoroll

#include "interior/inside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "base/validate.hpp"
#include "interior/load_spectrum.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll {
namespace {

/// Relative distance below which two places are identical.
constexpr double kSamePlace = 1e-12;

bool is_same(double place, double end) {
  return std::isfinite(end) && std::abs(place - end) <= kSamePlace * std::max(std::abs(place), std::abs(end));
}

/// Boundaries of the layers, for any rolling body.
struct Boundaries {
  std::vector<double> operator()(const CoatedPlane& plane) const {
    return detail::checked_layered_body(plane, 1.0).boundaries;
  }
  template <class Turning>
  std::vector<double> operator()(const Turning& shape) const {
    return detail::checked_layered_body(shape).boundaries;
  }
};

}  // namespace

std::vector<Place> places_at(const LayeredShape& shape, std::span<const double> positions) {
  const std::vector<double> ends = std::visit(Boundaries{}, shape);
  const bool is_plane = std::holds_alternative<CoatedPlane>(shape);
  std::vector<Place> places;
  for (const double position : positions) {
    const auto before = places.size();
    for (std::size_t layer = ends.size() - 1; (is_plane || position > 0.0) && layer-- > 0;) {
      const double inner = ends[layer];
      const double outer = ends[layer + 1];
      const double snapped = is_same(position, outer) ? outer : is_same(position, inner) ? inner : position;
      const bool inside = snapped >= inner && snapped <= outer && std::isfinite(snapped);
      if (inside) places.push_back({.position = snapped, .layer = static_cast<int>(layer)});
    }
    if (places.size() == before) {
      detail::reject(is_plane ? "height" : "radius",
                     "in [" + detail::text(ends.front()) + ", " + detail::text(ends.back()) + "] m" +
                         (is_plane ? "" : " and > 0 m"),
                     detail::text(position) + " m",
                     Range{.unit = "m", .minimum = ends.front(), .maximum = ends.back()});
    }
  }
  return places;
}

namespace detail {
namespace {

LayeredBody body_under(const CoatedSphere& sphere, double /*radius*/, bool line, Curvature curvature) {
  require_orders(curvature);
  if (line) reject("tractions.line", "false for a sphere", "true");
  return checked_layered_body(sphere, curvature);
}

LayeredBody body_under(const CoatedCylinder& cylinder, double /*radius*/, bool line, Curvature /*curvature*/) {
  if (!line) reject("tractions.line", "true for a cylinder (if the other body is a wheel, use CoatedWheel)", "false");
  return checked_layered_body(cylinder);
}

LayeredBody body_under(const CoatedWheel& wheel, double /*radius*/, bool line, Curvature /*curvature*/) {
  if (line) reject("tractions.line", "false for a wheel", "true");
  return checked_layered_body(wheel);
}

LayeredBody body_under(const CoatedPlane& plane, double radius, bool line, Curvature /*curvature*/) {
  LayeredBody body = checked_layered_body(plane, radius);
  if (line) body.metric.across = AxisKind::nothing;
  return body;
}

}  // namespace

Inside inside_of(const LayeredShape& shape, double angular_speed, double radius, bool line, Curvature curvature) {
  require_positive("angular_speed", angular_speed, "rad/s");
  require_positive("radius", radius, "m");
  LayeredBody body = std::visit([&](const auto& given) { return body_under(given, radius, line, curvature); }, shape);
  const double own_speed = angular_speed * (radius / body.metric.radius);
  return {.body = std::move(body), .angular_speed = own_speed};
}

Inside inside_of(const LayeredShape& shape, double angular_speed, const Tractions& tractions) {
  validate(tractions);
  return inside_of(shape, angular_speed, tractions.radius, tractions.line, tractions.curvature);
}

LayerCuts::LayerCuts(const LayeredBody& body, std::span<const Place> places) {
  const std::vector<double>& ends = body.boundaries;
  const double center = body.metric.is_curved() ? 0.0 : -std::numeric_limits<double>::infinity();
  boundaries_ = ends;
  for (const Place& place : places) {
    const auto layer = static_cast<std::size_t>(place.layer);
    if (place.layer < 0 || layer >= body.layers.size() || !(place.position > center) ||
        !(place.position >= ends[layer]) || !(place.position <= ends[layer + 1])) {
      reject("place", "within its layer", text(place.position) + " m in layer " + std::to_string(place.layer));
    }
    boundaries_.push_back(place.position);
  }
  std::ranges::sort(boundaries_);
  const auto repeated = std::ranges::unique(boundaries_);
  boundaries_.erase(repeated.begin(), repeated.end());
  for (const Place& place : places) {
    boundary_.push_back(
        static_cast<std::size_t>(std::ranges::lower_bound(boundaries_, place.position) - boundaries_.begin()));
  }
  for (std::size_t piece = 0; piece + 1 < boundaries_.size(); ++piece) {
    layer_.push_back(static_cast<std::size_t>(std::ranges::upper_bound(ends, boundaries_[piece]) - ends.begin() - 1));
  }
}

LayerStack<std::complex<double>> LayerCuts::pieces(const LayerStack<std::complex<double>>& layers) const {
  LayerStack<std::complex<double>> pieces{
      .metric = layers.metric, .inner_boundary = layers.inner_boundary, .media = {}};
  pieces.media.reserve(layer_.size());
  for (std::size_t piece = 0; piece < layer_.size(); ++piece) {
    pieces.media.push_back(layers.media[layer_[piece]]);
    pieces.media.back().inner = boundaries_[piece];
    pieces.media.back().outer = boundaries_[piece + 1];
  }
  return pieces;
}

}  // namespace detail
}  // namespace viscoroll

#include "interior/layer_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "validate.hpp"

namespace viscoroll {
namespace {

/// Radii this close, relatively, are one.
constexpr double kSameRadius = 1e-12;

bool is_same(double a, double b) { return std::abs(a - b) <= kSameRadius * std::max(a, b); }

}  // namespace

std::vector<Place> places_at(const CoatedSphere& sphere, std::span<const double> radii) {
  const std::vector<double> ends = detail::layered_body(sphere).boundaries;
  std::vector<Place> places;
  for (const double radius : radii) {
    const auto before = places.size();
    for (std::size_t layer = sphere.layers.size(); radius > 0.0 && layer-- > 0;) {
      const double inner = ends[layer];
      const double outer = ends[layer + 1];
      const double snapped = is_same(radius, outer) ? outer : is_same(radius, inner) ? inner : radius;
      if (snapped >= inner && snapped <= outer) places.push_back({.radius = snapped, .layer = static_cast<int>(layer)});
    }
    if (places.size() == before) {
      detail::reject("radius", "in [" + detail::text(ends.front()) + ", " + detail::text(ends.back()) + "] m and > 0 m",
                     detail::text(radius) + " m");
    }
  }
  return places;
}

namespace detail {

LayerCuts::LayerCuts(const LayeredBody& body, std::span<const Place> places) {
  const std::vector<double>& ends = body.boundaries;
  const double center = body.metric.is_curved() ? 0.0 : -std::numeric_limits<double>::infinity();
  boundaries_ = ends;
  for (const Place& place : places) {
    const auto layer = static_cast<std::size_t>(place.layer);
    if (place.layer < 0 || layer >= body.layers.size() || !(place.radius > center) || !(place.radius >= ends[layer]) ||
        !(place.radius <= ends[layer + 1])) {
      reject("place", "a radius within its layer", text(place.radius) + " m in layer " + std::to_string(place.layer));
    }
    boundaries_.push_back(place.radius);
  }
  std::ranges::sort(boundaries_);
  const auto repeated = std::ranges::unique(boundaries_);
  boundaries_.erase(repeated.begin(), repeated.end());
  for (const Place& place : places) {
    boundary_.push_back(
        static_cast<std::size_t>(std::ranges::lower_bound(boundaries_, place.radius) - boundaries_.begin()));
  }
  for (std::size_t piece = 0; piece + 1 < boundaries_.size(); ++piece) {
    layer_.push_back(static_cast<std::size_t>(std::ranges::upper_bound(ends, boundaries_[piece]) - ends.begin() - 1));
  }
}

LayerStack<std::complex<double>> LayerCuts::pieces(const LayerStack<std::complex<double>>& layers) const {
  LayerStack<std::complex<double>> pieces{.metric = layers.metric, .within = layers.within, .media = {}};
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

#include "interior/layer_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "validate.hpp"

namespace viscoroll {
namespace {

/// Radii this close, relatively, are one.
constexpr double kSameRadius = 1e-12;

std::vector<double> interfaces(const CoatedSphere& sphere) {
  std::vector<double> radii{sphere.core_radius};
  for (const Layer& layer : sphere.layers) radii.push_back(radii.back() + layer.thickness);
  return radii;
}

bool is_same(double a, double b) { return std::abs(a - b) <= kSameRadius * std::max(a, b); }

}  // namespace

std::vector<Place> places_at(const CoatedSphere& sphere, std::span<const double> radii) {
  validate(sphere);
  const std::vector<double> ends = interfaces(sphere);
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

LayerCuts::LayerCuts(const CoatedSphere& sphere, std::span<const Place> places) {
  const std::vector<double> ends = interfaces(sphere);
  radii_ = ends;
  for (const Place& place : places) {
    const auto layer = static_cast<std::size_t>(place.layer);
    if (place.layer < 0 || layer >= sphere.layers.size() || !(place.radius > 0.0) || !(place.radius >= ends[layer]) ||
        !(place.radius <= ends[layer + 1])) {
      reject("place", "a radius within its layer", text(place.radius) + " m in layer " + std::to_string(place.layer));
    }
    radii_.push_back(place.radius);
  }
  std::sort(radii_.begin(), radii_.end());
  radii_.erase(std::unique(radii_.begin(), radii_.end()), radii_.end());
  for (const Place& place : places) {
    boundary_.push_back(
        static_cast<std::size_t>(std::lower_bound(radii_.begin(), radii_.end(), place.radius) - radii_.begin()));
  }
  for (std::size_t piece = 0; piece + 1 < radii_.size(); ++piece) {
    layer_.push_back(
        static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), radii_[piece]) - ends.begin() - 1));
  }
}

std::vector<Medium<std::complex<double>>> LayerCuts::pieces(
    std::span<const Medium<std::complex<double>>> layers) const {
  std::vector<Medium<std::complex<double>>> pieces;
  pieces.reserve(layer_.size());
  for (std::size_t piece = 0; piece < layer_.size(); ++piece) {
    pieces.push_back(layers[layer_[piece]]);
    pieces.back().inner_radius = radii_[piece];
    pieces.back().outer_radius = radii_[piece + 1];
    if (piece > 0) pieces.back().within = InnerBoundary::rigid;
  }
  return pieces;
}

}  // namespace detail
}  // namespace viscoroll

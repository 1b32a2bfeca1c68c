#include "rolling/line_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "influence/line_sum.hpp"
#include "influence/order_bands.hpp"
#include "modal/centrifugal.hpp"
#include "modal/cylinder_compliance.hpp"
#include "modal/harmonic_plane.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Nodes per revolution of another circumference, for the choice of bands.
Mesh mesh_around(double circumference, double arc, const Mesh& mesh) {
  Mesh other = mesh;
  constexpr double kLargestInt = std::numeric_limits<int>::max();
  other.nodes_per_revolution = static_cast<int>(std::clamp(std::round(circumference / arc), 16.0, kLargestInt));
  return other;
}

LineSpectrum plane_spectrum(const HarmonicPlane& plane) {
  LineSpectrum spectrum;
  for (std::size_t i = 0; i < plane.orders().size(); ++i) {
    const auto layers = plane.media(i);
    const auto [uu, uk, kk, pp] = flat_compliance<cplx>(layers, plane.orders()[i] / plane.radius(), 1.0);
    spectrum.push_back({.normal = uu, .mixed = uk, .along = kk, .axial = pp});
  }
  return spectrum;
}

}  // namespace

LineSurface roller_surface(const CoatedCylinder& cylinder, double surface_speed, double arc, const Mesh& mesh,
                           int threads, Watch& watch) {
  LineSurface surface;
  if (cylinder.layers.empty()) return surface;
  const double radius = outer_radius(cylinder);
  const double angular_speed = surface_speed / radius;
  const Mesh around = mesh_around(2.0 * std::numbers::pi * radius, arc, mesh);
  std::vector<OrderBand> bands = phi_bands(layers_about_center(cylinder), angular_speed, around);
  const std::vector<double> orders = all_orders(bands);
  const double limit = measured_order(around);
  LineSpectrum spectrum = cylinder_spectrum(cylinder, angular_speed, orders, limit, threads, watch);

  const std::vector<double> few{0.0, std::numbers::pi * radius / arc, *std::ranges::max_element(orders)};
  const LineCompliance<cplx> alternating = cylinder_spectrum(cylinder, angular_speed, few, limit, threads, watch)[1];
  surface.normal = alternating.normal;
  surface.along = alternating.along;
  std::vector<cplx> at_rest;
  for (const auto& moduli : harmonic_moduli(cylinder.layers, angular_speed, few, limit)) {
    at_rest.push_back(moduli.front());
    surface.stiffest_modulus = std::max(surface.stiffest_modulus, std::abs(moduli.back()));
  }
  surface.centrifugal = cylinder_centrifugal_displacement(cylinder_media(cylinder, at_rest, angular_speed));
  surface.sum = std::make_unique<const LineSum>(std::move(bands), std::move(spectrum), radius, arc / radius,
                                                arc / phi_spacing(mesh));
  return surface;
}

LineSurface plane_surface(const CoatedPlane& plane, double surface_speed, double radius, const Mesh& mesh) {
  LineSurface surface;
  if (is_rigid(plane)) return surface;
  if (mesh.max_order) {
    reject("mesh.max_order", "left out where a plane deforms, whose orders are not whole",
           std::to_string(*mesh.max_order));
  }
  std::vector<OrderBand> bands = plane_bands(plane, surface_speed / radius, radius, mesh).phi;
  const double limit = measured_order(mesh);
  const HarmonicPlane harmonics(plane, surface_speed, radius, all_orders(bands), limit);
  const double highest = *std::ranges::max_element(harmonics.orders());
  const HarmonicPlane few(plane, surface_speed, radius, {0.5 * mesh.nodes_per_revolution, highest}, limit);
  const LineCompliance<cplx> alternating = plane_spectrum(few).front();
  surface.normal = alternating.normal;
  surface.along = alternating.along;
  for (std::size_t layer = 0; layer < few.layers().size(); ++layer) {
    surface.stiffest_modulus = std::max(surface.stiffest_modulus, std::abs(few.modulus(layer, 1)));
  }
  surface.sum =
      std::make_unique<const LineSum>(std::move(bands), plane_spectrum(harmonics), radius, phi_spacing(mesh), radius);
  return surface;
}

}  // namespace viscoroll::detail

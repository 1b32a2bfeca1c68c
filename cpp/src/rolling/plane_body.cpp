// A plane, or a groove whose layers are a plane's, under a spot or a line: theory.md sections 14 and 15.
#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "influence/coating_sum.hpp"
#include "influence/line_sum.hpp"
#include "influence/order_bands.hpp"
#include "modal/harmonic_plane.hpp"
#include "rolling/body.hpp"
#include "rolling/table_store.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Of a ball in a groove, radius by radius: in a closer one contact is no longer shallow.
constexpr double kClosestFit = 1.0 / 1.02;

double stiffest_modulus(const HarmonicPlane& harmonics, std::size_t order) {
  double stiffest = 0.0;
  for (std::size_t layer = 0; layer < harmonics.layers().size(); ++layer) {
    stiffest = std::max(stiffest, std::abs(harmonics.modulus(layer, order)));
  }
  return stiffest;
}

BodySurface under_spot(const CoatedPlane& plane, const Crossing& crossing) {
  const auto& [threads, watch] = crossing.execution;
  const Mesh& mesh = crossing.mesh;
  BodySurface surface;
  surface.tables = std::make_unique<const TableStore>(
      std::make_unique<const OrderSum>(plane_sum(plane, crossing.angular_speed, crossing.radius, mesh, threads, watch)),
      mesh);
  const double highest = 0.5 * mesh.nodes_per_revolution;
  const HarmonicPlane harmonics(plane, crossing.speed(), crossing.radius, {highest, 16.0 * highest},
                                measured_order(mesh));
  const OrderAt order{.i = 0, .n = 0.0};
  Eigen::Matrix3cd compliance;
  harmonics.compliances(std::span(&order, 1), std::span(&compliance, 1));
  surface.normal = compliance(0, 0);
  surface.along = compliance(1, 1);
  surface.stiffest_modulus = stiffest_modulus(harmonics, 1);
  return surface;
}

LineSpectrum line_spectrum(const HarmonicPlane& plane) {
  LineSpectrum spectrum;
  for (std::size_t i = 0; i < plane.orders().size(); ++i) {
    const auto layers = plane.media(i);
    const auto [uu, uk, kk, pp] = flat_compliance<cplx>(layers, plane.orders()[i] / plane.radius(), 1.0);
    spectrum.push_back({.normal = uu, .mixed = uk, .along = kk, .axial = pp});
  }
  return spectrum;
}

BodySurface under_line(const CoatedPlane& plane, const Crossing& crossing) {
  const Mesh& mesh = crossing.mesh;
  const double radius = crossing.radius;
  if (mesh.max_order) {
    reject("mesh.max_order", "left out where a plane deforms, whose orders are not whole",
           std::to_string(*mesh.max_order));
  }
  std::vector<OrderBand> bands = plane_bands(plane, crossing.speed() / radius, radius, mesh).phi;
  const double limit = measured_order(mesh);
  const HarmonicPlane harmonics(plane, crossing.speed(), radius, all_orders(bands), limit);
  const double highest = *std::ranges::max_element(harmonics.orders());
  const HarmonicPlane few(plane, crossing.speed(), radius, {0.5 * mesh.nodes_per_revolution, highest}, limit);
  const LineCompliance<cplx> alternating = line_spectrum(few).front();
  BodySurface surface{
      .normal = alternating.normal, .along = alternating.along, .stiffest_modulus = stiffest_modulus(few, 1)};
  surface.tables = std::make_unique<const TableStore>(
      std::make_unique<const LineSum>(std::move(bands), line_spectrum(harmonics), radius, phi_spacing(mesh), radius),
      mesh);
  return surface;
}

BodySurface surface_of(const CoatedPlane& plane, const Crossing& crossing) {
  if (is_rigid(plane)) return {};
  return crossing.form.is_line() ? under_line(plane, crossing) : under_spot(plane, crossing);
}

/// @param[in] hollow_radius > 0 where the surface is hollow [m]; none: straight
double curvature(const std::optional<double>& hollow_radius) { return hollow_radius ? -1.0 / *hollow_radius : 0.0; }

void require_room(std::string_view name, double curvature, double radius) {
  if (-radius * curvature < kClosestFit) return;
  reject(name, "larger than the ball's radius, " + text(radius) + " m, by 2 % at the least",
         text(-1.0 / curvature) + " m");
}

}  // namespace

Body make_body(const CoatedPlane& plane) {
  std::vector<NamedLayer> layers = named(plane.layers);
  if (plane.base) layers.insert(layers.begin(), {.name = "base", .layer = layers_from_base(plane).front()});
  return {.type = "CoatedPlane",
          .layers = std::move(layers),
          .curvatures = {},
          .surface = [plane](const Crossing& crossing) { return surface_of(plane, crossing); },
          .profile = circles({})};
}

Body make_body(const Groove& groove) {
  Body body = make_body(groove.surface);
  const Curvatures curvatures{.along = curvature(groove.path_radius), .across = curvature(groove.radius)};
  body.type = "Groove";
  body.curvatures = curvatures;
  body.profile = circles(curvatures);
  body.require_room_for = [curvatures](const Body& ball) {
    require_room("on.radius", curvatures.across, ball.radius);
    require_room("on.path_radius", curvatures.along, ball.radius);
  };
  return body;
}

}  // namespace viscoroll::detail

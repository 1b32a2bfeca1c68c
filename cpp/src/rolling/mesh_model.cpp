#include "rolling/mesh_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "validate.hpp"

namespace viscoroll::detail {
namespace {

/// Loads that alternate from row to row see the mesh's highest order m. The displacement at the nodes resists them with
/// the real part of its compliance alone, |C| cos(a), which dies out as the phase a comes close to 90 degrees, as that
/// of a Kelvin-Voigt material does. Displacements that are taken s spacings downstream resist with |C| cos(a - pi s):
/// at 45 degrees and less s = 0, beyond so much that a - pi s stays there. Theory.md section 5.
/// @param[in] normal,along compliance of that order
double stable_collocation(std::complex<double> normal, std::complex<double> along) {
  const double phase = std::max(-std::arg(normal), -std::arg(along));
  return std::clamp(phase / std::numbers::pi - 0.25, 0.0, 0.25);
}

}  // namespace

MeshModel make_model(const RollingPair& pair, double angular_speed, const Mesh& mesh, Curvature curvature,
                     const Execution& execution, double inertia_tolerance) {
  const Crossing crossing = crossing_of(pair, angular_speed, mesh, curvature, execution, inertia_tolerance);
  BodySurface own = pair.body.surface(crossing);
  BodySurface counterpart = pair.on.surface(crossing);
  return {.pair = pair,
          .angular_speed = angular_speed,
          .mesh = mesh,
          .curvature = curvature,
          .own = std::move(own.tables),
          .counterpart = std::move(counterpart.tables),
          .stiffest_modulus = std::max(own.stiffest_modulus, counterpart.stiffest_modulus),
          .centrifugal = own.centrifugal + counterpart.centrifugal,
          .collocation = stable_collocation(own.normal + counterpart.normal, own.along + counterpart.along)};
}

}  // namespace viscoroll::detail

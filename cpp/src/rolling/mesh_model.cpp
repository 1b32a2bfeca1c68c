#include "rolling/mesh_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/invalid_speed.hpp"
#include "base/validate.hpp"
#include "modal/centrifugal.hpp"

namespace viscoroll::detail {
namespace {

/// @brief Distance downstream of the nodes at which displacements are evaluated [spacings].
///
/// Forces that alternate from row to row excite the highest order m of the mesh, whose compliance is C = |C| exp(-ia).
/// Displacements at the nodes resist such forces with |C| cos(a) only. This vanishes as the phase a approaches 90
/// degrees, as in a Kelvin-Voigt material, and pressures behind the leading edge alternate at much smaller phases.
/// Displacements s spacings downstream resist with |C| cos(a - pi s), which is the full |C| at s = a / pi.
///
/// A modulus with one relaxation time that relaxes by half, such as the paper's rubber, has a largest phase of
/// atan(1 / sqrt(8)). Up to this phase displacements are evaluated at the nodes, as in the paper. See
/// docs/theory/normal-contact.md, "Strong memory".
/// @param[in] normal,along compliance of that order in the normal and in the rolling direction
double stable_collocation(std::complex<double> normal, std::complex<double> along) {
  const double halved = std::atan(1.0 / std::sqrt(8.0)) / std::numbers::pi;
  // The shift rises with this slope from 0 and reaches a / pi at 4/3 of that phase, so that torques do not jump.
  constexpr double kOnset = 4.0;
  // A larger shift would increase the error of the power balance of nearly viscous materials.
  constexpr double kMaxShift = 0.25;
  const double full = std::max(-std::arg(normal), -std::arg(along)) / std::numbers::pi;
  return std::clamp(std::min(full, kOnset * (full - halved)), 0.0, kMaxShift);
}

double centrifugal_displacement_of(const Body& body, const SurfaceMotion& motion) {
  if (body.is_rigid()) return 0.0;
  const LayeredBody layers = body.layered(motion);
  return centrifugal_displacement(layers, motion.angular_speed_at(layers.metric.radius));
}

/// @throws InvalidInput if the rolling body would grow to fill the counterbody in which it rolls
void require_room_for_growth(const PairAtSpeed& pair) {
  const Curvatures& own = pair.body->curvatures();
  const Curvatures& on = pair.on->curvatures();
  const CentrifugalGrowth& growth = pair.growth;
  const bool is_tread = std::isfinite(width(pair));
  const double along = growth.own * own.along + growth.met() * on.along;
  const double across = is_tread ? 1.0 : growth.own * own.across + growth.met() * on.across;
  if (along > 0.0 && (pair.body->form().is_line() || across > 0.0)) return;
  throw InvalidSpeed(
      pair.angular_speed,
      {.before = "so low that the " + std::string(pair.body->name()) + " does not grow to fill the counterbody",
       .remark = " (centrifugal growth of the radius by a fraction of " + rounded(growth.own - 1.0) + ")"});
}

}  // namespace

PairAtSpeed at_speed(const RollingPair& pair, double angular_speed) {
  // The choice of the curvature terms affects tangential displacements only, and the uniform displacement has none.
  const SurfaceMotion motion = motion_of(pair, angular_speed, Curvature::sphere);
  const double own = centrifugal_displacement_of(*pair.body, motion);
  const double counterbody = centrifugal_displacement_of(*pair.on, motion);
  PairAtSpeed at{pair,
                 angular_speed,
                 own + counterbody,
                 {.own = 1.0 + own * pair.body->curvatures().along,
                  .counterbody = 1.0 + counterbody * pair.on->curvatures().along}};
  require_room_for_growth(at);
  return at;
}

MeshModel make_model(const PairAtSpeed& pair, const Mesh& mesh, Curvature curvature, const Execution& execution,
                     const TableNeeds& needs) {
  const ContactKinematics kinematics = kinematics_of(pair, pair.angular_speed, mesh, curvature, execution, needs);
  BodySurface own = pair.body->surface(kinematics);
  BodySurface counterbody = pair.on->surface(kinematics);
  return {.pair = pair,
          .mesh = mesh,
          .curvature = curvature,
          .own = std::move(own.tables),
          .counterbody = std::move(counterbody.tables),
          .stiffest_modulus = std::max(own.stiffest_modulus, counterbody.stiffest_modulus),
          .has_losses = needs.has_losses,
          .collocation = stable_collocation(own.normal + counterbody.normal, own.along + counterbody.along)};
}

}  // namespace viscoroll::detail

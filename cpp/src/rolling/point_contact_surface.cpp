#include "rolling/point_contact_surface.hpp"

#include <numbers>
#include <utility>

#include "influence/table_sums.hpp"
#include "modal/centrifugal.hpp"
#include "modal/harmonic_body.hpp"
#include "rolling/table_store.hpp"

namespace viscoroll::detail {

std::unique_ptr<const TableSum> sum_under_spot(const LayeredBody& layers, const ContactKinematics& kinematics) {
  const auto& [threads, watch] = kinematics.execution;
  const double radius = layers.metric.radius;
  return std::make_unique<const CoatingSum>(layers, kinematics.angular_speed_at(radius), kinematics.mesh_at(radius),
                                            threads, watch, kinematics.inertia_tolerance);
}

BodySurface surface_under_spot(const LayeredBody& layers, const ContactKinematics& kinematics) {
  const Mesh around = kinematics.mesh_at(layers.metric.radius).rounded();
  return surface_under_spot(layers, kinematics,
                            std::make_unique<const TableStore>(sum_under_spot(layers, kinematics), around));
}

BodySurface surface_under_spot(const LayeredBody& layers, const ContactKinematics& kinematics,
                               std::unique_ptr<const SurfaceTables> tables) {
  const double radius = layers.metric.radius;
  const MeshOnBody mesh = kinematics.mesh_at(radius);
  const double angular_speed = kinematics.angular_speed_at(radius);
  BodySurface surface;
  surface.tables = std::move(tables);
  const double highest = std::numbers::pi / mesh.phi_spacing();
  const HarmonicBody harmonics(layers, angular_speed, {highest, 16.0 * highest}, measured_order(mesh.rounded()));
  const Eigen::Matrix3cd compliance = harmonics.compliance({.i = 0, .n = 0.0});
  surface.normal = compliance(0, 0);
  surface.along = compliance(1, 1);
  surface.stiffest_modulus = harmonics.stiffest_modulus();
  surface.centrifugal = centrifugal_displacement(layers, angular_speed);
  return surface;
}

}  // namespace viscoroll::detail

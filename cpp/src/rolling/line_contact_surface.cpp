#include "rolling/line_contact_surface.hpp"

#include <numbers>
#include <utility>

#include "influence/order_bands.hpp"
#include "influence/table_sums.hpp"
#include "modal/centrifugal.hpp"
#include "modal/harmonic_body.hpp"
#include "rolling/table_store.hpp"

namespace viscoroll::detail {

std::unique_ptr<const TableSum> sum_under_line(const LayeredBody& layers, const ContactKinematics& kinematics) {
  const auto& [threads, watch] = kinematics.execution;
  const double angular_speed = kinematics.angular_speed_at(layers.metric.radius);
  const MeshOnBody mesh = kinematics.mesh_at(layers.metric.radius);
  std::vector<OrderBand> bands = phi_bands(layers, angular_speed, mesh.rounded());
  const HarmonicBody harmonics(layers, angular_speed, all_orders(bands), measured_order(mesh.rounded()));
  return std::make_unique<const LineSum>(std::move(bands), harmonics, mesh, threads, watch);
}

BodySurface surface_under_line(const LayeredBody& layers, const ContactKinematics& kinematics) {
  const double angular_speed = kinematics.angular_speed_at(layers.metric.radius);
  const MeshOnBody mesh = kinematics.mesh_at(layers.metric.radius);
  const Mesh& around = mesh.rounded();
  const double limit = measured_order(around);
  const HarmonicBody harmonics(layers, angular_speed, all_orders(phi_bands(layers, angular_speed, around)), limit);
  const HarmonicBody alternating(layers, angular_speed, {std::numbers::pi / mesh.phi_spacing()}, limit);
  const Eigen::Matrix3cd compliance = alternating.compliance({.i = 0, .n = 0.0});
  return {.tables = std::make_unique<const TableStore>(sum_under_line(layers, kinematics), around),
          .normal = compliance(0, 0),
          .along = compliance(1, 1),
          .stiffest_modulus = harmonics.stiffest_modulus(),
          .centrifugal = centrifugal_displacement(layers, angular_speed)};
}

}  // namespace viscoroll::detail

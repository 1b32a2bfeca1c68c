#include "rolling/contact_surface.hpp"

#include <numbers>
#include <utility>

#include "influence/order_bands.hpp"
#include "influence/table_sums.hpp"
#include "modal/harmonic_body.hpp"
#include "rolling/table_store.hpp"

namespace viscoroll::detail {

std::unique_ptr<const TableSum> sum_of_orders(const LayeredBody& layers, const ContactKinematics& kinematics) {
  const auto& [threads, watch] = kinematics.execution;
  const double angular_speed = kinematics.angular_speed_at(layers.metric.radius);
  const MeshOnBody mesh = kinematics.mesh_at(layers.metric.radius);
  if (!kinematics.form.is_line()) {
    return std::make_unique<const CoatingSum>(layers, angular_speed, mesh, threads, watch,
                                              kinematics.needs.inertia_tolerance);
  }
  std::vector<OrderBand> bands = phi_bands(layers, angular_speed, mesh.rounded());
  const HarmonicBody harmonics(layers, angular_speed, all_orders(bands), measured_order(mesh.rounded()));
  return std::make_unique<const LineSum>(std::move(bands), harmonics, mesh, threads, watch);
}

BodySurface surface_of_layers(const LayeredBody& layers, const ContactKinematics& kinematics) {
  const Mesh around = kinematics.mesh_at(layers.metric.radius).rounded();
  return surface_of_layers(
      layers, kinematics,
      std::make_unique<const TableStore>(sum_of_orders(layers, kinematics), around, kinematics.needs.has_losses));
}

BodySurface surface_of_layers(const LayeredBody& layers, const ContactKinematics& kinematics,
                              std::unique_ptr<const SurfaceTables> tables) {
  const MeshOnBody mesh = kinematics.mesh_at(layers.metric.radius);
  const double highest = std::numbers::pi / mesh.phi_spacing();
  // The bands of the tables do not contain the highest order of the mesh itself.
  const HarmonicBody harmonics(layers, kinematics.angular_speed_at(layers.metric.radius), {highest, 16.0 * highest},
                               measured_order(mesh.rounded()));
  const Eigen::Matrix3cd compliance = harmonics.compliance({.i = 0, .n = 0.0});
  return {.tables = std::move(tables),
          .normal = compliance(0, 0),
          .along = compliance(1, 1),
          .stiffest_modulus = harmonics.stiffest_modulus()};
}

}  // namespace viscoroll::detail

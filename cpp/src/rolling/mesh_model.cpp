#include "rolling/mesh_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>
#include <string>

#include "modal/centrifugal.hpp"
#include "validate.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll::detail {
namespace {

/// Up to this reach the compliance of the orders costs more than their sums: tables of all kinds are made together.
constexpr int kShortReach = 128;

std::vector<TableRequest> requests(const Formulation& formulation, TableKind kind) {
  return kind == TableKind::displacement ? displacement_tables(formulation) : dissipation_tables(formulation);
}

/// Inertia joins neighboring degrees on the exact sphere: it is left out there, or the speed refused where it counts.
CoatedSphere without_inertia(CoatedSphere sphere, double angular_speed) {
  constexpr double kNegligible = 1e-3;  // of rho (Omega r_o)^2 per modulus, which changes the torque by less
  const HarmonicCoating coating = coating_at_rest(sphere, angular_speed, Curvature::sphere);
  const double speed = angular_speed * coating.outer_radius();
  for (std::size_t l = 0; l < sphere.layers.size(); ++l) {
    const double share = sphere.layers[l].density * speed * speed / std::abs(coating.modulus(l, 0));
    if (share > kNegligible) {
      reject("layers[" + std::to_string(l) + "].density",
             "so small that inertia is negligible with curvature EXACT, at most " +
                 text(sphere.layers[l].density * kNegligible / share) + " kg/m^3 at this speed",
             text(sphere.layers[l].density) + " kg/m^3");
    }
    sphere.layers[l].density = 0.0;
  }
  return sphere;
}

/// Loads that alternate from row to row see the mesh's highest order m. The displacement at the nodes resists them with
/// the real part of its compliance alone, |C| cos(a), which dies out as the phase a comes close to 90 degrees, as that
/// of a Kelvin-Voigt material does. Displacements that are taken s spacings downstream resist with |C| cos(a - pi s):
/// at 45 degrees and less s = 0, beyond so much that a - pi s stays there. Theory.md section 5.
double stable_collocation(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, Curvature curvature) {
  const std::array m{mesh.nodes_per_revolution / 2};
  const std::array n{0};
  const ComplexMatrix3 compliance = surface_compliance(sphere, angular_speed, m, n, curvature).front();
  const double phase = std::max(-std::arg(compliance[0]), -std::arg(compliance[4]));
  return std::clamp(phase / std::numbers::pi - 0.25, 0.0, 0.25);
}

}  // namespace

MeshModel::MeshModel(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, Curvature curvature,
                     int threads, Watch& watch, double inertia_tolerance)
    : orders_(curvature == Curvature::exact ? without_inertia(sphere, angular_speed) : sphere, angular_speed, mesh,
              threads, watch, curvature == Curvature::exact ? Curvature::sphere : curvature, inertia_tolerance),
      centrifugal_(centrifugal_displacement(coating_at_rest(sphere, angular_speed, coating().curvature()))),
      collocation_(stable_collocation(coating().sphere(), angular_speed, mesh, coating().curvature())) {
  if (curvature == Curvature::exact) {
    sphere_tables_ = std::make_unique<const SphereTables>(SphereSum(coating().sphere(), angular_speed, mesh));
  }
}

std::shared_ptr<const std::vector<Table>> MeshModel::tables(const Formulation& formulation, TableKind kind,
                                                            int phi_reach, int theta_reach,
                                                            const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  if (const TableSet* set = find(formulation, kind)) {
    if (set->phi_reach >= phi_reach && set->theta_reach >= theta_reach) return set->tables;
    // Rising loads are to ask for few sets.
    phi_reach = std::min(std::max(phi_reach, 3 * set->phi_reach / 2), mesh().nodes_per_revolution / 2);
    theta_reach = std::min(std::max(theta_reach, 3 * set->theta_reach / 2), theta_nodes_per_revolution(mesh()) / 2);
  }
  constexpr std::array kAll{TableKind::displacement, TableKind::dissipation};
  const bool together = std::max(phi_reach, theta_reach) <= kShortReach;
  add(formulation, together ? std::span<const TableKind>(kAll) : std::span(&kind, 1), phi_reach, theta_reach,
      execution);
  return find(formulation, kind)->tables;
}

void MeshModel::add(const Formulation& formulation, std::span<const TableKind> kinds, int phi_reach, int theta_reach,
                    const Execution& execution) const {
  std::vector<TableRequest> all;
  for (const TableKind kind : kinds) {
    const auto wanted = requests(formulation, kind);
    all.insert(all.end(), wanted.begin(), wanted.end());
  }
  std::vector<Table> tables = orders_.tables(all, phi_reach, theta_reach, execution.threads, execution.watch);
  auto next = std::make_move_iterator(tables.begin());
  for (const TableKind kind : kinds) {
    const auto end = next + static_cast<std::ptrdiff_t>(requests(formulation, kind).size());
    std::erase_if(sets_, [&](const TableSet& set) { return set.formulation == formulation && set.kind == kind; });
    sets_.push_back({.formulation = formulation,
                     .kind = kind,
                     .phi_reach = phi_reach,
                     .theta_reach = theta_reach,
                     .tables = std::make_shared<const std::vector<Table>>(next, end)});
    next = end;
  }
}

const MeshModel::TableSet* MeshModel::find(const Formulation& formulation, TableKind kind) const {
  const auto set =
      std::ranges::find_if(sets_, [&](const TableSet& s) { return s.formulation == formulation && s.kind == kind; });
  return set == sets_.end() ? nullptr : &*set;
}

}  // namespace viscoroll::detail

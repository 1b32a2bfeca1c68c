#include "rolling/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "rolling/contact_estimate.hpp"
#include "rolling/rolling_contact.hpp"

namespace viscoroll::detail {
namespace {

constexpr double kFirstNodesPerRadius = 6.0;  // of the first mesh, in the estimated contact radius
constexpr double kRefinement = 1.4;           // of the spacing, from mesh to mesh
constexpr int kMaxNodesPerRevolution = 8000;  // above, the sum over all orders of the sphere takes too long

Mesh make_mesh(double nodes_per_revolution) {
  const int nodes =
      std::clamp(2 * static_cast<int>(std::lround(nodes_per_revolution / 2.0)), 64, kMaxNodesPerRevolution);
  return {.nodes_per_revolution = nodes};
}

double relative_change(double value, double before, double negligible) {
  return std::abs(value - before) /
         std::max({std::abs(value), std::abs(before), negligible, std::numeric_limits<double>::min()});
}

/// Whether the next mesh would ask for more orders, or with friction for more unknowns, than are at hand.
bool is_finest(const Result& result, double friction) {
  const double next = 3.0 * result.refinements.back().contact_nodes * kRefinement * kRefinement;
  return result.mesh.nodes_per_revolution >= kMaxNodesPerRevolution || (friction > 0.0 && next > 0.5 * kMaxUnknowns);
}

}  // namespace

Result solve_to_accuracy(const CoatedSphere& sphere, const LoadCase& load_case, const Options& options, Watch& watch) {
  const double radius =
      estimate_contact_radius(HarmonicCoating(sphere, load_case.angular_speed, {0.0}), load_case.load);
  Mesh mesh = make_mesh(2.0 * std::numbers::pi * kFirstNodesPerRadius * outer_radius(sphere) / radius);
  std::vector<Refinement> refinements;
  for (;;) {
    const MeshModel model(sphere, load_case.angular_speed, mesh, options.threads, watch);
    Result result = solve_load_case(model, load_case, options, watch);
    Refinement& step = result.refinements.back();
    step.error_estimate = 1.0;  // nothing to compare the first mesh with
    if (!refinements.empty()) {
      const double negligible = 1e-10 * load_case.load * result.semi_axis_x;
      step.error_estimate =
          std::max({step.power_balance_error,
                    relative_change(result.resisting_torque, refinements.back().resisting_torque, negligible),
                    relative_change(result.penetration, refinements.back().penetration, 0.0)});
    }
    result.error_estimate = step.error_estimate;
    refinements.push_back(step);
    const bool accurate = result.error_estimate <= options.accuracy;
    if (accurate || is_finest(result, load_case.friction) || result.status != Status::converged) {
      if (!accurate && result.status == Status::converged) result.status = Status::accuracy_not_reached;
      result.refinements = std::move(refinements);
      return result;
    }
    mesh = make_mesh(kRefinement * mesh.nodes_per_revolution);
  }
}

}  // namespace viscoroll::detail

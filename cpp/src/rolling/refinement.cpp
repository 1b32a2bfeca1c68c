#include "rolling/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rolling/contact_estimate.hpp"
#include "rolling/rolling_contact.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kFewestNodesPerRevolution = 64;
constexpr double kMostContactNodes = 3e6;            // a third of a gigabyte of fields
constexpr double kMostFrictionalContactNodes = 4e5;  // whose Krylov methods keep some tens of vectors

Mesh make_mesh(double nodes_per_revolution) {
  const auto nodes = static_cast<int>(std::lround(nodes_per_revolution));
  return {.nodes_per_revolution = std::clamp(nodes, kFewestNodesPerRevolution, kMostNodesPerRevolution)};
}

/// Nodes in the estimated contact radius that should do. Nodes that join the contact one by one leave a staircase in
/// the torque over load or speed, of 0.4 % with 41 nodes across the contact of the paper's example, falling with the
/// power 2.3 of their number. A tenth of the accuracy is asked of it; the estimate is half as wide again as the
/// contact.
double nodes_per_radius(double accuracy) { return 0.75 * 41.0 * std::pow(10.0 * 0.004 / accuracy, 1.0 / 2.3); }

double relative_change(double value, double before, double negligible) {
  return std::abs(value - before) /
         std::max({std::abs(value), std::abs(before), negligible, std::numeric_limits<double>::min()});
}

/// Whether the next mesh would ask for more than is at hand.
bool is_finest(const Result& result, double friction) {
  const double next = 4.0 * result.refinements.back().contact_nodes;
  return result.mesh.nodes_per_revolution == kMostNodesPerRevolution ||
         next > (friction > 0.0 ? kMostFrictionalContactNodes : kMostContactNodes);
}

}  // namespace

Result solve_to_accuracy(const CoatedSphere& sphere, const LoadCase& load_case, const Options& options, Watch& watch) {
  const double radius =
      estimate_contact_radius(HarmonicCoating(sphere, load_case.angular_speed, {0.0}), load_case.load);
  // The first mesh is to show the error of the second, which should do.
  double nodes = std::numbers::pi * nodes_per_radius(options.accuracy) * outer_radius(sphere) / radius;
  std::vector<Refinement> refinements;
  for (;; nodes *= 2.0) {
    const Mesh mesh = make_mesh(nodes);
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
  }
}

}  // namespace viscoroll::detail

#include "contact/contact_problem.hpp"

#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// Rows of the given nodes.
template <class Values>
Values picked(const Values& values, const std::vector<Index>& nodes) {
  return values(nodes, Eigen::all);
}

ContactProblem with_nodes(const ContactProblem& problem, std::shared_ptr<const SurfaceOperator> surface,
                          const std::vector<Index>& nodes) {
  ContactProblem result{.surface = std::move(surface),
                        .initial_gap = picked(problem.initial_gap, nodes),
                        .normal_force = problem.normal_force,
                        .friction = problem.friction,
                        .ends_at_sides = problem.ends_at_sides,
                        .penetration = problem.penetration,
                        .attraction = problem.attraction,
                        .largest_tension = problem.largest_tension};
  if (result.attraction) {
    for (const auto member : {&Attraction::x, &Attraction::z, &Attraction::area}) {
      (*result.attraction).*member = picked((*problem.attraction).*member, nodes);
    }
  }
  if (result.friction) {
    Friction& friction = *result.friction;
    friction.shared.reset();
    const MomentArms& arms = problem.friction->arms;
    friction.arms = {.x = picked(arms.x, nodes), .y = picked(arms.y, nodes), .radius = arms.radius};
    if (arms.slope.size() > 0) friction.arms.slope = picked(arms.slope, nodes);
    for (const auto member : {&Friction::rigid_slip, &Friction::counterbody_rigid_displacement}) {
      (friction.*member) = picked((*problem.friction).*member, nodes);
      (friction.*member).topRows(result.surface->shape().theta_nodes).setZero();
    }
  }
  return result;
}

}  // namespace

NormalCondition ContactProblem::normal_condition(double stiffness) const {
  if (penetration) return {.per_force = 0.0, .per_penetration = 1.0, .value = stiffness * *penetration};
  return {.per_force = 1.0, .per_penetration = 0.0, .value = normal_force};
}

void scale_by(const ContactSolution& state, ContactProblem& problem) {
  if (problem.penetration) problem.normal_force = pressing_force(state).sum();
}

ContactProblem coarsened(const ContactProblem& problem) {
  const Window& fine = problem.surface->window();
  const Window coarse = fine.coarsened();
  std::vector<Index> nodes;
  for (int i = coarse.phi.first; i <= coarse.phi.last; ++i) {
    for (int k = coarse.theta.first; k <= coarse.theta.last; ++k) nodes.push_back(fine.number_of(2 * i, 2 * k));
  }
  ContactProblem result = with_nodes(problem, problem.surface->coarsened(), nodes);
  if (result.attraction) {
    result.attraction->spacing *= 2.0;
    result.attraction->area *= fine.is_line() ? 2.0 : 4.0;
  }
  // If displacements are evaluated downstream of the nodes, those of a coarse mesh lie between two fine rows.
  const double share = problem.surface->collocation();
  const auto next_row = [&](Index node) { return nodes[static_cast<std::size_t>(node)] + fine.theta.count(); };
  for (Index node = 0; share > 0.0 && node < coarse.shape().size(); ++node) {
    result.initial_gap[node] += share * (problem.initial_gap[next_row(node)] - result.initial_gap[node]);
  }
  if (result.friction) {
    const Index stride = fine.theta.count();
    for (const auto member : {&Friction::rigid_slip, &Friction::counterbody_rigid_displacement}) {
      const Eigen::ArrayX2d& fine_displacement = (*problem.friction).*member;
      Eigen::ArrayX2d& coarse_displacement = (*result.friction).*member;
      for (Index node = coarse.theta.count(); node < coarse.shape().size(); ++node) {  // two fine steps per coarse one
        const Index fine_node = nodes[static_cast<std::size_t>(node)];
        coarse_displacement.row(node) += (1.0 - share) * fine_displacement.row(fine_node - stride);
        if (share > 0.0) coarse_displacement.row(node) += share * fine_displacement.row(fine_node + stride);
      }
    }
    result.friction->step *= 2.0;
  }
  return result;
}

ContactProblem within(const ContactProblem& problem, const Window& window) {
  if (window == problem.surface->window()) return problem;
  std::vector<Index> nodes;
  for_nodes_within(problem.surface->window(), window, [&](Index, Index outer) { nodes.push_back(outer); });
  ContactProblem inside = with_nodes(problem, problem.surface->within(window), nodes);
  inside.ends_at_sides = problem.ends_at_sides && window.theta == problem.surface->window().theta;
  return inside;
}

bool is_mirror_symmetric(const ContactProblem& problem) {
  const Window& window = problem.surface->window();
  if (window.theta.first != -window.theta.last) return false;
  const Index stride = window.theta.count();
  for (Index node = 0; node < window.shape().size(); ++node) {
    const Index image = node + stride - 1 - 2 * (node % stride);
    if (problem.initial_gap[node] != problem.initial_gap[image]) return false;
    if (!problem.friction) continue;
    const auto& rigid_slip = problem.friction->rigid_slip;
    if (rigid_slip(node, 0) != rigid_slip(image, 0) || rigid_slip(node, 1) != -rigid_slip(image, 1)) return false;
  }
  return true;
}

Eigen::ArrayX2d increments(const VectorField& displacement, Index stride) {
  const Index rest = displacement.rows() - stride;
  Eigen::ArrayX2d increment = Eigen::ArrayX2d::Zero(displacement.rows(), 2);
  for (const auto& [column, axis] : {std::pair{0, kForward}, std::pair{1, kSideways}}) {
    increment.col(column).tail(rest) = displacement.col(axis).tail(rest) - displacement.col(axis).head(rest);
  }
  return increment;
}

Eigen::ArrayX2d slip(const Friction& friction, Index stride, const ContactSolution& state) {
  Eigen::ArrayX2d slip = friction.rigid_slip + *state.creepage * friction.counterbody_rigid_displacement +
                         increments(state.displacement, stride);
  if (state.counterbody_displacement.rows() > 0) {
    slip += *state.creepage * increments(state.counterbody_displacement, stride);
  }
  return slip;
}

}  // namespace viscoroll::detail

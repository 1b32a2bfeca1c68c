#include "contact/dense_pressed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/validate.hpp"
#include "contact/krylov.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Largest number of nodes for which factors of the compliance matrix take less time than transforms over the window.
constexpr std::size_t kMaxNodes = 600;
constexpr double kFullAccuracy = 1e-14;  // relative residual, so small that the guess does not affect the solution
constexpr std::size_t kNodesPerAllowedChange = 6;  // factor again if more than one node in six has changed

}  // namespace

DensePressedSurface::DensePressedSurface(const ContactProblem& problem)
    : problem_(problem),
      is_symmetric_(is_mirror_symmetric(problem)),
      weights_(ArrayXd::Ones(problem.initial_gap.size())) {}

bool DensePressedSurface::is_applicable(const ContactProblem& problem, const std::vector<Index>& nodes) {
  return !nodes.empty() && nodes.size() <= kMaxNodes &&
         problem.surface->normal_compliance({nodes.front()}, {nodes.front()}).has_value();
}

Index DensePressedSurface::image_of(Index node) const {
  const Index width = problem_.surface->shape().theta_nodes;
  return node + width - 1 - 2 * (node % width);
}

/// Nodes of one side of the path if the contact is mirror-symmetric, else all nodes.
DensePressedSurface::Unknowns DensePressedSurface::unknowns_of(const std::vector<Index>& contact) const {
  const bool is_mirrored = is_symmetric_ && std::ranges::all_of(contact, [&](Index node) {
                             return std::ranges::binary_search(contact, image_of(node));
                           });
  Unknowns unknowns;
  std::ranges::copy_if(contact, std::back_inserter(unknowns.nodes),
                       [&](Index node) { return !is_mirrored || node <= image_of(node); });
  unknowns.counts = VectorXd::Ones(static_cast<Index>(unknowns.nodes.size()));
  for (Index i = 0; is_mirrored && i < unknowns.counts.size(); ++i) {
    const Index node = unknowns.nodes[static_cast<std::size_t>(i)];
    if (node != image_of(node)) unknowns.counts[i] = 2.0;
  }
  return unknowns;
}

/// Compliance between the unknowns, including the mirror images that they represent.
MatrixXd DensePressedSurface::compliance(const Unknowns& unknowns) const {
  MatrixXd matrix = *problem_.surface->normal_compliance(unknowns.nodes, unknowns.nodes);
  std::vector<Index> images;
  std::vector<Index> doubled;
  for (Index i = 0; i < unknowns.counts.size(); ++i) {
    if (unknowns.counts[i] == 1.0) continue;
    doubled.push_back(i);
    images.push_back(image_of(unknowns.nodes[static_cast<std::size_t>(i)]));
  }
  if (images.empty()) return matrix;
  const MatrixXd by_images = *problem_.surface->normal_compliance(unknowns.nodes, images);
  for (std::size_t i = 0; i < doubled.size(); ++i) matrix.col(doubled[i]) += by_images.col(static_cast<Index>(i));
  return matrix;
}

void DensePressedSurface::update_factors(const std::vector<Index>& nodes, const MatrixXd& matrix) {
  std::vector<Index> common;
  std::ranges::set_intersection(nodes, factored_, std::back_inserter(common));
  const std::size_t changed = nodes.size() + factored_.size() - 2 * common.size();
  if (factored_.empty() || kNodesPerAllowedChange * changed > nodes.size()) {
    factors_.compute(matrix);
    factored_ = nodes;
  }
  places_.clear();
  for (const Index node : nodes) {
    const auto place = std::ranges::lower_bound(factored_, node);
    const bool found = place != factored_.end() && *place == node;
    places_.push_back(found ? place - factored_.begin() : -1);
  }
}

/// Approximate forces for given displacements, from the last factored matrix, whose nodes may differ slightly. At a
/// node that the matrix does not contain, the force is the displacement times the stiffness of the surface.
/// @param[in] scaled_displacements displacements times this stiffness
VectorXd DensePressedSurface::approximate_forces(const VectorXd& scaled_displacements) const {
  VectorXd known = VectorXd::Zero(static_cast<Index>(factored_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i] >= 0) known[places_[i]] = scaled_displacements[static_cast<Index>(i)];
  }
  const VectorXd solved = factors_.solve(known);
  VectorXd forces(scaled_displacements.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto node = static_cast<Index>(i);
    forces[node] = places_[i] >= 0 ? solved[places_[i]] : scaled_displacements[node];
  }
  return forces;
}

void DensePressedSurface::press(PressedNodes& contact, double tolerance) {
  const Unknowns unknowns = unknowns_of(contact.nodes);
  const double stiffness = this->stiffness();
  MatrixXd matrix = compliance(unknowns);
  matrix *= stiffness;
  update_factors(unknowns.nodes, matrix);
  const Index count = matrix.rows();
  const VectorXd& counts = unknowns.counts;
  const VectorXd lowering =
      approximate_forces(VectorXd::Ones(count));  // forces that lower all nodes by the same amount
  const NormalCondition condition = problem_.normal_condition(stiffness);
  const double condition_per_lowering = condition.per_force * counts.dot(lowering) + condition.per_penetration;
  // A vector contains the forces and then the penetration times the stiffness. The result of the preconditioner
  // satisfies the last equation, the normal condition, exactly.
  const auto times = [&](const VectorXd& vector) {
    VectorXd result(count + 1);
    result.head(count).noalias() = matrix * vector.head(count);
    result.head(count).array() -= vector[count];
    result[count] = condition.per_force * counts.dot(vector.head(count)) + condition.per_penetration * vector[count];
    return result;
  };
  const auto precondition = [&](const VectorXd& right) {
    VectorXd result(count + 1);
    result.head(count) = approximate_forces(right.head(count));
    result[count] = (right[count] - condition.per_force * counts.dot(result.head(count))) / condition_per_lowering;
    result.head(count) += result[count] * lowering;
    return result;
  };
  VectorXd right(count + 1);
  right.head(count) = -stiffness * problem_.initial_gap(unknowns.nodes).matrix();
  right[count] = condition.value;
  VectorXd guess(count + 1);
  guess.head(count) = contact.pressing(unknowns.nodes).matrix();
  guess[count] = stiffness * problem_.penetration.value_or(contact.penetration.value_or(0.0));
  // The preconditioner is linear to six digits only, because its factors are in single precision. This does not limit
  // the accuracy, because GMRES keeps the preconditioned directions and their products with the matrix.
  const KrylovSolution solution = solve_krylov(times, precondition, right, guess,
                                               {.absolute = kFullAccuracy * right.norm(), .small_system = count + 1});
  products_ += solution.products;
  const double error = solution.residual / right.norm();
  if (!(error < std::max(kUnusableResidual, 2.0 * tolerance))) {
    throw ConvergenceError(
        "the iterative solver of the contact equations did not converge: the relative residual is " + rounded(error),
        contact.passes, error);
  }
  contact.penetration = problem_.penetration.value_or(solution.unknowns[count] / stiffness);
  contact.pressing.setZero();
  for (Index i = 0; i < count; ++i) {
    const Index node = unknowns.nodes[static_cast<std::size_t>(i)];
    contact.pressing[node] = solution.unknowns[i];
    if (counts[i] > 1.0) contact.pressing[image_of(node)] = solution.unknowns[i];
  }
}

ArrayXd DensePressedSurface::height(const PressedNodes& contact) {
  ++products_;
  return problem_.initial_gap + problem_.surface->normal_displacement(contact.pressing);
}

}  // namespace viscoroll::detail

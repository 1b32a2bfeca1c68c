// Direct solver for stick and slip at an instant.
//
// In the sticking state, all covered nodes touch the counterbody and stick to it; the stiffness of the contact gives
// the forces of this state. The unknowns are the free displacements, relative to the sticking state: the tangential
// displacements of slipping nodes, and all displacements of separated nodes.
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "base/dense_solvers.hpp"
#include "contact/krylov.hpp"
#include "transient/stick_slip.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kExactness = 1e-13;  // relative residual of linear systems

constexpr Index kColumns = 100;  // of the largest systems between two checkpoints; some milliseconds

/// @brief Condition for a free displacement of a node: force_coefficients . (forces on the node) +
/// displacement_coefficients . (free displacements of the node) = 0.
struct Condition {
  Index place;  ///< position of the node among the covered nodes
  Axis axis;    ///< free direction
  Eigen::Vector3d force_coefficients;
  Eigen::Vector3d displacement_coefficients;
};

/// @brief Solution of the equations at the covered nodes [3 * nodes + axis].
struct StickSlipForces {
  VectorXd forces;
  VectorXd free_displacements;  ///< relative to the sticking state
  double penetration;
  double center_displacement;
};

/// @brief Equations at an instant, for any sets of sticking, slipping and separated nodes.
class StickSlipEquations {
 public:
  /// @param[in] problem must outlive this object
  /// @param[in] tangential_compliance displacement of a node along the plane under a unit force on it; scales
  /// conditions relative to forces
  /// @param[in,out] stiffness stiffness of an earlier contact; `cover` adds nodes to it
  StickSlipEquations(const StickSlipProblem& problem, double tangential_compliance, ContactStiffness& stiffness);

  /// @brief Include the nodes of a contact, and nodes that were recently in contact.
  void cover(const std::vector<Index>& contact);

  [[nodiscard]] const std::vector<Index>& covered() const { return stiffness_.nodes(); }
  /// @brief Add given values to the known gaps and slips of some nodes: the differences between the displacements of
  /// the surface and those that follow from the stiffness.
  void correct(const std::vector<Index>& nodes, const Eigen::ArrayXd& gap, const Eigen::ArrayX2d& slip);

  /// @brief Set the condition on the center.
  void set_center_condition(CenterRow row);

  /// @param[in] conditions one for each free displacement; a node without conditions touches the plane and sticks
  /// @return solution; not finite if the equations are singular
  [[nodiscard]] StickSlipForces solve(const std::vector<Condition>& conditions);

 private:
  void set_center_row();
  void set_sticking_state();
  [[nodiscard]] MatrixXd forces_by(MatrixXd displacements) const;
  [[nodiscard]] VectorXd solve_system(const std::vector<Condition>& conditions, const MatrixXd& matrix,
                                      const VectorXd& right);

  const StickSlipProblem& problem_;
  ContactStiffness& stiffness_;
  double tangential_compliance_;
  CenterRow center_;
  Eigen::ArrayXd gap_;                     // gap of the problem, corrected
  Eigen::ArrayX2d known_slip_;             // slip of the problem, corrected
  std::vector<Eigen::Matrix3d> to_frame_;  // rotations from x, down and z to the frame of the surface at covered nodes
  Eigen::MatrixX3d sticking_displacements_;       // close all gaps and undo all slips; columns: known values, unit
                                                  // penetration, unit displacement of the center
  Eigen::MatrixX3d sticking_forces_;              // forces for the sticking displacements
  VectorXd center_row_;                           // coefficients of displacements in the row of the center
  std::vector<std::pair<Index, Axis>> factored_;  // positions and axes of the free displacements in factors_
  DenseFactors factors_;
};

StickSlipEquations::StickSlipEquations(const StickSlipProblem& problem, double tangential_compliance,
                                       ContactStiffness& stiffness)
    : problem_(problem),
      stiffness_(stiffness),
      tangential_compliance_(tangential_compliance),
      gap_(problem.gap),
      known_slip_(problem.known_slip) {}

/// Compute quantities that depend on the nodes only: the forces if all of them touched and stuck, as functions of the
/// penetration and the displacement of the center.
void StickSlipEquations::cover(const std::vector<Index>& contact) {
  const bool is_new = stiffness_.cover(problem_.surface, contact);
  if (!is_new && !to_frame_.empty()) return;
  to_frame_.clear();
  factored_.clear();
  for (const Index node : covered()) to_frame_.push_back(problem_.surface.to_frame(node));
  set_sticking_state();
  set_center_row();
}

void StickSlipEquations::correct(const std::vector<Index>& nodes, const Eigen::ArrayXd& gap,
                                 const Eigen::ArrayX2d& slip) {
  for (const Index node : nodes) {
    gap_[node] += gap[node];
    known_slip_.row(node) += slip.row(node);
  }
  if (to_frame_.empty()) return;
  Index place = 0;
  for (const Index node : covered()) {
    sticking_displacements_.col(0).segment<3>(3 * place++) << -known_slip_(node, 0), gap_[node], -known_slip_(node, 1);
  }
  sticking_forces_.col(0) = forces_by(sticking_displacements_.col(0));
}

void StickSlipEquations::set_sticking_state() {
  sticking_displacements_ = Eigen::MatrixX3d::Zero(3 * static_cast<Index>(covered().size()), 3);
  Index place = 0;
  for (const Index node : covered()) {
    const auto& slip_per_center_displacement = problem_.slip_per_center_displacement;
    Eigen::Matrix3d displacements;
    displacements << -known_slip_(node, 0), 0.0, -slip_per_center_displacement(node, 0),  //
        gap_[node], -problem_.weights[node], 0.0,                                         //
        -known_slip_(node, 1), 0.0, -slip_per_center_displacement(node, 1);
    sticking_displacements_.middleRows<3>(3 * place++) = displacements;
  }
  sticking_forces_ = forces_by(sticking_displacements_);
}

void StickSlipEquations::set_center_condition(CenterRow row) {
  center_ = std::move(row);
  if (!to_frame_.empty()) set_center_row();
}

void StickSlipEquations::set_center_row() {
  VectorXd row(sticking_displacements_.rows());
  Index place = 0;
  for (const Index node : covered()) row.segment<3>(3 * place++) = center_.force_coefficients.row(node).transpose();
  center_row_ = forces_by(row);
}

/// Forces along x, down and z for displacements along them [3 * nodes + axis].
MatrixXd StickSlipEquations::forces_by(MatrixXd displacements) const {
  const auto count = static_cast<Index>(to_frame_.size());
  const auto of_node = [](MatrixXd& field, Index i) { return field.middleRows<3>(3 * i); };
  for (Index i = 0; i < count; ++i) {
    of_node(displacements, i) = (to_frame_[static_cast<std::size_t>(i)] * of_node(displacements, i)).eval();
  }
  MatrixXd forces = stiffness_.matrix() * displacements;
  for (Index i = 0; i < count; ++i) {
    of_node(forces, i) = (to_frame_[static_cast<std::size_t>(i)].transpose() * of_node(forces, i)).eval();
  }
  return forces;
}

StickSlipForces StickSlipEquations::solve(const std::vector<Condition>& conditions) {
  const auto free = static_cast<Index>(conditions.size());
  const Index depth = free;
  const Index center = free + 1;
  MatrixXd matrix(free + 2, free + 2);
  VectorXd right(free + 2);
  // In the frame of the stiffness.
  Eigen::Matrix3Xd force_coefficients(3, free);
  for (Index i = 0; i < free; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    force_coefficients.col(i) = to_frame_[static_cast<std::size_t>(condition.place)] * condition.force_coefficients;
  }
  VectorXd by_move(sticking_displacements_.rows());
  for (Index column = 0; column < free; ++column) {
    if (column % kColumns == 0) problem_.surface.checkpoint();
    const Condition& moved = conditions[static_cast<std::size_t>(column)];
    const auto direction = to_frame_[static_cast<std::size_t>(moved.place)].col(moved.axis);
    by_move.setZero();
    for (Index p = 0; p < 3; ++p) {
      if (direction[p] != 0.0) by_move += direction[p] * stiffness_.matrix().col(3 * moved.place + p);
    }
    for (Index row = 0; row < free; ++row) {
      const Condition& condition = conditions[static_cast<std::size_t>(row)];
      matrix(row, column) = force_coefficients.col(row).dot(by_move.segment<3>(3 * condition.place));
      if (condition.place == moved.place) matrix(row, column) += condition.displacement_coefficients[moved.axis];
    }
  }
  for (Index row = 0; row < free; ++row) {
    const Condition& condition = conditions[static_cast<std::size_t>(row)];
    const Eigen::RowVector3d given =
        condition.force_coefficients.transpose() * sticking_forces_.middleRows<3>(3 * condition.place);
    right[row] = -given[0];
    matrix.row(row).tail<2>() = given.tail<2>();
    matrix(depth, row) = sticking_forces_(3 * condition.place + condition.axis, 1);
    matrix(center, row) = center_row_[3 * condition.place + condition.axis];
  }
  // Rows of load and center: sums of forces, with the weights that `sticking_displacements_` and the row of the center
  // give displacements.
  const Eigen::RowVector3d pressing = sticking_displacements_.col(1).transpose() * sticking_forces_;
  matrix.row(depth).tail<2>() = pressing.tail<2>();
  right[depth] = -pressing[0];
  const ApproachCondition& approach = problem_.approach;
  matrix.row(depth) *= approach.force;
  matrix(depth, depth) += approach.penetration;
  right[depth] = approach.force * right[depth] + approach.value;
  // Scale forces and displacements equally: a heavy axle must be the pivot of the penetration only.
  const double depth_share =
      tangential_compliance_ / std::max(approach.force, approach.penetration * tangential_compliance_);
  matrix.row(depth) *= depth_share;
  right[depth] *= depth_share;
  const Eigen::RowVector3d of_center = center_row_.transpose() * sticking_displacements_;
  matrix.row(center).tail<2>() = of_center.tail<2>();
  matrix(center, center) += center_.displacement;
  right[center] = center_.value - of_center[0];
  // The same for a heavy center and its displacement.
  const double largest = center_.force_coefficients.abs().maxCoeff();
  const double share =
      tangential_compliance_ / std::max(largest, std::abs(center_.displacement) * tangential_compliance_);
  matrix.row(center) *= share;
  right[center] *= share;

  const VectorXd unknowns = solve_system(conditions, matrix, right);
  StickSlipForces result{.forces = {},
                         .free_displacements = VectorXd::Zero(sticking_displacements_.rows()),
                         .penetration = unknowns[depth],
                         .center_displacement = unknowns[center]};
  for (Index i = 0; i < free; ++i) {
    const Condition& condition = conditions[static_cast<std::size_t>(i)];
    result.free_displacements[3 * condition.place + condition.axis] = unknowns[i];
  }
  result.forces =
      forces_by(sticking_displacements_ * Eigen::Vector3d(1.0, result.penetration, result.center_displacement) +
                result.free_displacements);
  return result;
}

/// Solve a system. If the same displacements are free as before, only tractions turn, and the last factors precondition
/// a Krylov method.
VectorXd StickSlipEquations::solve_system(const std::vector<Condition>& conditions, const MatrixXd& matrix,
                                          const VectorXd& right) {
  std::vector<std::pair<Index, Axis>> free;
  free.reserve(conditions.size());
  for (const Condition& condition : conditions) free.emplace_back(condition.place, condition.axis);
  if (!free.empty() && free == factored_) {
    const double small = kExactness * right.norm();
    const KrylovSolution solution =
        solve_krylov([&](const VectorXd& vector) -> VectorXd { return matrix * vector; },
                     [&](const VectorXd& vector) -> VectorXd { return factors_.solve(vector); }, right,
                     factors_.solve(right), {.absolute = small});
    if (solution.residual <= small) return solution.unknowns;
  }
  factored_ = std::move(free);
  factors_.compute(matrix);
  return factors_.solve(right);
}

Eigen::ArrayX2d along_plane(const VectorField& displacement) {
  return displacement(Eigen::all, std::array{kForward, kSideways});
}

/// With several bodies, the stiffness is that of the level window, and the difference to it is an excess.
bool has_excess(const StickSlipProblem& problem) { return problem.surface.parts().size() > 1; }

std::vector<HalfField> displaced_by(const StickSlipProblem& problem, const VectorField& guess) {
  if (!problem.center_row_needs_displacements && !has_excess(problem)) return {};
  return problem.surface.displaced(guess);
}

/// Solver of `direct_stick_slip`.
class DirectStickSlip final : public TransientStickSlipSystem {
 public:
  /// @param[in] problem must outlive this object
  /// @param[in] guess forces to start from
  /// @param[in,out] stiffness of an earlier contact
  DirectStickSlip(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness);

  /// The equations hold to round-off, except that the condition of the center may have changed since.
  [[nodiscard]] double imbalance(const ContactSolution&) const override { return imbalance_; }
  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override;
  void find_displacements(ContactSolution& state) override;

 private:
  DirectStickSlip(const StickSlipProblem& problem, const VectorField& guess, const std::vector<HalfField>& displaced,
                  ContactStiffness& stiffness);
  [[nodiscard]] std::vector<Condition> conditions(double friction, const ContactSets& sets) const;

  StickSlipEquations equations_;
  double imbalance_ = 0.0;
};

DirectStickSlip::DirectStickSlip(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness)
    : DirectStickSlip(problem, guess, displaced_by(problem, guess), stiffness) {}

DirectStickSlip::DirectStickSlip(const StickSlipProblem& problem, const VectorField& guess,
                                 const std::vector<HalfField>& displaced, ContactStiffness& stiffness)
    : TransientStickSlipSystem(problem, displaced), equations_(problem, 1.0 / scales().tangential, stiffness) {
  equations_.set_center_condition(center());
  if (!has_excess(problem)) return;
  const VectorField excess = problem.surface.excess(guess, displaced);
  std::vector<Index> all(static_cast<std::size_t>(problem.gap.size()));
  std::iota(all.begin(), all.end(), 0);
  equations_.correct(all, -excess.col(kDown), along_plane(excess));
}

void DirectStickSlip::solve(double friction, const ContactSets& sets, double, ContactSolution& state) {
  problem().surface.checkpoint();
  equations_.cover(sets.contact);
  const auto [forces, free_displacements, penetration, center_displacement] =
      equations_.solve(conditions(friction, sets));
  state.penetration = penetration;
  state.creepage = center_displacement;
  imbalance_ = 0.0;
  state.force.setZero();
  state.gap.setZero();
  state.slip.setZero();
  state.displacement.resize(0, 3);
  for (std::size_t i = 0; i < equations_.covered().size(); ++i) {
    const Index node = equations_.covered()[i];
    const auto move = free_displacements.segment<3>(static_cast<Index>(3 * i)).array();
    state.gap[node] = -move[kDown];
    state.slip.row(node) << move[kForward], move[kSideways];
    if (std::ranges::binary_search(sets.contact, node)) {
      state.force.row(node) = forces.segment<3>(static_cast<Index>(3 * i)).transpose();
      if (in_middle(node)) state.force(node, kSideways) = 0.0;
    }
  }
}

void DirectStickSlip::find_displacements(ContactSolution& state) {
  const Eigen::ArrayXd gap = std::move(state.gap);
  const Eigen::ArrayX2d slip = std::move(state.slip);
  TransientStickSlipSystem::find_displacements(state);
  equations_.correct(equations_.covered(), state.gap - gap, state.slip - slip);
  if (!problem().center_row_needs_displacements) return;
  equations_.set_center_condition(center());
  imbalance_ = center_excess(state);
}

/// Conditions of the sets. A separated node has zero force. At a slipping node, the traction is limited by friction,
/// and across the slip direction it turns with the slip. Nodes on the middle line do not move sideways.
std::vector<Condition> DirectStickSlip::conditions(double friction, const ContactSets& sets) const {
  std::vector<Condition> conditions;
  for (std::size_t i = 0; i < equations_.covered().size(); ++i) {
    const Index node = equations_.covered()[i];
    const auto add = [&](Axis axis, const Eigen::Vector3d& force_coefficients,
                         const Eigen::Vector3d& displacement_coefficients) {
      conditions.push_back(
          {static_cast<Index>(i), axis, force_coefficients / scales().tangential, displacement_coefficients});
    };
    const auto found = std::ranges::lower_bound(sets.contact, node);
    if (found == sets.contact.end() || *found != node) {
      for (const Axis axis : {kForward, kDown, kSideways}) {
        if (axis == kSideways && in_middle(node)) continue;
        add(axis, Eigen::Vector3d::Unit(axis), Eigen::Vector3d::Zero());
      }
      continue;
    }
    const auto& [stick, e, rigidity] = sets.states[static_cast<std::size_t>(found - sets.contact.begin())];
    if (stick) continue;
    const Eigen::Vector3d across(-e[1], 0.0, e[0]);
    add(kForward, {e[0], friction, e[1]}, Eigen::Vector3d::Zero());
    if (!in_middle(node)) add(kSideways, (1.0 - rigidity) * across, rigidity * across);
  }
  return conditions;
}

}  // namespace

std::unique_ptr<StickSlipSystem> direct_stick_slip(const StickSlipProblem& problem, const VectorField& guess,
                                                   ContactStiffness& stiffness) {
  return std::make_unique<DirectStickSlip>(problem, guess, stiffness);
}

}  // namespace viscoroll::detail

#include "contact/newton_step.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/krylov.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

/// Limits of the mean rigidity, which represents all slipping nodes in one symbol.
constexpr double kMinRigidity = 0.02;
constexpr double kMaxRigidity = 0.9;

/// Sticking nodes, and the runs along phi that contain them.
struct StickRuns {
  /// @param[in] problem contact problem
  /// @param[in] sets nodes in contact and their states
  /// @param[in] rigid slip per row at zero creepage [m]
  /// @param[in] per_creepage slip per row and creepage [m]
  StickRuns(const ContactProblem& problem, const ContactSets& sets, const Eigen::ArrayX2d& rigid,
            const Eigen::ArrayX2d& per_creepage) {
    const WindowShape shape = problem.surface->shape();
    const Index stride = shape.theta_nodes;
    std::vector<Index> place(static_cast<std::size_t>(shape.size()), -1);
    for (std::size_t i = 0; i < sets.contact.size(); ++i) {
      if (!sets.states[i].stick) continue;
      const Index node = sets.contact[i];  // ascending, so the upstream neighbor has been visited
      const Index before = place[static_cast<std::size_t>(node - stride)];
      place[static_cast<std::size_t>(node)] = static_cast<Index>(nodes.size());
      nodes.push_back(node);
      heads.push_back(before < 0 ? node - stride : heads[static_cast<std::size_t>(before)]);
      rigid_slips.push_back(since_head(rigid, node, before, rigid_slips));
      slips_per_creepage.push_back(since_head(per_creepage, node, before, slips_per_creepage));
    }
  }

  [[nodiscard]] Index count() const { return static_cast<Index>(nodes.size()); }
  [[nodiscard]] ArrayXd rigid_slip(Index column) const { return column_of(rigid_slips, column); }
  [[nodiscard]] ArrayXd slip_per_creepage(Index column) const { return column_of(slips_per_creepage, column); }

  std::vector<Index> nodes;
  std::vector<Index> heads;                 // node upstream of the first node of the run
  std::vector<Eigen::Array2d> rigid_slips;  // from the head to the node
  std::vector<Eigen::Array2d> slips_per_creepage;

 private:
  /// Slip of a node relative to the head of its run.
  /// @param[in] from_upstream slip per row [m]
  /// @param[in] node number of the node
  /// @param[in] before index of its upstream neighbor in `slips`; < 0 if that is the head
  /// @param[in] slips slip of the previous nodes of the run, relative to the head [m]
  static Eigen::Array2d since_head(const Eigen::ArrayX2d& from_upstream, Index node, Index before,
                                   const std::vector<Eigen::Array2d>& slips) {
    const Eigen::Array2d slip = from_upstream.row(node).transpose();
    return before < 0 ? slip : Eigen::Array2d(slip + slips[static_cast<std::size_t>(before)]);
  }

  [[nodiscard]] ArrayXd column_of(const std::vector<Eigen::Array2d>& slips, Index column) const {
    return ArrayXd::NullaryExpr(count(), [&](Index i) { return slips[static_cast<std::size_t>(i)][column]; });
  }
};

/// Slipping nodes and their directions of slip.
struct SlippingNodes {
  SlippingNodes(const ContactProblem& problem, const ContactSets& sets) {
    std::vector<TangentialState> states;
    for (std::size_t i = 0; i < sets.contact.size(); ++i) {
      if (sets.states[i].stick) continue;
      nodes.push_back(sets.contact[i]);
      upstream.push_back(sets.contact[i] - problem.surface->shape().theta_nodes);
      places.push_back(static_cast<Index>(i));
      states.push_back(sets.states[i]);
    }
    direction.resize(count(), 2);
    rigidity.resize(count());
    for (Index i = 0; i < count(); ++i) {
      direction.row(i) = states[static_cast<std::size_t>(i)].direction.transpose();
      rigidity[i] = states[static_cast<std::size_t>(i)].rigidity;
    }
  }

  [[nodiscard]] Index count() const { return static_cast<Index>(nodes.size()); }

  std::vector<Index> nodes;
  std::vector<Index> upstream;
  std::vector<Index> places;  // index among the nodes in contact
  Eigen::ArrayX2d direction;
  ArrayXd rigidity;
};

/// Equations of a step. Unknowns and conditions have the order p, t_x, t_z, s, penetration times scales.normal,
/// creepage times step * scales.tangential; all of them are forces.
class Equations {
 public:
  Equations(const ContactProblem& problem, double coefficient, const ConditionScales& scales, const ContactSets& sets,
            const StickSlipPreconditioner& preconditioner, const ContactSolution& state)
      : problem_(problem),
        friction_(*problem.friction),
        coefficient_(std::isfinite(coefficient) ? coefficient : 0.0),
        scales_(scales),
        state_(state),
        contact_(sets.contact),
        per_creepage_(slip_per_creepage()),
        rigid_slip_(linearized_rigid_slip()),
        stick_(problem, sets, rigid_slip_, per_creepage_),
        slip_(problem, sets),
        preconditioner_(preconditioner),
        contacts_(static_cast<Index>(contact_.size())),
        forces_(contacts_ + 2 * stick_.count() + slip_.count()),
        condition_(problem.normal_condition(scales.normal)),
        drive_(friction_.drive->row({*problem.surface, friction_.arms, state.force, own_displacement(state)},
                                    scales.tangential * friction_.step)) {
    if (slip_.count() > 0) {
      const double rigidity = std::clamp(slip_.rigidity.mean(), kMinRigidity, kMaxRigidity);
      turning_symbol_ = preconditioner.turning_symbol(rigidity, scales.tangential);
    }
    prepare_border();
  }

  [[nodiscard]] VectorXd right_side() const {
    VectorXd right(forces_ + 2);
    right.head(contacts_) = -scales_.normal * problem_.initial_gap(contact_).matrix();
    forward(right) = -scales_.normal * stick_.rigid_slip(0).matrix();
    sideways(right) = -scales_.normal * stick_.rigid_slip(1).matrix();
    across(right) = (-scales_.tangential * slip_.rigidity * across_direction(rigid_slip_)).matrix();
    right[forces_] = condition_.value;
    right[forces_ + 1] = drive_.value;
    return right;
  }

  [[nodiscard]] VectorXd unknowns() const {
    VectorXd unknowns(forces_ + 2);
    unknowns.head(contacts_) = -state_.force.col(kDown)(contact_).matrix();
    forward(unknowns) = state_.force.col(kForward)(stick_.nodes).matrix();
    sideways(unknowns) = state_.force.col(kSideways)(stick_.nodes).matrix();
    across(unknowns) = (slip_.direction.col(0) * state_.force.col(kSideways)(slip_.nodes) -
                        slip_.direction.col(1) * state_.force.col(kForward)(slip_.nodes))
                           .matrix();
    unknowns[forces_] = state_.penetration * scales_.normal;
    unknowns[forces_ + 1] = *state_.creepage * creepage_force();
    return unknowns;
  }

  [[nodiscard]] VectorField force(const VectorXd& unknowns) const {
    VectorField force = VectorField::Zero(state_.force.rows(), 3);
    force.col(kDown)(contact_) = -unknowns.head(contacts_).array();
    force.col(kForward)(stick_.nodes) = forward(unknowns).array();
    force.col(kSideways)(stick_.nodes) = sideways(unknowns).array();
    const ArrayXd limit = coefficient_ * unknowns(slip_.places).array();
    const ArrayXd turned = across(unknowns).array();
    force.col(kForward)(slip_.nodes) = limit * slip_.direction.col(0) - turned * slip_.direction.col(1);
    force.col(kSideways)(slip_.nodes) = limit * slip_.direction.col(1) + turned * slip_.direction.col(0);
    return force;
  }

  [[nodiscard]] VectorXd times(const VectorXd& unknowns) const {
    const VectorField force = this->force(unknowns);
    const Displacements of_each = problem_.surface->displacements(force);
    const VectorField moved = of_each.relative();
    const VectorField moved_for_slip = slip_displacement(of_each, moved);
    const double creepage = unknowns[forces_ + 1] / creepage_force();
    VectorXd result(forces_ + 2);
    result.head(contacts_) = (-scales_.normal * moved.col(kDown)(contact_) - unknowns[forces_]).matrix();
    const auto since_head = [&](Axis axis) {
      return moved_for_slip.col(axis)(stick_.nodes) - moved_for_slip.col(axis)(stick_.heads);
    };
    forward(result) = (scales_.normal * (since_head(kForward) + creepage * stick_.slip_per_creepage(0))).matrix();
    sideways(result) = (scales_.normal * (since_head(kSideways) + creepage * stick_.slip_per_creepage(1))).matrix();
    const auto slipped = [&](Axis axis) {
      return moved_for_slip.col(axis)(slip_.nodes) - moved_for_slip.col(axis)(slip_.upstream);
    };
    const auto& e = slip_.direction;
    const ArrayXd turned =
        e.col(0) * slipped(kSideways) - e.col(1) * slipped(kForward) + creepage * across_direction(per_creepage_);
    across(result) =
        ((1.0 - slip_.rigidity) * across(unknowns).array() + slip_.rigidity * scales_.tangential * turned).matrix();
    result[forces_] =
        condition_.per_force * unknowns.head(contacts_).sum() + condition_.per_penetration * unknowns[forces_];
    result[forces_ + 1] = drive_.of(force, moved, creepage);
    return result;
  }

  /// Solve for the forces with inverse symbols, then exactly for penetration and creepage.
  [[nodiscard]] VectorXd precondition(const VectorXd& right) const {
    VectorXd result(forces_ + 2);
    result.head(forces_) = precondition_forces(right.head(forces_));
    const Eigen::Vector2d border = border_inverse_ * (right.tail<2>() - border_conditions(result.head(forces_)));
    result.head(forces_) -= border_response_ * border;
    result.tail<2>() = border;
    return result;
  }

 private:
  using Segment = VectorXd::SegmentReturnType;
  using ConstSegment = VectorXd::ConstSegmentReturnType;

  Segment forward(VectorXd& v) const { return v.segment(contacts_, stick_.count()); }
  [[nodiscard]] ConstSegment forward(const VectorXd& v) const { return v.segment(contacts_, stick_.count()); }
  Segment sideways(VectorXd& v) const { return v.segment(contacts_ + stick_.count(), stick_.count()); }
  [[nodiscard]] ConstSegment sideways(const VectorXd& v) const {
    return v.segment(contacts_ + stick_.count(), stick_.count());
  }
  Segment across(VectorXd& v) const { return v.segment(contacts_ + 2 * stick_.count(), slip_.count()); }
  [[nodiscard]] ConstSegment across(const VectorXd& v) const {
    return v.segment(contacts_ + 2 * stick_.count(), slip_.count());
  }

  /// Displacement of the counterbody's material per creepage, at the current state.
  [[nodiscard]] Eigen::ArrayX2d slip_per_creepage() const {
    return friction_.counterbody_rigid_displacement + counterbody_increments();
  }

  /// The product of creepage and increments is linearized: the sum of the changes due to each, minus the current
  /// product.
  [[nodiscard]] Eigen::ArrayX2d linearized_rigid_slip() const {
    return friction_.rigid_slip - *state_.creepage * counterbody_increments();
  }

  [[nodiscard]] Eigen::ArrayX2d counterbody_increments() const {
    if (state_.counterbody_displacement.rows() == 0) return Eigen::ArrayX2d::Zero(state_.force.rows(), 2);
    return increments(state_.counterbody_displacement, problem_.surface->shape().theta_nodes);
  }

  /// Displacements that enter the slip. The part of the counterbody counts 1 + creepage times, because its material
  /// passes that much faster.
  [[nodiscard]] VectorField slip_displacement(const Displacements& of_each, const VectorField& relative) const {
    if (of_each.counterbody.rows() == 0) return relative;
    return relative + *state_.creepage * of_each.counterbody;
  }

  /// Components across the directions of the slipping nodes.
  [[nodiscard]] ArrayXd across_direction(const Eigen::ArrayX2d& slips) const {
    const Eigen::ArrayX2d slip = slips(slip_.nodes, Eigen::all);
    return slip_.direction.col(0) * slip.col(1) - slip_.direction.col(1) * slip.col(0);
  }

  /// Force that represents a creepage of 1 [N].
  [[nodiscard]] double creepage_force() const { return scales_.tangential * friction_.step; }

  [[nodiscard]] Eigen::Vector2d border_conditions(const VectorXd& forces) const {
    VectorXd unknowns = VectorXd::Zero(forces_ + 2);
    unknowns.head(forces_) = forces;
    return {condition_.per_force * forces.head(contacts_).sum(), (drive_.force_coefficients * force(unknowns)).sum()};
  }

  /// Compute the response of the forces to penetration and creepage, and the remaining 2 x 2 system for these two.
  void prepare_border() {
    VectorXd penetration = VectorXd::Zero(forces_ + 2);
    penetration.head(contacts_).setConstant(-1.0);
    VectorXd creepage = VectorXd::Zero(forces_ + 2);
    forward(creepage) = (scales_.normal / creepage_force() * stick_.slip_per_creepage(0)).matrix();
    sideways(creepage) = (scales_.normal / creepage_force() * stick_.slip_per_creepage(1)).matrix();
    across(creepage) =
        (scales_.tangential / creepage_force() * slip_.rigidity * across_direction(per_creepage_)).matrix();
    border_response_.resize(forces_, 2);
    border_response_.col(0) = precondition_forces(penetration.head(forces_));
    border_response_.col(1) = precondition_forces(creepage.head(forces_));
    Eigen::Matrix2d border;
    border.col(0) = -border_conditions(border_response_.col(0));
    border.col(1) = -border_conditions(border_response_.col(1));
    border(0, 0) += condition_.per_penetration;
    border(1, 1) += drive_.creepage_coefficient / creepage_force();
    border_inverse_ = border.inverse();
  }

  [[nodiscard]] VectorXd precondition_forces(const VectorXd& right) const {
    VectorField displacement = VectorField::Zero(state_.force.rows(), 3);
    displacement.col(kDown)(contact_) = -right.head(contacts_).array() / scales_.normal;
    displacement.col(kForward)(stick_.nodes) = forward(right).array() / scales_.normal;
    displacement.col(kSideways)(stick_.nodes) = sideways(right).array() / scales_.normal;
    const VectorField force = preconditioner_.force(displacement);
    VectorXd result(forces_);
    result.head(contacts_) = -force.col(kDown)(contact_).matrix();
    forward(result) = force.col(kForward)(stick_.nodes).matrix();
    sideways(result) = force.col(kSideways)(stick_.nodes).matrix();
    if (slip_.count() > 0) {
      ArrayXd field = ArrayXd::Zero(state_.force.rows());
      field(slip_.nodes) = across(right).array();
      across(result) = preconditioner_.apply(turning_symbol_, field)(slip_.nodes).matrix();
    }
    return result;
  }

  const ContactProblem& problem_;
  const Friction& friction_;
  double coefficient_;
  ConditionScales scales_;
  const ContactSolution& state_;
  const std::vector<Index>& contact_;
  Eigen::ArrayX2d per_creepage_;  // slip per row added by a creepage of 1 [m]
  Eigen::ArrayX2d rigid_slip_;
  StickRuns stick_;
  SlippingNodes slip_;
  const StickSlipPreconditioner& preconditioner_;
  Index contacts_;
  Index forces_;
  NormalCondition condition_;
  DriveRow drive_;
  ComplexBuffer turning_symbol_;
  Eigen::MatrixX2d border_response_;
  Eigen::Matrix2d border_inverse_;
};

/// Replace forces by the mean of themselves and their mirror images: Krylov methods leave round-off that grows.
void symmetrize(const WindowShape& shape, VectorField& force) {
  for (Index row = 0; row < shape.phi_nodes; ++row) {
    for (Index k = 0; 2 * k < shape.theta_nodes; ++k) {
      const Index node = row * shape.theta_nodes + k;
      const Index image = row * shape.theta_nodes + shape.theta_nodes - 1 - k;
      const Eigen::Array3d sign(1.0, 1.0, -1.0);
      const Eigen::Array3d mean = 0.5 * (force.row(node).transpose() + sign * force.row(image).transpose());
      force.row(node) = mean.transpose();
      force.row(image) = (sign * mean).transpose();
    }
  }
}

}  // namespace

int take_newton_step(const ContactProblem& problem, double coefficient, const ConditionScales& scales,
                     const ContactSets& sets, const StickSlipPreconditioner& preconditioner, double tolerance,
                     ContactSolution& state) {
  const Equations equations(problem, coefficient, scales, sets, preconditioner, state);
  const KrylovSolution solution = solve_krylov([&](const VectorXd& vector) { return equations.times(vector); },
                                               [&](const VectorXd& vector) { return equations.precondition(vector); },
                                               equations.right_side(), equations.unknowns(), {.relative = tolerance});
  VectorField force = equations.force(solution.unknowns);
  if (is_mirror_symmetric(problem)) symmetrize(problem.surface->shape(), force);
  state.force = std::move(force);
  state.penetration = solution.unknowns[solution.unknowns.size() - 2] / scales.normal;
  state.creepage = solution.unknowns[solution.unknowns.size() - 1] / (scales.tangential * problem.friction->step);
  return solution.products;
}

}  // namespace viscoroll::detail

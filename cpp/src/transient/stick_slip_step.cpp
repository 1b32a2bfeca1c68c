#include "transient/stick_slip_step.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/krylov.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum Along : std::size_t { kForward = 0, kDown = 1, kSideways = 2 };

constexpr int kStepsNearby = 25;  // from the forces of the guess, before all nodes of it stick
constexpr int kMostSteps = 100;
/// Steps in which nodes join while others leave.
constexpr int kExchanges = 12;
constexpr int kFewJoins = 3;          // of a node, after which it slips
constexpr int kMostJoins = 6;         // after which it stays out of this instant
constexpr double kExactness = 1e-13;  // of linear systems, as relative residuals
constexpr double kBalance = 1e-12;    // of tractions per load
constexpr double kTolerance = 1e-10;  // of forces per load, and of gaps per penetration
constexpr double kLikelySlip = 0.97;  // traction per its limit from which a node of the guess is taken to slip

/// What holds where a displacement is free: on_force . (forces on the node) + on_move . (its free displacements) = 0.
struct Condition {
  Index place;  // of the node
  Index axis;   // that is free
  Eigen::Vector3d on_force;
  Eigen::Vector3d on_move;
};

class StickSlipSolver {
 public:
  StickSlipSolver(const StickSlipProblem& problem, const PlaneForces& guess, ContactStiffness& stiffness)
      : problem_(problem),
        stiffness_(stiffness),
        forces_(guess),
        gap_(HalfField::Zero(guess.pressing.rows(), guess.pressing.cols())),
        forward_slip_(gap_),
        sideways_slip_(gap_),
        slips_(Eigen::ArrayXX<bool>::Constant(gap_.rows(), gap_.cols(), false)),
        joined_(Eigen::ArrayXXi::Zero(gap_.rows(), gap_.cols())) {
    // A node's own compliance in the middle row, by which slip is weighed against forces.
    const Index middle = gap_.cols() / 2 * gap_.rows();
    own_compliance_ = problem.tables.compliance({middle}, problem.axes[kForward])(0, 0);
  }

  [[nodiscard]] StickSlip solve() {
    const PlaneForces guess = forces_;
    start_from(guess);
    if (settles(kStepsNearby)) return result();
    start_from({.pressing = guess.pressing, .forward = 0.0 * guess.forward, .sideways = 0.0 * guess.sideways});
    if (settles(kMostSteps)) return result();
    throw ConvergenceError("stick and slip did not settle", kMostSteps, 1.0);
  }

 private:
  [[nodiscard]] Index size() const { return forces_.pressing.size(); }
  [[nodiscard]] double& pressing(Index node) { return forces_.pressing.data()[node]; }
  [[nodiscard]] Eigen::Vector2d traction(Index node) const {
    return {forces_.forward.data()[node], forces_.sideways.data()[node]};
  }
  [[nodiscard]] bool in_middle(Index node) const { return node % forces_.pressing.rows() == 0; }
  /// Where the traction would be if slip were resisted elastically: its direction is that of slip.
  [[nodiscard]] Eigen::Vector2d trial(Index node) const {
    return traction(node) - Eigen::Vector2d(forward_slip_.data()[node], sideways_slip_.data()[node]) / own_compliance_;
  }
  void start_from(const PlaneForces& guess) {
    forces_ = guess;
    nodes_.clear();
    for (HalfField* field : {&gap_, &forward_slip_, &sideways_slip_}) field->setZero();
    joined_.setZero();
    for (Index node = 0; node < size(); ++node) {
      slips_.data()[node] = traction(node).norm() > kLikelySlip * problem_.friction * pressing(node);
      if (pressing(node) > 0.0) nodes_.push_back(node);
    }
  }

  bool settles(int most_steps) {
    for (int step = 0; step < most_steps; ++step) {
      if (nodes_.empty()) throw ConvergenceError("no node carries load", step, 1.0);
      cover_nodes();
      newton_step();
      bool changed = drop_tensile();
      changed = ((step < kExchanges || !changed) && add_overclosed()) || changed;
      changed = switch_stick_and_slip() || changed;
      if (changed || imbalance() > kBalance * problem_.load) continue;
      find_gaps_and_slips();
      if (!add_overclosed()) return true;
    }
    return false;
  }

  [[nodiscard]] bool touches(Index node) const { return std::ranges::binary_search(nodes_, node); }

  /// What follows from the nodes alone: the forces if all of them touched and stuck, by the penetration and the way.
  void cover_nodes() {
    const bool is_new = stiffness_.cover(problem_.tables, nodes_);
    if (!is_new && !to_components_.empty()) return;
    to_components_.clear();
    factored_.clear();
    closed_ = Eigen::MatrixX3d::Zero(3 * static_cast<Index>(covered().size()), 3);
    Index place = 0;
    for (const Index node : covered()) {
      Eigen::Matrix3d axes;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t p = 0; p < 3; ++p) {
          axes(static_cast<Index>(axis), static_cast<Index>(p)) = problem_.axes[axis][p].data()[node];
        }
      }
      to_components_.emplace_back(axes.inverse());
      const double weight = problem_.weights.data()[node];
      Eigen::Matrix3d closed;
      closed << -problem_.forward_way.data()[node], 0.0, -weight, problem_.gap.data()[node], -weight, 0.0,
          -problem_.sideways_way.data()[node], 0.0, 0.0;
      closed_.middleRows<3>(3 * place++) = closed;
    }
    by_closed_ = forces_by(closed_);
  }

  [[nodiscard]] const std::vector<Index>& covered() const { return stiffness_.nodes(); }

  /// Forces along x, down and z by displacements along them [3 * nodes + axis].
  [[nodiscard]] MatrixXd forces_by(MatrixXd displacements) const {
    const auto count = static_cast<Index>(to_components_.size());
    const auto of_node = [](MatrixXd& field, Index i) { return field.middleRows<3>(3 * i); };
    for (Index i = 0; i < count; ++i) {
      of_node(displacements, i) = (to_components_[static_cast<std::size_t>(i)] * of_node(displacements, i)).eval();
    }
    MatrixXd forces = stiffness_.matrix() * displacements;
    for (Index i = 0; i < count; ++i) {
      of_node(forces, i) = (to_components_[static_cast<std::size_t>(i)].transpose() * of_node(forces, i)).eval();
    }
    return forces;
  }

  /// A node apart bears no force; one that slips bears what friction allows, and along the normal of its slip the
  /// traction turns with it. In the middle nothing moves sideways.
  [[nodiscard]] std::vector<Condition> conditions() {
    std::vector<Condition> conditions;
    for (std::size_t i = 0; i < covered().size(); ++i) {
      const Index node = covered()[i];
      const auto place = static_cast<Index>(i);
      const auto add = [&](std::size_t axis, const Eigen::Vector3d& on_force, const Eigen::Vector3d& on_move) {
        conditions.push_back({place, static_cast<Index>(axis), own_compliance_ * on_force, on_move});
      };
      const bool apart = !touches(node);
      if (apart) {
        for (const std::size_t axis : {kForward, kDown, kSideways}) {
          if (axis == kSideways && in_middle(node)) continue;
          add(axis, Eigen::Vector3d::Unit(static_cast<Index>(axis)), Eigen::Vector3d::Zero());
        }
      } else if (slips_.data()[node]) {
        const Eigen::Vector2d tau = trial(node);
        const Eigen::Vector2d e = tau.normalized();
        const double share = std::min(problem_.friction * pressing(node) / tau.norm(), 1.0);
        const Eigen::Vector3d across(-e[1], 0.0, e[0]);
        add(kForward, {e[0], problem_.friction, e[1]}, Eigen::Vector3d::Zero());
        if (!in_middle(node)) add(kSideways, (1.0 - share) * across, share * across);
      }
    }
    return conditions;
  }

  /// One linear system: how far the free displacements are from touching and sticking, the penetration and the way.
  void newton_step() {
    const std::vector<Condition> conditions = this->conditions();
    const auto free = static_cast<Index>(conditions.size());
    const Index depth = free;
    const Index way = free + 1;
    MatrixXd matrix(free + 2, free + 2);
    VectorXd right(free + 2);
    // In the components of the coating, whose stiffness it is.
    Eigen::Matrix3Xd on_force(3, free);
    for (Index i = 0; i < free; ++i) {
      const Condition& condition = conditions[static_cast<std::size_t>(i)];
      on_force.col(i) = to_components_[static_cast<std::size_t>(condition.place)] * condition.on_force;
    }
    VectorXd by_move(closed_.rows());
    for (Index column = 0; column < free; ++column) {
      const Condition& moved = conditions[static_cast<std::size_t>(column)];
      const auto direction = to_components_[static_cast<std::size_t>(moved.place)].col(moved.axis);
      by_move.setZero();
      for (Index p = 0; p < 3; ++p) {
        if (direction[p] != 0.0) by_move += direction[p] * stiffness_.matrix().col(3 * moved.place + p);
      }
      for (Index row = 0; row < free; ++row) {
        const Condition& condition = conditions[static_cast<std::size_t>(row)];
        matrix(row, column) = on_force.col(row).dot(by_move.segment<3>(3 * condition.place));
        if (condition.place == moved.place) matrix(row, column) += condition.on_move[moved.axis];
      }
    }
    for (Index row = 0; row < free; ++row) {
      const Condition& condition = conditions[static_cast<std::size_t>(row)];
      const Eigen::RowVector3d given = condition.on_force.transpose() * by_closed_.middleRows<3>(3 * condition.place);
      right[row] = -given[0];
      matrix.row(row).tail<2>() = given.tail<2>();
      matrix(depth, row) = by_closed_(3 * condition.place + condition.axis, 1);
      matrix(way, row) = -by_closed_(3 * condition.place + condition.axis, 2);
    }
    // Load and center: sums of forces, weighed as `closed_` weighs displacements.
    const Eigen::Matrix3d sums = closed_.transpose() * by_closed_;
    matrix.row(depth).tail<2>() = sums.row(1).tail<2>();
    right[depth] = problem_.load - sums(1, 0);
    matrix.row(depth) *= own_compliance_;
    right[depth] *= own_compliance_;
    const CenterCondition& center = problem_.center;
    matrix.row(way).tail<2>() = -sums.row(2).tail<2>();
    matrix.row(way) *= center.force;
    matrix(way, way) += center.way;
    right[way] = center.value + center.force * sums(2, 0);
    // Forces and ways on one scale: a heavy center must not serve as pivot for anything but its own way.
    const double share = own_compliance_ / std::max(center.force, std::abs(center.way) * own_compliance_);
    matrix.row(way) *= share;
    right[way] *= share;

    const VectorXd unknowns = solved(conditions, matrix, right);
    if (!unknowns.allFinite()) throw ConvergenceError("the equations of stick and slip are singular", 0, 1.0);
    VectorXd moves = VectorXd::Zero(closed_.rows());
    for (Index i = 0; i < free; ++i) {
      const Condition& condition = conditions[static_cast<std::size_t>(i)];
      moves[3 * condition.place + condition.axis] = unknowns[i];
    }
    penetration_ = unknowns[depth];
    way_ = unknowns[way];
    take(forces_by(closed_ * Eigen::Vector3d(1.0, penetration_, way_) + moves), moves);
  }

  /// While the same displacements are free, tractions turn alone: then the last factors precondition a Krylov method.
  [[nodiscard]] VectorXd solved(const std::vector<Condition>& conditions, const MatrixXd& matrix,
                                const VectorXd& right) {
    std::vector<std::pair<Index, Index>> free;
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

  void take(const VectorXd& forces, const VectorXd& moves) {
    for (HalfField* field : {&forces_.pressing, &forces_.forward, &forces_.sideways}) field->setZero();
    for (std::size_t i = 0; i < covered().size(); ++i) {
      const Index node = covered()[i];
      const auto move = moves.segment<3>(static_cast<Index>(3 * i));
      gap_.data()[node] = -move[kDown];
      forward_slip_.data()[node] = move[kForward];
      sideways_slip_.data()[node] = move[kSideways];
      if (!touches(node)) continue;
      const auto force = forces.segment<3>(static_cast<Index>(3 * i));
      pressing(node) = -force[kDown];
      forces_.forward.data()[node] = force[kForward];
      forces_.sideways.data()[node] = in_middle(node) ? 0.0 : force[kSideways];
    }
  }

  void find_gaps_and_slips() {
    const Index height = forces_.pressing.rows();
    displacement_ = problem_.tables.displacement_in_reach(on_plane(problem_.axes, forces_), nodes_.front() / height,
                                                          nodes_.back() / height);
    const HalfField moved = -displacement_.middleCols(problem_.tables.reach(), forces_.pressing.cols());
    gap_ = problem_.gap - along(problem_.axes[kDown], moved) - penetration_ * problem_.weights;
    forward_slip_ = problem_.forward_way + way_ * problem_.weights + along(problem_.axes[kForward], moved);
    sideways_slip_ = problem_.sideways_way + along(problem_.axes[kSideways], moved);
  }

  bool drop_tensile() {
    const auto is_tensile = [&](Index node) { return !(pressing(node) > 0.0); };
    for (const Index node : nodes_) {
      if (!is_tensile(node)) continue;
      pressing(node) = forces_.forward.data()[node] = forces_.sideways.data()[node] = 0.0;
      slips_.data()[node] = false;
    }
    return std::erase_if(nodes_, is_tensile) > 0;
  }

  /// Those that join slip, where there is no pressure yet to stick by. A node whose traction relieves it of its own
  /// pressure can neither stick nor slip nor leave, and would come and go for ever.
  bool add_overclosed() {
    std::vector<Index> added;
    for (Index node = 0; node < size(); ++node) {
      const bool overclosed = gap_.data()[node] < -10.0 * kTolerance * std::abs(penetration_);
      if (!overclosed || touches(node) || joined_.data()[node] == kMostJoins) continue;
      added.push_back(node);
      slips_.data()[node] = true;
      ++joined_.data()[node];
    }
    nodes_.insert(nodes_.end(), added.begin(), added.end());
    std::ranges::sort(nodes_);
    return !added.empty();
  }

  bool switch_stick_and_slip() {
    bool switched = false;
    for (const Index node : nodes_) {
      if (pressing(node) == 0.0) continue;  // it has just joined
      const double limit = problem_.friction * pressing(node);
      bool& slips = slips_.data()[node];
      const bool unsettled = slips && joined_.data()[node] > kFewJoins;
      const bool should = trial(node).norm() > limit * (1.0 + 1e-9) || unsettled;
      switched = switched || slips != should;
      slips = should;
    }
    return switched;
  }

  /// How far the tractions of slipping nodes are from friction's along their slip: all other conditions are linear.
  [[nodiscard]] double imbalance() {
    double sum = 0.0;
    for (const Index node : nodes_) {
      if (!slips_.data()[node]) continue;
      sum += (traction(node) - problem_.friction * pressing(node) * trial(node).normalized()).squaredNorm();
    }
    return std::sqrt(sum);
  }

  [[nodiscard]] StickSlip result() {
    Index sticking = 0;
    for (const Index node : nodes_) sticking += slips_.data()[node] ? 0 : 1;
    return {.forces = std::move(forces_),
            .penetration = penetration_,
            .way = way_,
            .forward_slip = std::move(forward_slip_),
            .sideways_slip = std::move(sideways_slip_),
            .displacement = std::move(displacement_),
            .nodes = std::move(nodes_),
            .sticking = sticking};
  }

  const StickSlipProblem& problem_;
  ContactStiffness& stiffness_;
  PlaneForces forces_;
  double own_compliance_ = 0.0;  // along the plane
  double penetration_ = 0.0;
  double way_ = 0.0;
  HalfField gap_;
  HalfField forward_slip_;
  HalfField sideways_slip_;
  HalfField displacement_;
  Eigen::ArrayXX<bool> slips_;
  Eigen::ArrayXXi joined_;  // how often
  std::vector<Index> nodes_;
  std::vector<Eigen::Matrix3d> to_components_;  // r, phi and theta of displacements along the axes, of nodes covered
  Eigen::MatrixX3d closed_;     // displacements that close all gaps and undo all ways: given, by penetration, by way
  Eigen::MatrixX3d by_closed_;  // forces of these
  std::vector<std::pair<Index, Index>> factored_;  // places and axes of the displacements that were free
  Eigen::PartialPivLU<MatrixXd> factors_;
};

}  // namespace

HalfField along(const std::array<HalfField, 3>& direction, const HalfField& field) {
  const Index half_nodes = direction[0].rows();
  HalfField result = direction[0].cwiseProduct(field.topRows(half_nodes));
  result += direction[1].cwiseProduct(field.middleRows(half_nodes, half_nodes));
  result += direction[2].cwiseProduct(field.bottomRows(half_nodes));
  return result;
}

HalfField spread(const std::array<HalfField, 3>& direction, const HalfField& scalar) {
  HalfField field(3 * scalar.rows(), scalar.cols());
  field << direction[0].cwiseProduct(scalar), direction[1].cwiseProduct(scalar), direction[2].cwiseProduct(scalar);
  return field;
}

HalfField on_plane(const Axes& axes, const PlaneForces& forces) {
  return spread(axes[kDown], forces.pressing) - spread(axes[kForward], forces.forward) -
         spread(axes[kSideways], forces.sideways);
}

StickSlip solve_stick_slip(const StickSlipProblem& problem, const PlaneForces& guess, ContactStiffness& stiffness) {
  return StickSlipSolver(problem, guess, stiffness).solve();
}

}  // namespace viscoroll::detail

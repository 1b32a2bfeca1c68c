#include "transient/stick_slip_step.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

enum Along : std::size_t { kForward = 0, kDown = 1, kSideways = 2 };

constexpr int kMostSteps = 100;
/// Steps in which nodes join while others leave.
constexpr int kExchanges = 12;
constexpr int kFewJoins = 3;          // of a node, after which it slips
constexpr int kMostJoins = 6;         // after which it stays out of this instant
constexpr double kTolerance = 1e-10;  // of forces per load, and of gaps per penetration

class StickSlipSolver {
 public:
  StickSlipSolver(const StickSlipProblem& problem, const PlaneForces& guess) : problem_(problem), forces_(guess) {
    const auto own = [&](std::size_t axis) {
      const Index middle = forces_.pressing.cols() / 2 * forces_.pressing.rows();
      return problem.tables.compliance({middle}, problem.axes[axis])(0, 0);
    };
    stiffness_ = 1.0 / own(kForward);
    joined_ = Eigen::ArrayXXi::Zero(guess.pressing.rows(), guess.pressing.cols());
    slips_ = Eigen::ArrayXX<bool>::Constant(guess.pressing.rows(), guess.pressing.cols(), false);
    for (Index node = 0; node < size(); ++node) {
      if (pressing(node) > 0.0) nodes_.push_back(node);
    }
  }

  [[nodiscard]] StickSlip solve() {
    for (int step = 0; step < kMostSteps; ++step) {
      if (nodes_.empty()) throw ConvergenceError("no node carries load", step, 1.0);
      const double change = newton_step();
      find_gaps_and_slips();
      const bool left = drop_tensile();
      const bool joined = (step < kExchanges || !left) && add_overclosed();
      const bool switched = switch_stick_and_slip();
      if (!left && !joined && !switched && change < kTolerance * problem_.load) return result();
    }
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
    return traction(node) - stiffness_ * Eigen::Vector2d(forward_slip_.data()[node], sideways_slip_.data()[node]);
  }

  /// One linear system for all nodes in contact. @return norm of the change of forces
  double newton_step() {
    const auto m = static_cast<Index>(nodes_.size());
    std::array<std::array<MatrixXd, 3>, 3> c;
    for (std::size_t a = 0; a < 3; ++a) {
      c[a][a] = problem_.tables.compliance(nodes_, problem_.axes[a]).selfadjointView<Eigen::Lower>();
      for (std::size_t b = a + 1; b < 3; ++b) {
        c[a][b] = problem_.tables.compliance(nodes_, problem_.axes[a], problem_.axes[b]);
        c[b][a] = c[a][b].transpose();
      }
    }
    const VectorXd weight = problem_.weights.reshaped()(nodes_);
    const VectorXd forward_way = problem_.forward_way.reshaped()(nodes_);
    const VectorXd sideways_way = problem_.sideways_way.reshaped()(nodes_);

    // Displacements along x, down and z by (p, t_x, t_z), where forces along y are -p.
    MatrixXd rise(m, 3 * m);
    MatrixXd forward(m, 3 * m);
    MatrixXd sideways(m, 3 * m);
    rise << c[kDown][kDown], -c[kDown][kForward], -c[kDown][kSideways];
    forward << -c[kForward][kDown], c[kForward][kForward], c[kForward][kSideways];
    sideways << -c[kSideways][kDown], c[kSideways][kForward], c[kSideways][kSideways];

    const Index depth = 3 * m;
    const Index way = 3 * m + 1;
    const double scale = 1.0 / stiffness_;
    MatrixXd matrix = MatrixXd::Zero(3 * m + 2, 3 * m + 2);
    VectorXd right = VectorXd::Zero(3 * m + 2);
    matrix.topLeftCorner(m, 3 * m) = rise;
    matrix.col(depth).head(m) = -weight;
    right.head(m) = -problem_.gap.reshaped()(nodes_);
    for (Index i = 0; i < m; ++i) {
      const Index node = nodes_[static_cast<std::size_t>(i)];
      auto first = matrix.row(m + i);
      auto second = matrix.row(2 * m + i);
      const bool middle = in_middle(node);
      if (!slips_.data()[node]) {
        first.head(3 * m) = forward.row(i);
        first[way] = weight[i];
        right[m + i] = -forward_way[i];
        second.head(3 * m) = sideways.row(i);
        right[2 * m + i] = -sideways_way[i];
      } else {
        const Eigen::Vector2d tau = trial(node);
        const Eigen::Vector2d e = tau.normalized();
        const double share = std::min(problem_.friction * pressing(node) / tau.norm(), 1.0);
        first[m + i] = e[0] * scale;
        first[2 * m + i] = e[1] * scale;
        first[i] = -problem_.friction * scale;
        // Normal to the slip the traction turns with it.
        second.head(3 * m) = share * (-e[1] * forward.row(i) + e[0] * sideways.row(i));
        second[way] = -share * e[1] * weight[i];
        second[m + i] -= (1.0 - share) * e[1] * scale;
        second[2 * m + i] += (1.0 - share) * e[0] * scale;
        right[2 * m + i] = share * (e[1] * forward_way[i] - e[0] * sideways_way[i]);
      }
      if (middle) {
        second.setZero();
        second[2 * m + i] = scale;
        right[2 * m + i] = 0.0;
      }
    }
    matrix.row(depth).head(m) = weight.transpose() * scale;
    right[depth] = problem_.load * scale;
    // Forces and ways on one scale: a heavy center must not serve as pivot for anything but its own way.
    const double share = scale / std::max(problem_.center.force, std::abs(problem_.center.way) * scale);
    matrix.row(way).segment(m, m) = share * problem_.center.force * weight.transpose();
    matrix(way, way) = share * problem_.center.way;
    right[way] = share * problem_.center.value;

    const VectorXd unknowns = matrix.partialPivLu().solve(right);
    if (!unknowns.allFinite()) throw ConvergenceError("the equations of stick and slip are singular", 0, 1.0);
    PlaneForces next{.pressing = HalfField::Zero(forces_.pressing.rows(), forces_.pressing.cols()),
                     .forward = HalfField::Zero(forces_.pressing.rows(), forces_.pressing.cols()),
                     .sideways = HalfField::Zero(forces_.pressing.rows(), forces_.pressing.cols())};
    next.pressing.reshaped()(nodes_) = unknowns.head(m);
    next.forward.reshaped()(nodes_) = unknowns.segment(m, m);
    next.sideways.reshaped()(nodes_) = unknowns.segment(2 * m, m);
    const double change =
        std::sqrt((next.pressing - forces_.pressing).squaredNorm() + (next.forward - forces_.forward).squaredNorm() +
                  (next.sideways - forces_.sideways).squaredNorm());
    forces_ = std::move(next);
    penetration_ = unknowns[depth];
    way_ = unknowns[way];
    return change;
  }

  void find_gaps_and_slips() {
    const HalfField moved =
        -problem_.tables.displacement(on_plane(problem_.axes, forces_), nodes_.front() / forces_.pressing.rows(),
                                      nodes_.back() / forces_.pressing.rows());
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
      if (!overclosed || std::ranges::binary_search(nodes_, node) || joined_.data()[node] == kMostJoins) continue;
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

  [[nodiscard]] StickSlip result() {
    Index sticking = 0;
    for (const Index node : nodes_) sticking += slips_.data()[node] ? 0 : 1;
    return {.forces = std::move(forces_),
            .penetration = penetration_,
            .way = way_,
            .forward_slip = std::move(forward_slip_),
            .sideways_slip = std::move(sideways_slip_),
            .nodes = std::move(nodes_),
            .sticking = sticking};
  }

  const StickSlipProblem& problem_;
  PlaneForces forces_;
  double stiffness_ = 0.0;  // force along the plane per own displacement
  double penetration_ = 0.0;
  double way_ = 0.0;
  HalfField gap_;
  HalfField forward_slip_;
  HalfField sideways_slip_;
  Eigen::ArrayXX<bool> slips_;
  Eigen::ArrayXXi joined_;  // how often
  std::vector<Index> nodes_;
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

StickSlip solve_stick_slip(const StickSlipProblem& problem, const PlaneForces& guess) {
  return StickSlipSolver(problem, guess).solve();
}

}  // namespace viscoroll::detail

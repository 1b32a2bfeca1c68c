#include "transient/stick_slip_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr int kStepsNearby = 25;  // from the forces of the guess, before all nodes of it stick
constexpr int kMostSteps = 100;
constexpr int kExchanges = 12;        // steps in which nodes join while others leave
constexpr int kFewJoins = 3;          // of a node, after which it slips
constexpr int kMostJoins = 6;         // after which it stays out of this instant
constexpr double kBalance = 1e-12;    // of tractions per load,
constexpr double kRoundOff = 1e-10;   // and where steps no longer improve it
constexpr double kTolerance = 1e-10;  // of gaps per penetration
constexpr double kLikelySlip = 0.97;  // traction per its limit from which a node of the guess is taken to slip

/// Which nodes may join at any step: those covered by the equations, whose gaps are unknowns of it, or all, at the cost
/// of a product.
enum class Joining { among_covered, anywhere };

class StickSlipSolver {
 public:
  StickSlipSolver(const StickSlipProblem& problem, const PlaneForces& guess, ContactStiffness& stiffness)
      : problem_(problem),
        equations_(problem, stiffness),
        forces_(guess),
        gap_(HalfField::Zero(guess.pressing.rows(), guess.pressing.cols())),
        forward_slip_(gap_),
        sideways_slip_(gap_),
        slips_(Eigen::ArrayXX<bool>::Constant(gap_.rows(), gap_.cols(), false)),
        joined_(Eigen::ArrayXXi::Zero(gap_.rows(), gap_.cols())) {}

  [[nodiscard]] StickSlip solve() {
    const PlaneForces guess = forces_;
    start_from(guess);
    if (settles(kStepsNearby, Joining::among_covered)) return result();
    start_from({.pressing = guess.pressing, .forward = 0.0 * guess.forward, .sideways = 0.0 * guess.sideways});
    if (settles(kMostSteps, Joining::anywhere)) return result();
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
    return traction(node) -
           Eigen::Vector2d(forward_slip_.data()[node], sideways_slip_.data()[node]) / equations_.own_compliance();
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

  /// @param[in] joining which gaps are known before all else has settled
  bool settles(int most_steps, Joining joining) {
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < most_steps && !nodes_.empty(); ++step) {
      equations_.cover(nodes_);
      if (!newton_step()) return false;
      if (joining == Joining::anywhere) find_gaps_and_slips();
      bool changed = drop_tensile();
      changed = ((step < kExchanges || !changed) && add_overclosed()) || changed;
      changed = switch_stick_and_slip() || changed;
      const double now = imbalance() / problem_.load;
      const bool stalls = now < kRoundOff && now > 0.5 * before;
      before = now;
      if (changed || (now > kBalance && !stalls)) continue;
      find_gaps_and_slips();
      if (!add_overclosed()) return true;
    }
    return false;
  }

  [[nodiscard]] bool touches(Index node) const { return std::ranges::binary_search(nodes_, node); }

  /// A node apart bears no force; one that slips bears what friction allows, and along the normal of its slip the
  /// traction turns with it. In the middle nothing moves sideways.
  [[nodiscard]] std::vector<Condition> conditions() {
    std::vector<Condition> conditions;
    for (std::size_t i = 0; i < equations_.covered().size(); ++i) {
      const Index node = equations_.covered()[i];
      const auto place = static_cast<Index>(i);
      const auto add = [&](Axis axis, const Eigen::Vector3d& on_force, const Eigen::Vector3d& on_move) {
        conditions.push_back({place, axis, equations_.own_compliance() * on_force, on_move});
      };
      const bool apart = !touches(node);
      if (apart) {
        for (const Axis axis : {kForward, kDown, kSideways}) {
          if (axis == kSideways && in_middle(node)) continue;
          add(axis, Eigen::Vector3d::Unit(axis), Eigen::Vector3d::Zero());
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

  /// @return whether the equations have a solution
  bool newton_step() {
    const auto [forces, moves, penetration, way] = equations_.solve(conditions());
    if (!forces.allFinite()) return false;
    penetration_ = penetration;
    way_ = way;
    for (HalfField* field : {&forces_.pressing, &forces_.forward, &forces_.sideways}) field->setZero();
    for (std::size_t i = 0; i < equations_.covered().size(); ++i) {
      const Index node = equations_.covered()[i];
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
    return true;
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
  StickSlipEquations equations_;
  PlaneForces forces_;
  double penetration_ = 0.0;
  double way_ = 0.0;
  HalfField gap_;
  HalfField forward_slip_;
  HalfField sideways_slip_;
  HalfField displacement_;
  Eigen::ArrayXX<bool> slips_;
  Eigen::ArrayXXi joined_;  // how often
  std::vector<Index> nodes_;
};

}  // namespace

StickSlip solve_stick_slip(const StickSlipProblem& problem, const PlaneForces& guess, ContactStiffness& stiffness) {
  return StickSlipSolver(problem, guess, stiffness).solve();
}

}  // namespace viscoroll::detail

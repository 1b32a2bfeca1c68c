#include "contact/frictional_contact.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/cycle_breaker.hpp"
#include "contact/friction_path.hpp"
#include "contact/stick_slip_conditions.hpp"
#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr double kTolerance = 1e-10;     // residual of a converged state, per load, or per largest friction force ...
constexpr double kLeastFriction = 0.01;  // ... from this coefficient on
constexpr double kRoundOff = 1e-8;       // the same of one that Newton steps no longer improve
constexpr double kLargestCreep = 2e-7;   // of nodes that stick, per spread of the strain, ...
constexpr int kStepsOfRest = 3;          // ... which so many steps may mend
constexpr double kHopeless = 1e3;        // residual that steps do not come back from in time
constexpr int kStepsOfOneFriction = 25;  // Newton steps before an intermediate friction is tried
constexpr int kMostSteps = 60;           // of them as long as the residual halves ...
constexpr int kHalving = 12;             // ... in so many of them
constexpr int kStepsOfFullStick = 6;     // which is a start, and need not have a solution
constexpr int kFreeSteps = 8;            // of them before their lengths are controlled
constexpr int kFreeStepsNearby = 3;      // and from a state with friction that is near
constexpr double kAstray = 2.0;          // of the least residual, from which they are taken back
constexpr int kPatienceNearby = 8;       // after which steps from such a state must have halved the residual
constexpr int kPatience = 14;            // after which those from the end of a path must have halved it
constexpr double kShortestStep = 0.05;   // per Newton step
constexpr double kLongestStride =
    1.0;  // along a path of states, in e-folds of the parameter and relative changes of force
constexpr double kShortestStride = 1e-4;
constexpr double kCorner = 0.02;         // stride from which a corner is looked for
constexpr double kStride = 1.5;          // growth of such strides that are easy: that take so many ...
constexpr int kEasySteps = 8;            // ... linear systems, two per Newton step
constexpr int kMostStepsAhead = 12;      // Newton steps of a stride
constexpr int kPatienceAhead = 4;        // after which they must not have raised the residual
constexpr double kNearby = 0.01;         // step of the parameter for derivatives by it
constexpr double kEasyFriction = 0.3;    // second start
constexpr double kSmallCreepage = 1e-5;  // below which the scale of creepages is linear
constexpr double kFarPlace = 9.2;        // on that scale, a creepage of 5 %
constexpr double kMostCreepage = 1.0;    // beyond, what slides as a whole hardly changes, and steps lose themselves
constexpr double kSmallShare = 1e-3;     // of creepages, from which they are raised
constexpr double kSmallestRatio = 1.05;  // of one share to the next
constexpr double kRoughStep = 1e-2;      // residual of a step by products: as much as a step's change of sets is worth
constexpr double kExactStep = 1e-6;
constexpr Index kSmallContact = 300;       // nodes up to which every step is exact, which takes fewer of them
constexpr double kMostEffort = 1e10;       // operations in operator applications on a mesh: some seconds ...
constexpr double kManyApplications = 800;  // ... or eight times what a state usually takes ...
constexpr double kMuchEffort = 4.0;        // ... within so many times that

class FrictionalContactSolver {
 public:
  FrictionalContactSolver(const ContactProblem& problem, const ContactSolution& start, const ContactOptions& options)
      : problem_(problem),
        options_(options),
        friction_(*problem.friction),
        conditions_(problem),
        state_(start),
        has_friction_(start.creepage.has_value()),
        free_steps_(has_friction_ ? kFreeStepsNearby : kFreeSteps),
        friction_share_(std::clamp(friction_.coefficient, kLeastFriction, 1.0)),
        tolerance_(std::max(kTolerance * friction_share_, options.tolerance)) {
    if (has_friction_) return;
    state_.creepage = friction_.drive->given_creepage().value_or(0.0);
    state_.converged = false;
  }

  [[nodiscard]] ContactSolution solve() {
    if (find()) return finished();
    throw ConvergenceError("no state of stick and slip was found in " + std::to_string(state_.iterations) +
                               " iterations: the residual is " + rounded(last_residual_) + " of the load",
                           state_.iterations, last_residual_);
  }

 private:
  /// A state of the same friction leads there. From full stick most frictions are reached at once, and spheres that
  /// slide as a whole from the frictionless contact; the others step by step.
  bool find() {
    const ContactSolution start = state_;
    const double friction = friction_.coefficient;
    if (has_friction_ && (iterate(friction, kPatienceNearby) || (restart_from(start) && iterate_exactly())))
      return true;
    if (restart_from(start) && find_directly()) return true;
    const auto by_friction = [&] { return restart_from(start) && iterate(kEasyFriction) && approach(kEasyFriction); };
    const bool given = friction_.drive->given_creepage().has_value();
    if (given && by_friction()) return true;
    if (restart_from(start) && (given ? find_by_less_creepage() : find_by_creepage())) return true;
    if (!given && by_friction()) return true;
    restart_from(start);
    stick_fully();
    const double large = 10.0 * std::max(1.0, friction);  // hardly different from full stick
    return iterate(large) && approach(large);
  }

  /// From full stick or from the contact without friction, at once.
  bool find_directly() {
    const ContactSolution start = state_;
    stick_fully();
    return iterate(friction_.coefficient) || (restart_from(start) && iterate(friction_.coefficient));
  }

  /// Towards the state of unlimited friction.
  void stick_fully() {
    std::ignore = iterate(std::numeric_limits<double>::infinity(), kStepsOfFullStick, kStepsOfFullStick);
  }

  /// The same contact at a given creepage, with a share of the guided slip. @return whether it was found
  bool find_at_creepage(double creepage, double guided_share, const ContactSolution& from) {
    ContactProblem other = problem_;
    other.friction->drive = std::make_shared<GivenCreepage>(creepage);
    other.friction->rigid_slip += (guided_share - 1.0) * friction_.guided_slip;
    FrictionalContactSolver solver(other, from, options_);
    solver.state_.creepage = creepage;
    solver.free_steps_ = free_steps_;
    solver.count_as(state_);
    const bool found = solver.has_friction_ ? solver.iterate(friction_.coefficient) : solver.find_directly();
    if (found) state_ = solver.state_;
    count_as(solver.state_);
    return found;
  }

  /// Forces and moments fall as the creepage rises, from those of a sphere that spins on the spot to those of one that
  /// skids: follow the states at given creepages to where the drive is passed, from one where much slips, if it lies
  /// beyond, or from none.
  bool find_by_creepage() {
    const ContactSolution start = state_;
    const std::optional<ContactSolution> none = find_at_place(0.0);
    if (!none) return false;
    const double far = drive_excess(*none) > 0.0 ? kFarPlace : -kFarPlace;
    restart_from(start);
    const std::optional<ContactSolution> beyond = find_at_place(far);
    if (beyond && (drive_excess(*beyond) > 0.0) != (far > 0.0) && follow_creepages(*beyond, far)) return true;
    return follow_creepages(*none, 0.0);
  }

  /// @return a state at a creepage, on its scale
  std::optional<ContactSolution> find_at_place(double place) {
    ContactProblem other = problem_;
    other.friction->drive = std::make_shared<GivenCreepage>(creepage_at(place));
    FrictionalContactSolver there(other, state_, options_);
    const bool found = place == 0.0 ? there.find() : there.find_directly();
    count_as(there.state_);
    return found ? std::optional(there.state_) : std::nullopt;
  }

  /// From a state at a creepage to where the drive is passed.
  bool follow_creepages(const ContactSolution& from, double place) {
    ContactProblem other = problem_;
    const auto give = [&other](double at) { other.friction->drive = std::make_shared<GivenCreepage>(creepage_at(at)); };
    give(place);
    FrictionalContactSolver along(other, from, options_);
    along.count_as(state_);
    along.give_ = [&give, friction = friction_.coefficient](double at) {
      give(at);
      return friction;
    };
    const auto excess = [this, &along] { return drive_excess(along.state_); };
    const auto arrive = [&] {
      count_as(along.state_);
      if (restart_from(along.state_) && iterate(friction_.coefficient, kPatience)) return true;
      along.count_as(state_);
      return false;
    };
    const double span = std::asinh(kMostCreepage / kSmallCreepage);
    const double side = excess() > 0.0 ? 1.0 : -1.0;
    if (along.follow_to(side, place, span - side * place, excess, arrive)) return true;
    count_as(along.state_);
    return false;
  }

  static double creepage_at(double place) { return kSmallCreepage * std::sinh(place); }

  /// Step by step from small creepages, longitudinal, lateral and spin, to the given ones.
  bool find_by_less_creepage() {
    const double creepage = *friction_.drive->given_creepage();
    double reached = kSmallShare;
    if (!find_at_creepage(reached * creepage, reached, state_)) return false;
    for (double ratio = 3.0; reached < 1.0;) {
      const ContactSolution before = state_;
      const double next = std::min(ratio * reached, 1.0);
      if (find_at_creepage(next * creepage, next, before)) {
        reached = next;
      } else {
        ratio = std::sqrt(ratio);
        if (ratio < kSmallestRatio || is_exhausted()) return false;
        restart_from(before);
      }
    }
    return iterate(friction_.coefficient);
  }

  [[nodiscard]] ContactSolution finished() {
    ContactSets sets = sets_at(friction_.coefficient);
    const bool is_a_start = options_.tolerance == tolerance_;  // for a finer mesh
    if (!is_a_start) rest(sets);
    note_sets(sets);
    state_.converged = true;
    return state_;
  }

  /// Newton steps that are solved with care, where rough ones have failed.
  bool iterate_exactly() {
    step_tolerance_ = kExactStep;
    const bool found = iterate(friction_.coefficient);
    step_tolerance_ = kRoughStep;
    return found;
  }

  /// Follow the states from the present one, at the friction `reached`, to the one wanted.
  bool approach(double reached) {
    if (reached == friction_.coefficient) return true;
    const double goal = std::log(friction_.coefficient);
    const double start = std::log(reached);
    return follow_to(
        std::copysign(1.0, goal - start), start, std::numeric_limits<double>::infinity(), [&] { return place_ - goal; },
        [&] { return iterate(friction_.coefficient, kPatience); });
  }

  /// Follow the states from the present one to where an excess is none. On the way the parameter may have to turn back,
  /// so the steps are those of the path's length: halved where they fail, grown where they are easy.
  /// @param[in] side to which the parameter is to change, 1 or -1
  /// @param[in] start,farthest its value here, and the largest change of it
  /// @param[in] excess of the present state
  /// @param[in] arrive from a state that is near. @return whether that led to one
  template <class Excess, class Arrive>
  bool follow_to(double side, double start, double farthest, const Excess& excess, const Arrive& arrive) {
    PathPoint here = path_point(start);
    place_ = start;
    double before = excess();
    const PathMetric metric(here.force);
    PathPoint way = tangent(here, metric);
    if (side * way.parameter < 0.0) way = -1.0 * way;
    double stride = kLongestStride;
    while (stride > kShortestStride && !is_exhausted()) {
      const double passed = side * (here.parameter - start);
      if (passed < 0.0 || passed > farthest) return false;
      const int iterations = state_.iterations;
      const std::optional<PathPoint> next = follow(here, way, stride, metric);
      if (!next) {
        stride *= 0.5;
        if (stride < kCorner) {
          if (auto turned = turn(here, stride * way, metric)) {
            std::tie(here, way) = *std::move(turned);
            stride = kCorner;
            before = excess();
          }
        }
        continue;
      }
      const double after = excess();
      const PathPoint step = *next - here;
      if ((after > 0.0) != (before > 0.0)) {
        take(here + before / (before - after) * step);
        if (arrive()) return true;
        if (stride > kCorner) {
          stride *= 0.5;
          continue;
        }
      }
      if (state_.iterations - iterations <= kEasySteps) stride = std::min(kStride * stride, kLongestStride);
      way = metric.unit(step);
      here = *next;
      before = after;
    }
    return false;
  }

  /// @return the state of the path so far ahead along `way`: Newton steps on the plane across it there
  std::optional<PathPoint> follow(const PathPoint& from, const PathPoint& way, double stride,
                                  const PathMetric& metric) {
    PathPoint point = from + stride * way;
    double first = 0.0;
    for (int step = 0; step < kMostStepsAhead && !is_exhausted(); ++step) {
      const ContactSets sets = move_to(point);
      if (!(state_.residual < kHopeless) || sets.contact.empty()) return std::nullopt;
      if (state_.residual < tolerance_) return point;
      if (step == 0) first = state_.residual;
      if (step >= kPatienceAhead && state_.residual > first) return std::nullopt;
      const LinearPath path = linearized(point, sets);
      const double left = stride - metric.dot(way, path.point - from);
      point = path.point + left / metric.dot(way, path.slope) * path.slope;
      if (!(std::abs(point.parameter - from.parameter) < 2.0 * kLongestStride)) return std::nullopt;
    }
    return std::nullopt;
  }

  /// Around a corner of the path, where nodes change their state, forces go on to change as they did and the parameter
  /// may turn back.
  /// @param[in] from a state close to the corner
  /// @param[in] step beyond it, along the straight line to it
  /// @return a state on the next straight line, where it holds what that takes for given, and the way along it
  std::optional<std::pair<PathPoint, PathPoint>> turn(const PathPoint& from, const PathPoint& step,
                                                      const PathMetric& metric) {
    const ContactSets before = move_to(from);
    const ContactSets sets = move_to(from + step);
    if (is_same(sets, before)) return std::nullopt;
    const LinearPath line = linearized(from, sets);
    const PathPoint way = metric.unit(line.slope);
    for (double length = kCorner; length > kShortestStride; length *= 0.25) {
      for (const double side : {1.0, -1.0}) {
        const PathPoint point = line.point + side * length * way;
        if (is_same(move_to(point), sets) && state_.residual < kHopeless) {
          const std::optional<PathPoint> state = follow(line.point, side * way, length, metric);
          if (state && is_same(sets_at(give_(state->parameter)), sets)) return std::pair{*state, side * way};
        }
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] PathPoint tangent(const PathPoint& at, const PathMetric& metric) {
    return metric.unit(linearized(at, move_to(at)).slope);
  }

  /// The states that the sets at a point ask for, in the neighborhood of its parameter.
  [[nodiscard]] LinearPath linearized(const PathPoint& at, const ContactSets& sets) {
    const auto solved = [&](double parameter) {
      take(at);
      ++state_.iterations;
      conditions_.take_step(give_(parameter), sets, kExactStep, state_);
      return path_point(parameter);
    };
    const PathPoint here = solved(at.parameter);
    return {here, 1.0 / kNearby * (solved(at.parameter + kNearby) - here)};
  }

  ContactSets move_to(const PathPoint& point) {
    take(point);
    find_displacements();
    return sets_at(give_(point.parameter));
  }

  [[nodiscard]] PathPoint path_point(double parameter) const {
    return {state_.force, state_.penetration, *state_.creepage, parameter};
  }

  void take(const PathPoint& point) {
    state_.force = point.force;
    state_.penetration = point.penetration;
    state_.creepage = point.creepage;
    place_ = point.parameter;
  }

  /// Take the forces of another state, but keep count. @return true, to be followed by an attempt
  bool restart_from(const ContactSolution& other) {
    count_as(std::exchange(state_, other));
    return true;
  }

  void count_as(const ContactSolution& other) {
    state_.iterations = other.iterations;
    state_.operator_applications = other.operator_applications;
  }

  /// Newton steps at a given friction, from the present state, so many of which must have halved the residual.
  bool iterate(double friction, int patience = kStepsOfOneFriction, int most_steps = kStepsOfOneFriction) {
    CycleBreaker breaker(problem_.initial_gap.size());
    std::vector<double> residuals;
    ContactSolution best = state_;
    ContactSets best_sets;
    for (int step = 0;; ++step) {
      find_displacements();
      ContactSets sets = sets_at(friction);
      if (state_.prolonged) conditions_.keep_contact(friction, state_, sets);
      if (!(state_.residual < kHopeless) || sets.contact.empty()) return false;
      if (friction == friction_.coefficient) last_residual_ = state_.residual;
      const auto is_halved_since = [&](std::size_t before) { return state_.residual <= 0.5 * residuals[before]; };
      residuals.push_back(state_.residual);
      const bool stalled = step > 0 && !is_halved_since(residuals.size() - 2);
      if (state_.residual < tolerance_ || (stalled && state_.residual < kRoundOff * friction_share_)) {
        return true;
      }
      if (step == kMostSteps || is_exhausted()) return false;
      const bool progresses = step >= kHalving && is_halved_since(residuals.size() - 1 - kHalving);
      if (step >= most_steps && !progresses) return false;
      if (step >= patience && !is_halved_since(0)) return false;
      if (step == 0 || state_.residual < best.residual) {
        best = state_;
        best_sets = sets;
      }
      if (step == free_steps_ && state_.residual > kAstray * best.residual) {
        restart_from(best);
        sets = best_sets;
        residuals.back() = best.residual;
        breaker = CycleBreaker(problem_.initial_gap.size());
      }
      ++state_.iterations;
      const ContactSolution before = state_;
      const bool freed = breaker.free_undecided(sets);
      take_step(friction, sets, step);
      if (step >= free_steps_ && !freed) shorten_step(friction, before);
    }
  }

  /// A residual that is small beside the load may leave creep that is not small beside the way that sticking nodes are
  /// carried by the strain of the surface: further steps as long as they help.
  void rest(ContactSets& sets) {
    for (int step = 0; step < kStepsOfRest && conditions_.creep(state_, sets) > kLargestCreep; ++step) {
      const ContactSolution before = state_;
      conditions_.take_step(friction_.coefficient, sets, kExactStep, state_);
      ++state_.iterations;
      find_displacements();
      ContactSets next = sets_at(friction_.coefficient);
      if (!(state_.residual < before.residual)) {
        restart_from(before);
        return;
      }
      sets = std::move(next);
    }
  }

  /// Whether enough has been tried.
  [[nodiscard]] bool is_exhausted() const {
    const double affordable = kMostEffort / problem_.surface->operations();
    const double most = std::max(affordable, std::min(kManyApplications, kMuchEffort * affordable));
    return state_.iterations >= options_.max_iterations || state_.operator_applications >= most;
  }

  void take_step(double friction, const ContactSets& sets, int step) {
    const bool small = static_cast<Index>(sets.contact.size()) <= kSmallContact;
    const double tolerance = small ? kExactStep : (step < free_steps_ ? step_tolerance_ : 0.1 * step_tolerance_);
    conditions_.take_step(friction, sets, tolerance, state_);
    if (!friction_.drive->given_creepage()) {
      state_.creepage = std::clamp(*state_.creepage, -kMostCreepage, kMostCreepage);
    }
  }

  /// Halve a step that leads further away from a solution, which ends cycles of nodes between two states.
  void shorten_step(double friction, const ContactSolution& before) {
    const ContactSolution full = state_;
    for (double share = 1.0; share > kShortestStep; share *= 0.5) {
      state_.force = before.force + share * (full.force - before.force);
      state_.penetration = before.penetration + share * (full.penetration - before.penetration);
      state_.creepage = *before.creepage + share * (*full.creepage - *before.creepage);
      find_displacements();
      std::ignore = sets_at(friction);
      if (state_.residual < before.residual) return;
    }
  }

  void find_displacements() { conditions_.find_displacements(state_); }

  /// Who touches, sticks and slips after the present state.
  ContactSets sets_at(double friction) { return conditions_.sets(friction, state_); }

  [[nodiscard]] double drive_excess(const ContactSolution& state) const { return conditions_.drive_excess(state); }

  void note_sets(const ContactSets& sets) {
    state_.contact = sets.contact;
    state_.stick.clear();
    for (std::size_t i = 0; i < sets.contact.size(); ++i) {
      if (sets.states[i].stick) state_.stick.push_back(sets.contact[i]);
    }
  }

  const ContactProblem& problem_;
  const ContactOptions& options_;
  const Friction& friction_;
  StickSlipConditions conditions_;
  ContactSolution state_;
  bool has_friction_;
  int free_steps_;
  double friction_share_;  // of the load, by which residuals are judged
  double tolerance_;       // residual of a converged state
  double step_tolerance_ = kRoughStep;
  std::function<double(double)> give_ = [](double log) { return std::exp(log); };  // of a path: parameter to friction
  double place_ = 0.0;          // parameter of the present state on a path
  double last_residual_ = 1.0;  // the last finite one at the friction wanted, for the message of a failure
};

}  // namespace

ContactSolution solve_frictional_contact(const ContactProblem& problem, const ContactSolution& start,
                                         const ContactOptions& options) {
  return FrictionalContactSolver(problem, start, options).solve();
}

}  // namespace viscoroll::detail

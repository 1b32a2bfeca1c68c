#include "contact/adhesive_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "contact/adhesive_newton.hpp"
#include "contact/multilevel.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr double kLeastRatio = 1.02;  // of cohesive zones of successive laws, below which continuation fails
/// Distance from the contact to the edge without a zone that has the same pressure far away, relative to the length of
/// the zone: twice the ratio of the integrals of s^(1/2) and s^(-1/2) times the traction of an elastic edge.
constexpr double kEffectiveEdge = 0.276;
constexpr int kMostDoublings = 4;          // of the first cohesive zone, which is as long as the contact
constexpr double kLeastStep = 1.0 / 1024;  // of a path of loads or penetrations, relative to the whole path
// Steps of the penetration on the path to the fold, relative to the undeformed gap at the edge of the contact. The load
// is stationary at the fold, where the last step leaves a relative error of the order of its square.
constexpr double kFirstFoldStep = 0.2;
constexpr double kLeastFoldStep = 1e-3;

/// Contact on one mesh, followed through laws, loads and penetrations.
class AdhesiveContact {
 public:
  AdhesiveContact(ContactProblem problem, const ContactOptions& options)
      : problem_(std::move(problem)), options_(options), newton_(problem_, options) {}

  /// Begin with the contact without adhesion at the equivalent load, and shorten the range from the size of the contact
  /// to that of the mesh.
  void begin(double contact_gap_limit) {
    ContactProblem bare = problem_;
    bare.attraction.reset();
    bare.penetration.reset();
    bare.largest_tension = false;
    bare.normal_force = attraction().equivalent_load;
    const LocatedContact pressed = solve_multilevel(bare, contact_gap_limit, options_);
    const ContactSolution whole = extended(pressed, bare);
    state_ = {.pressing = pressing_force(whole), .penetration = whole.penetration};
    size_ = size_of(whole.contact, state_.pressing);
    set_load(std::max(problem_.normal_force, 0.0));
    const double target = attraction().resolved_zone();
    double widest = std::max(2.0 * size_.half_length, target);
    for (int doublings = 0; !advance(widest); ++doublings) {
      if (doublings == kMostDoublings) throw failure();
      widest *= 2.0;
    }
    shorten(target);
  }

  /// Begin with a state of a mesh of twice the spacing.
  /// @return whether a state near it was found
  [[nodiscard]] bool begin_from(const LocatedContact& coarse) {
    state_ = {.pressing = prolonged_pressing(coarse, problem_.surface->window()),
              .penetration = coarse.contact.penetration};
    size_ = coarse.contact.adhesion->size;
    if (coarse.problem.penetration) {
      problem_.penetration = coarse.problem.penetration;
    } else {
      set_load(coarse.problem.normal_force);
    }
    const double target = attraction().resolved_zone();
    if (advance(target)) return true;
    const double wider = std::max(coarse.contact.adhesion->zone_length, target);
    if (!advance(wider)) return false;
    return try_to_shorten(target);
  }

  /// Go to the condition of a problem: a load, a penetration or the largest tension.
  void go_to(const ContactProblem& given) {
    if (given.largest_tension) {
      find_fold();
      return;
    }
    const bool by_load = !given.penetration;
    const double target = by_load ? given.normal_force : *given.penetration;
    const double start = by_load ? load_ : state_.penetration;
    if (target == (by_load ? load_ : problem_.penetration.value_or(std::numeric_limits<double>::quiet_NaN()))) return;
    if (follow(start, target, by_load)) return;
    if (by_load ? target >= 0.0 : target > start) throw failure();
    if (by_load) find_fold();
    if (!by_load || target <= load_) throw LiftsOff(state_.load(), state_.penetration);
    // On a mesh, the load may have further folds before the largest tension, beyond which the path is followed back.
    if (!follow(load_, target, by_load)) throw failure();
  }

  [[nodiscard]] LocatedContact located() const {
    LocatedContact result{.problem = problem_, .contact = {}};
    ContactSolution& contact = result.contact;
    contact.force = VectorField::Zero(state_.pressing.size(), 3);
    contact.force.col(kDown) = -state_.pressing;
    contact.gap = state_.gap;
    contact.contact = newton_.touching(law_, state_);
    contact.penetration = state_.penetration;
    contact.iterations = newton_.systems();
    contact.operator_applications = newton_.products();
    contact.converged = true;
    contact.residual = state_.residual;
    contact.adhesion = AdhesiveEdges{
        .zone = newton_.zone(law_, state_), .zone_length = length_, .size = size_, .lost_work = lost_work(law_)};
    return result;
  }

  /// Update the law with the size of the current contact, and solve again. If no state is found, the last law stays.
  void settle() {
    const ContactSize before = size_;
    size_ = size_of(newton_.touching(law_, state_), state_.pressing);
    TractionLaw law = attraction().law(length_, size_);
    if (advance_under(law)) {
      law_ = std::move(law);
    } else {
      size_ = before;
    }
  }

 private:
  /// Change the load or the penetration in steps as large as possible, as far as the state is stable.
  /// @return whether the target was reached
  [[nodiscard]] bool follow(double start, double target, bool by_load) {
    double reached = 0.0;
    double step = 1.0;
    while (reached < 1.0) {
      const double next = std::min(reached + step, 1.0);
      const double value = start + next * (target - start);
      const AdhesiveState before = state_;
      by_load ? set_load(value) : set_penetration(value);
      if (advance(length_) && (!by_load || target >= 0.0 || is_stable())) {
        reached = next;
        step *= 2.0;
        continue;
      }
      state_ = before;
      step *= 0.5;
      if (step < kLeastStep) return false;
    }
    return true;
  }

  [[nodiscard]] const Attraction& attraction() const { return *problem_.attraction; }

  [[nodiscard]] ConvergenceError failure() const {
    return {
        "the iterative solver of the contact with adhesion did not converge; give the penetration in place of the "
        "load, a higher speed or a coarser accuracy",
        newton_.systems(), state_.residual};
  }

  void set_load(double load) {
    problem_.penetration.reset();
    problem_.normal_force = load;
    load_ = load;
  }
  void set_penetration(double penetration) { problem_.penetration = penetration; }

  /// Solve under a law, from the current state, and keep the solution.
  [[nodiscard]] bool advance(double length) {
    if (length == length_) return advance_under(law_);
    TractionLaw law = attraction().law(length, size_);
    if (!advance_under(law)) return false;
    law_ = std::move(law);
    length_ = length;
    return true;
  }

  [[nodiscard]] bool advance_under(const TractionLaw& law) {
    AdhesiveState next = newton_.solve(problem_, law, state_);
    if (!next.converged) {
      state_.residual = next.residual;
      return false;
    }
    state_ = std::move(next);
    return true;
  }

  [[nodiscard]] bool try_to_shorten(double target) {
    double ratio = 2.0;
    while (length_ > target) {
      const ContactSize before = size_;
      size_ = size_of(newton_.touching(law_, state_), state_.pressing);
      if (advance(std::max(length_ / ratio, target))) {
        ratio = 2.0;
        continue;
      }
      size_ = before;  // of the law that the state belongs to
      ratio = std::sqrt(ratio);
      if (ratio < kLeastRatio) return false;
    }
    return true;
  }

  void shorten(double target) {
    if (!try_to_shorten(target)) throw failure();
  }

  /// Whether the load increases with the penetration. On the branch beyond the fold, which a given load cannot hold, it
  /// decreases.
  [[nodiscard]] bool is_stable() {
    const AdhesiveState here = state_;
    const double change = 1e-3 * depth();
    set_penetration(here.penetration + change);
    const bool found = advance(length_);
    const bool rises = found && state_.load() > here.load();
    state_ = here;
    set_load(here.load());
    return rises;
  }

  /// Undeformed gap at the edge of the contact [m], a measure of penetrations.
  [[nodiscard]] double depth() const {
    const std::vector<Index> nodes = newton_.touching(law_, state_);
    return problem_.initial_gap(nodes).maxCoeff() + std::numeric_limits<double>::min();
  }

  /// Reduce the penetration until the tension is largest.
  void find_fold() {
    const double size = depth();
    double step = kFirstFoldStep * size;
    AdhesiveState best = state_;
    bool is_bracketed = false;
    while (step > kLeastFoldStep * size) {
      state_ = best;
      set_penetration(best.penetration - step);
      if (advance(length_) && state_.load() < best.load()) {
        best = state_;
        if (!is_bracketed) step *= 2.0;
        continue;
      }
      // The fold lies within a step of the best state.
      is_bracketed = true;
      step *= 0.5;
      state_ = best;
      set_penetration(best.penetration + step);
      if (advance(length_) && state_.load() < best.load()) best = state_;
    }
    state_ = best;
    set_penetration(best.penetration);
    load_ = best.load();
  }

  [[nodiscard]] ContactSize size_of(const std::vector<Index>& nodes, const ArrayXd& pressing) const {
    if (nodes.empty()) return size_;  // all nodes with forces are in the cohesive zone
    const double first = attraction().x(nodes).minCoeff();
    const double last = attraction().x(nodes).maxCoeff();
    const double center = 0.5 * (first + last);
    Index middle = 0;
    ((attraction().x - center).square() + attraction().z.square()).minCoeff(&middle);
    return {.center = center,
            .half_length = 0.5 * (last - first) + attraction().spacing + kEffectiveEdge * length_,
            .pressure = pressing[middle] / attraction().area[middle]};
  }

  /// Work that the attraction takes from the material that passes, minus the work that it returns: the integral of the
  /// attraction over the gap along every line of the path, integrated across it [J/m], in line contact [J/m^2]. The law
  /// changes along a line, since the normal of the edge turns.
  [[nodiscard]] double lost_work(const TractionLaw& law) const {
    const Index stride = problem_.surface->window().theta.count();
    const double along = problem_.surface->row_distance();
    const auto taken = [&](Index at, Index from, Index to) {
      return law.remaining_work(at, state_.gap[from]) - law.remaining_work(at, state_.gap[to]);
    };
    double sum = 0.0;
    for (Index node = 0; node + stride < state_.gap.size(); ++node) {  // material moves towards later rows
      const Index next = node + stride;
      const double across = 0.5 * (attraction().area[node] + attraction().area[next]) / along;
      sum += across * 0.5 * (taken(node, node, next) + taken(next, node, next));
    }
    return sum;
  }

  ContactProblem problem_;
  ContactOptions options_;
  AdhesiveNewton newton_;
  AdhesiveState state_;
  TractionLaw law_;
  double length_ = 0.0;  // of the cohesive zones of the law
  ContactSize size_;     // used by `law_`; during a step, the size for the next law
  double load_ = 0.0;
};

LocatedContact solve_levels(const ContactProblem& problem, double contact_gap_limit, const ContactOptions& options,
                            bool is_finest);

/// Solve on a mesh of twice the spacing.
/// @return nothing if that mesh has no state: a contact of few nodes supports less tension
std::optional<LocatedContact> solve_coarser(const ContactProblem& problem, double contact_gap_limit,
                                            const ContactOptions& options) {
  if (!is_worth_coarsening(problem.surface->window())) return std::nullopt;
  try {
    return solve_levels(coarsened(problem), contact_gap_limit, options, false);
  } catch (const LiftsOff&) {
    return std::nullopt;
  }
}

/// Solve from coarse to fine.
/// @param[in] is_finest whether no finer level follows
LocatedContact solve_levels(const ContactProblem& problem, double contact_gap_limit, const ContactOptions& options,
                            bool is_finest) {
  AdhesiveContact contact(problem, options);
  const std::optional<LocatedContact> coarse = solve_coarser(problem, contact_gap_limit, options);
  const bool found = coarse && contact.begin_from(*coarse);
  if (!found) contact.begin(contact_gap_limit);
  // The finest level takes the size of the contact from the level below, which changes results by less than the error
  // of the mesh and saves a third of the time.
  if (!found || !is_finest) contact.settle();
  contact.go_to(problem);
  return contact.located();
}

}  // namespace

LocatedContact solve_adhesive_contact(const ContactProblem& problem, double contact_gap_limit,
                                      const ContactOptions& options) {
  return solve_levels(problem, contact_gap_limit, options, true);
}

}  // namespace viscoroll::detail

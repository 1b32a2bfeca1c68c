#include "rolling/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/validate.hpp"
#include "contact/traction_law.hpp"
#include "rolling/adhesion.hpp"
#include "rolling/drives.hpp"
#include "rolling/finite_strain.hpp"
#include "rolling/result.hpp"
#include "rolling/solve_load_case.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kFewestNodesPerRevolution = 64;
// Ratio of the nodes of successive meshes below which their difference, mainly the noise of nodes that join the contact
// one by one, says little about the error. Only the largest number of nodes leads to ratios below two.
constexpr double kLeastRefinement = 1.5;
// With adhesion, error of the dissipated power relative to that of the power balance, which contains the moments of
// both edges; at most a tenth for rollers on a half-plane except in very fast rolling, where a warning names the
// balance (docs/theory/adhesion.md, "Power balance" and "Evidence").
constexpr double kShareOfBalance = 0.1;
// Largest error of the power balance with adhesion. Near the edge of the contact, the pressure of the hard wall
// is a square root, which nodes represent with an error of the second order in the spacing per cohesive zone. In fast
// rolling the moments of both edges almost cancel, but not these errors; the dissipated power does not contain them.
constexpr double kAdhesiveBalance = 2e-3;
constexpr double kMaxContactNodes = 3e6;  // whose fields need a third of a gigabyte
constexpr double kInertiaShare = 1e-3;    // relative error of the inertia terms, as a fraction of the accuracy
constexpr double kMaxFrictionalContactNodes = 4e5;  // their Krylov methods store some tens of vectors
// Largest numbers of nodes in contact times operator applications on a further mesh: some seconds. Products with
// adhesion have one component.
constexpr double kMaxFrictionalEffort = 6e6;
constexpr double kMaxAdhesiveEffort = 2.4e7;
constexpr double kMaxNodesForPressure = 5e4;      // in contact, after all other results have settled: 1 to 2 s
constexpr double kMaxLineNodesForPressure = 4e3;  // in line contact, after all other results have settled
constexpr double kMaxEffortForPressure = 1e6;     // nodes of a line contact times operator applications: 0.5 s
// Ratio of the errors on two successive meshes above which the second mesh has been ineffective.
constexpr double kIneffectiveRatio = 0.9;
constexpr int kMaxIneffectiveMeshes = 2;  // the first of them may only have detected a narrow peak
// Expected ratios of the errors on two successive meshes.
constexpr double kExpectedRatio = 0.25;
constexpr double kExpectedRatioOfLength = 0.5;
// Ratio of the error of the contact length to its change from the previous mesh. The errors of both meshes are
// independent, and proportional to the spacing: the change is sqrt(5) times the error in the root mean square.
constexpr double kErrorPerChangeOfLength = 0.5;

int whole_nodes(double nodes_per_revolution) {
  const double nodes = std::round(nodes_per_revolution);
  return static_cast<int>(std::clamp<double>(nodes, kFewestNodesPerRevolution, kMaxNodesPerRevolution));
}

/// Ratio of the spacing across to that along, for a contact that is longer in one direction.
double aspect_of(const ContactReach& contact) {
  constexpr double kNarrowest = 0.25;
  constexpr double kWidest = 2.0;  // contacts that end at side faces need more nodes across than their length suggests
  return std::clamp(contact.across / contact.along, kNarrowest, kWidest);
}

/// Number of nodes in the estimated contact radius that should suffice. Nodes that join the contact one by one leave a
/// staircase in the torque over load or speed: 0.4 % with 41 nodes across the contact of the paper's example, falling
/// with the power 2.3 of their number. It should be a tenth of the accuracy. The estimated contact is about
/// 1.5 times as wide as the contact.
double nodes_per_radius(double accuracy) { return 0.75 * 41.0 * std::pow(10.0 * 0.004 / accuracy, 1.0 / 2.3); }

/// Largest number of nodes in contact. A mesh that the accuracy itself requires may have many. Further meshes, which
/// are needed if results change by more than they should, may take at most some seconds with the operator applications
/// of the previous mesh.
double max_contact_nodes(const LoadCase& load_case, const Options& options, double planned, int applications) {
  const bool has_friction = load_case.friction > 0.0;
  const bool costly = has_friction || options.curvature == Curvature::exact;
  double cheap = costly ? 5e4 : 1e6;
  if (has_friction) cheap = std::min(cheap, kMaxFrictionalEffort / applications);
  if (load_case.adhesion) cheap = std::min(cheap, kMaxAdhesiveEffort / applications);
  return std::min(has_friction ? kMaxFrictionalContactNodes : kMaxContactNodes, std::max(planned, cheap));
}

/// Number of nodes with forces, including those of cohesive zones.
double loaded_nodes(const Result& result) {
  const double nodes = result.refinements.back().contact_nodes;
  return result.attracted_area ? nodes * *result.attracted_area / result.contact_area : nodes;
}

/// A result that the caller did not prescribe, and the size relative to which its error is measured.
struct Answer {
  double value;
  double size;
};

/// Scalar results that are checked for convergence, always in the same order for the same load case.
std::vector<Answer> answers(const Result& result, const LoadCase& load_case, double radius) {
  // The moments of both edges of an adhesive contact almost cancel in the sum of x p, but not in the power.
  const double moment = load_case.adhesion ? result.rolling_resistance_torque : result.resisting_torque;
  const double torque = std::abs(moment);
  // The load of an adhesive contact may be zero; a tenth of its largest pressure is about the mean one.
  const double load = load_case.adhesion
                          ? std::max(std::abs(result.load), 0.1 * result.max_pressure * result.contact_area)
                          : result.load;
  const double negligible = std::max(1e-10 * load * result.semi_axis_x, std::numeric_limits<double>::min());
  const double force = torque / radius;
  const double approach_scale = 0.5 * std::pow(result.semi_axis_x, 2) / radius;
  std::vector<Answer> answers{{moment, std::max(torque, negligible)}};
  if (!load_case.load) {
    answers.push_back({result.load, load});
  } else if (result.penetration) {
    answers.push_back({*result.penetration, load_case.adhesion ? std::max(std::abs(*result.penetration), approach_scale)
                                                               : std::abs(*result.penetration)});
  }
  if (load_case.friction == 0.0) return answers;
  answers.push_back(
      {result.dissipated_power, std::max(std::abs(result.dissipated_power), negligible * load_case.angular_speed)});
  const GivenMotion given = given_motion(load_case);
  if (!given.torque) {
    answers.push_back({result.driving_torque, std::max({std::abs(result.driving_torque), torque, negligible})});
  }
  if (!given.force) {
    answers.push_back({result.driving_force, std::max(std::abs(result.driving_force), force)});
  }
  if (given.lateral_creepage != 0.0) {
    answers.push_back({result.lateral_force, std::max(std::abs(result.lateral_force), force)});
  }
  if (!given.creepage) answers.push_back({*result.linear_speed, std::abs(*result.linear_speed)});
  return answers;
}

/// Largest change of a result, relative to its size on either mesh.
double largest_change(const std::vector<Answer>& now, const std::vector<Answer>& before) {
  double largest = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double size = std::max({now[i].size, before[i].size, std::numeric_limits<double>::min()});
    largest = std::max(largest, std::abs(now[i].value - before[i].value) / size);
  }
  return largest;
}

/// Change of a positive scalar, relative to the larger value.
double change_of(double ResultScalars::* scalar, const Result& now, const Result& before) {
  return std::abs(now.*scalar - before.*scalar) /
         std::max({now.*scalar, before.*scalar, std::numeric_limits<double>::min()});
}

/// Solver on a sequence of meshes, each with twice the nodes, until two of them agree.
class Refiner {
 public:
  explicit Refiner(const RollingCase& given)
      : given_(given), load_case_(given.load_case), options_(given.options), radius_(given.pair.body->radius()) {
    if (std::isfinite(width(given.pair))) aspect_ = aspect_of(given.contact);
    // The first mesh serves to estimate the error of the second, which should suffice.
    const double nodes = std::numbers::pi * nodes_per_radius(options_.accuracy) * radius_ / given.contact.along;
    mesh_ = make_mesh(std::min(nodes, 0.5 * kMaxNodesPerRevolution));
  }

  [[nodiscard]] Result solve() {
    while (advance()) {
    }
    if (!best_) report();
    if (best_->status == Status::converged && !(best_->error_estimate <= options_.accuracy)) {
      best_->status = Status::accuracy_not_reached;
    }
    best_->refinements = std::move(refinements_);
    FasterModel faster;
    add_finite_strain(*best_, std::move(rough_), given_, faster);
    return *std::move(best_);
  }

 private:
  [[nodiscard]] Mesh make_mesh(double nodes_per_revolution) const {
    Mesh mesh{.nodes_per_revolution = whole_nodes(nodes_per_revolution)};
    if (aspect_) mesh.theta_nodes_per_revolution = whole_nodes(mesh.nodes_per_revolution / *aspect_);
    return mesh;
  }

  /// Solve on the next mesh. @return whether another mesh is to follow
  [[nodiscard]] bool advance() {
    try {
      const MeshModel model = make_model(given_.pair, mesh_, options_.curvature, given_.execution,
                                         {.inertia_tolerance = kInertiaShare * options_.accuracy});
      const auto seen = best_ ? std::optional(loaded_reach(*best_)) : std::nullopt;
      Options options = options_;
      options.finite_strain = options_.finite_strain && (!rough_ || given_.pair.body->form().is_line());
      RollingCase on_mesh = with_same_estimate(given_, given_.pair, load_case_, options);
      on_mesh.shortest_zone = shortest_zone_;
      note(solve_load_case(model, on_mesh, seen));
    } catch (const MeshTooFine&) {
      failure_ = std::current_exception();
      return !best_ && go_on_with(mesh_.nodes_per_revolution / 4.0);
    } catch (const std::bad_alloc&) {
      failure_ = std::current_exception();
      return !best_ && go_on_with(mesh_.nodes_per_revolution / 4.0);
    } catch (const ConvergenceError&) {
      const bool first_failure = !failure_;
      failure_ = std::current_exception();
      return !best_ && first_failure && go_on_with(2.0 * mesh_.nodes_per_revolution);
    }
    if (has_ended_) return false;
    bool goes_on = is_settled(*best_) ? may_settle_pressure() || may_settle_length() : !is_finest();
    const double previous = std::exchange(shortest_zone_, 0.0);
    if (!goes_on && may_settle_balance()) {
      goes_on = true;
      shortest_zone_ = std::max(previous, kSpacingsPerZone * phi_spacing(mesh_) * radius_);
    }
    return goes_on && go_on_with(2.0 * mesh_.nodes_per_revolution);
  }

  /// Whether all results except the largest pressure and the contact length have settled.
  [[nodiscard]] bool is_settled(const Result& result) const {
    return result.status == Status::converged && result.error_estimate <= options_.accuracy &&
           !(load_case_.adhesion && relative_zone(given_, result) > kLongestZone);
  }

  /// Whether meshes of acceptable cost would settle the largest pressure. If no such mesh resolves its peak, a warning
  /// reports this.
  [[nodiscard]] bool may_settle_pressure() const {
    return ineffective_meshes_ < kMaxIneffectiveMeshes && may_settle(best_->max_pressure_error, kExpectedRatio);
  }

  /// Whether meshes of acceptable cost would settle the contact length. A pressure that rises within less than a
  /// spacing leaves the position of the edge uncertain by half a spacing.
  [[nodiscard]] bool may_settle_length() const {
    return may_settle(best_->contact_length_error, kExpectedRatioOfLength);
  }

  /// Whether a mesh of acceptable cost, with the same cohesive zones, may close the power balance with
  /// adhesion. The error varies with the positions of the edges between nodes, so that it cannot be predicted.
  [[nodiscard]] bool may_settle_balance() const {
    const double growth = given_.pair.body->form().is_line() ? 2.0 : 4.0;
    return load_case_.adhesion && is_settled(*best_) && best_->energy_balance_error > kAdhesiveBalance &&
           growth * loaded_nodes(*best_) * best_->operator_applications < kMaxAdhesiveEffort;
  }

  /// Whether meshes of acceptable cost would settle a result.
  /// @param[in] error its relative error estimate
  /// @param[in] expected_ratio ratio of its errors on two successive meshes
  [[nodiscard]] bool may_settle(double error, double expected_ratio) const {
    const bool is_line = best_->theta_nodes == 1;
    const double nodes = loaded_nodes(*best_);
    const double most = std::min(is_line ? kMaxLineNodesForPressure : kMaxNodesForPressure,
                                 max_contact_nodes(load_case_, options_, 0.0, best_->operator_applications));
    const double per_mesh = is_line ? 2.0 : 4.0;
    const double meshes = std::floor(std::log(most / nodes) / std::log(per_mesh));
    const bool is_cheap = !is_line || nodes * best_->operator_applications < kMaxEffortForPressure;
    return error > options_.accuracy && meshes >= 1.0 && is_cheap &&
           error * std::pow(expected_ratio, meshes) <= options_.accuracy;
  }

  /// Whether the next mesh would exceed the limits of memory or time.
  [[nodiscard]] bool is_finest() const {
    constexpr double kPlanned = 16.0;  // for the second mesh, whose contact may be somewhat larger than on the first
    const double next = 4.0 * loaded_nodes(*best_);
    return next > max_contact_nodes(load_case_, options_, kPlanned * refinements_.front().contact_nodes,
                                    best_->operator_applications);
  }

  /// Rethrow the failure that occurred on every mesh, in terms of the caller's input.
  [[noreturn]] void report() const {
    try {
      std::rethrow_exception(failure_);
    } catch (const MeshTooFine& error) {
      reject("accuracy", "so large that the mesh fits into memory",
             text(options_.accuracy) + " (" + error.what() + ")");
    }
  }

  /// @return whether the mesh differs enough from the previous one to show its error
  bool go_on_with(double nodes_per_revolution) {
    const Mesh next = make_mesh(nodes_per_revolution);
    const double ratio = static_cast<double>(next.nodes_per_revolution) / mesh_.nodes_per_revolution;
    if (next == mesh_ || (ratio > 1.0 && ratio < kLeastRefinement)) return false;
    mesh_ = next;
    return true;
  }

  /// Largest change from the best mesh so far. If the limit of the nodes leaves less than twice as many, the change is
  /// that which twice as many would cause, for an error proportional to the spacing.
  [[nodiscard]] double change_per_doubling(const Mesh& mesh, const std::vector<Answer>& found) const {
    const double ratio = static_cast<double>(mesh.nodes_per_revolution) / best_->mesh.nodes_per_revolution;
    return largest_change(found, answers_) * std::max(1.0, 0.5 / (1.0 - 1.0 / ratio));
  }

  void note(Result&& result) {
    if (best_) {
      result.max_pressure_error = std::max({result.max_pressure_error, change_of(&Result::max_pressure, result, *best_),
                                            kExpectedRatio * best_->max_pressure_error});
      result.contact_length_error = std::max(
          result.contact_length_error, kErrorPerChangeOfLength * change_of(&Result::contact_length, result, *best_));
    }
    if (best_ && is_settled(*best_) && result.max_pressure_error > kIneffectiveRatio * best_->max_pressure_error)
      ++ineffective_meshes_;
    Refinement& step = result.refinements.back();
    std::vector<Answer> found = answers(result, load_case_, radius_);
    // The first mesh has no previous mesh to compare with.
    const double balance = (load_case_.adhesion ? kShareOfBalance : 1.0) * step.energy_balance_error;
    step.error_estimate = best_ ? std::max(balance, change_per_doubling(result.mesh, found)) : 1.0;
    if (shortest_zone_ > 0.0) {
      step.error_estimate = std::max(step.error_estimate, largest_change(found, answers_of_longer_zones_));
    } else {
      answers_of_longer_zones_ = answers_;
    }
    result.error_estimate = step.error_estimate;
    has_ended_ = result.status != Status::converged;
    // Keep the earlier result: this mesh was meant to improve the pressure or the contact length only.
    if (has_ended_ && best_ && is_settled(*best_)) return;
    refinements_.push_back(step);
    answers_ = std::move(found);
    if (result.overspeed && result.status == Status::converged) rough_ = result;
    best_ = std::move(result);
  }

  const RollingCase& given_;
  const LoadCase& load_case_;
  const Options& options_;
  double radius_;
  std::optional<double> aspect_;  // of patches, if those of the body are not square
  Mesh mesh_;
  double shortest_zone_ = 0.0;  // see RollingCase
  bool has_ended_ = false;
  int ineffective_meshes_ = 0;   // meshes that hardly reduced the error of the largest pressure
  std::optional<Result> best_;   // on the finest mesh that was solved
  std::optional<Result> rough_;  // on a mesh that suffices for the correction at finite strain
  std::vector<Answer> answers_;
  std::vector<Answer> answers_of_longer_zones_;  // of the last mesh whose cohesive zones were not those of `best_`
  std::vector<Refinement> refinements_;
  std::exception_ptr failure_;
};

}  // namespace

Result solve_to_accuracy(const RollingCase& given) { return Refiner(given).solve(); }

}  // namespace viscoroll::detail

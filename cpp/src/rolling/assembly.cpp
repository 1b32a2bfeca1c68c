#include "rolling/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "rolling/contact_estimate.hpp"
#include "rolling/drives.hpp"
#include "rolling/initial_gap.hpp"
#include "rolling/rigid_slip.hpp"
#include "surface/sum_operator.hpp"

namespace viscoroll::detail {
namespace {

/// Fraction of the estimated contact whose nodes are assumed to touch at first. The estimated contact is half as wide
/// again as the contact, and too many nodes are better than too few. 16 balls with and without friction took 1410,
/// 1063, 1164, 1491 and 1557 operator applications with fractions of 0.5, 0.67, 0.8, 1 and 1.3.
constexpr double kLikelyShare = 0.8;

/// Surface operator of the rolling body, of the counterbody, or the sum of both.
std::shared_ptr<const SurfaceOperator> surface_on(const SurfaceWindow& window, const Assembly& given) {
  const MeshModel& model = given.model;
  std::shared_ptr<const SurfaceOperator> own;
  if (model.own) own = model.own->operator_on(window, given.formulation, given.execution);
  if (!model.counterpart) return own;
  Formulation formulation = given.formulation;
  formulation.is_counterpart = true;
  formulation.counterpart_curvatures = given.pair().on->curvatures();
  auto counterpart = model.counterpart->operator_on(window, formulation, given.execution);
  return own ? std::make_shared<SumOperator>(std::move(own), std::move(counterpart)) : counterpart;
}

Friction make_friction(const SurfaceWindow& window, const Assembly& given) {
  const LoadCase& load_case = given.load_case;
  RigidWays ways = rigid_slip(given.displaced_points(window), given.model.swelling, given.options.slip_kinematics,
                              given.pair(), given_motion(load_case.drive));
  return {.coefficient = load_case.friction,
          .rigid_slip = std::move(ways.slip),
          .counterpart_way = std::move(ways.counterpart_way),
          .step = window.grid().radius * window.grid().phi_spacing,
          .arms = given.lever_arms(window),
          .drive = condition_of(load_case.drive, given.pressure_share()),
          .shared = given.model.starts->of(load_case, given.options, window.window())};
}

}  // namespace

bool Assembly::has_sides() const { return std::isfinite(width(pair())); }

bool Assembly::approach_exists() const { return detail::approach_exists(pair()); }

SurfaceWindow Assembly::displaced_points(const SurfaceWindow& window) const {
  if (formulation.collocation == window.shift()) return window;
  return {window.grid(), window.window(), formulation.collocation};
}

LeverArms Assembly::lever_arms(const SurfaceWindow& window) const {
  const double swelling = model.swelling.own;
  LeverArms arms{
      .x = swelling * window.x(), .y = swelling * window.points().y().values(), .radius = pair().body->radius()};
  if (pair().on->curvatures().along != 0.0) arms.slope = counterpart_slope(window, model.swelling, pair());
  return arms;
}

LeverArms Assembly::lever_arms(const SurfaceWindow& window, const std::vector<Eigen::Index>& at) const {
  const double swelling = model.swelling.own;
  return {.x = swelling * window.x()(at), .y = swelling * window.points().y().at(at), .radius = pair().body->radius()};
}

ContactProblem Assembly::problem(const SurfaceWindow& window) const {
  ContactProblem problem{.surface = surface_on(window, *this),
                         .initial_gap = initial_gap(displaced_points(window), model.swelling, pair()),
                         .normal_force = load_case.load,
                         .friction = std::nullopt,
                         .ends_at_sides = has_sides() && window.window().theta == nodes.widest.theta};
  if (load_case.friction > 0.0) problem.friction = make_friction(window, *this);
  return problem;
}

Assembly assemble(const MeshModel& model, const LoadCase& load_case, const Options& options, Watch& watch) {
  const double radius = model.pair.body->radius();
  const ContactReach contact = estimate_contact(model.pair, load_case.angular_speed, load_case.load);
  const double half_chord = kLikelyShare * contact.along;
  return {.model = model,
          .load_case = load_case,
          .options = options,
          .execution = {.threads = options.threads, .watch = watch},
          .limits = {.max_iterations = options.max_iterations},
          .formulation = {.compliance = options.compliance,
                          .patch_load = options.patch_load,
                          .tangential = load_case.friction > 0.0,
                          .collocation = model.collocation},
          .nodes = nodes_of(model.pair, model.mesh),
          .contact = contact,
          .estimated_depth = radius - std::sqrt(std::max(std::pow(radius, 2) - std::pow(half_chord, 2), 0.0))};
}

}  // namespace viscoroll::detail

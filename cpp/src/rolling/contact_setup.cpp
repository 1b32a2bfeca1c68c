#include "rolling/contact_setup.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "rolling/adhesion.hpp"
#include "rolling/contact_estimate.hpp"
#include "rolling/drives.hpp"
#include "rolling/initial_gap.hpp"
#include "rolling/input_checks.hpp"
#include "rolling/rigid_slip.hpp"
#include "surface/sum_operator.hpp"

namespace viscoroll::detail {
namespace {

/// Fraction of the estimated half-width within which nodes are assumed to touch at first. The estimate is about 1.5
/// times the half-width of the contact, and too many nodes are better than too few. With fractions of 0.5, 0.67, 0.8, 1
/// and 1.3, 16 balls with and without friction took 1410, 1063, 1164, 1491 and 1557 operator applications.
constexpr double kAssumedShare = 0.8;

/// Surface operator of the rolling body, of the counterbody, or the sum of both.
std::shared_ptr<const SurfaceOperator> surface_on(const SurfaceWindow& window, const ContactSetup& given) {
  const MeshModel& model = given.model;
  std::shared_ptr<const SurfaceOperator> own;
  if (model.own) own = model.own->operator_on(window, given.formulation, given.execution);
  if (!model.counterbody) return own;
  Formulation formulation = given.formulation;
  formulation.is_counterbody = true;
  formulation.counterbody_curvatures = given.pair.on->curvatures();
  auto counterbody = model.counterbody->operator_on(window, formulation, given.execution);
  return own ? std::make_shared<SumOperator>(std::move(own), std::move(counterbody)) : counterbody;
}

Friction make_friction(const SurfaceWindow& window, const ContactSetup& given) {
  const LoadCase& load_case = given.load_case;
  RigidDisplacements rigid = rigid_slip(given.displaced_points(window), given.pair.growth,
                                        given.options.slip_kinematics, given.pair, given_motion(load_case));
  return {.coefficient = load_case.friction,
          .rigid_slip = std::move(rigid.slip),
          .counterbody_rigid_displacement = std::move(rigid.counterbody),
          .step = window.grid().radius * window.grid().phi_spacing,
          .arms = given.moment_arms(window),
          .drive = condition_of(load_case, given.pressure_work_factor()),
          .shared = given.model.starts->of(load_case, given.options, window.window())};
}

}  // namespace

bool ContactSetup::has_sides() const { return std::isfinite(width(pair)); }

SurfaceWindow ContactSetup::displaced_points(const SurfaceWindow& window) const {
  if (formulation.collocation == window.shift()) return window;
  return {window.grid(), window.window(), formulation.collocation};
}

MomentArms ContactSetup::moment_arms(const SurfaceWindow& window) const {
  const double growth = pair.growth.own;
  MomentArms arms{.x = growth * window.x(), .y = growth * window.points().y().values(), .radius = pair.body->radius()};
  if (pair.on->curvatures().along != 0.0) arms.slope = counterbody_slope(window, pair.growth, pair);
  return arms;
}

MomentArms ContactSetup::moment_arms(const SurfaceWindow& window, const std::vector<Eigen::Index>& at) const {
  const double growth = pair.growth.own;
  return {.x = growth * window.x()(at), .y = growth * window.points().y().at(at), .radius = pair.body->radius()};
}

ContactProblem ContactSetup::problem(const SurfaceWindow& window) const {
  ContactProblem problem{.surface = surface_on(window, *this),
                         .initial_gap = initial_gap(displaced_points(window), pair.growth, pair),
                         .normal_force = load_case.load.value_or(0.0),
                         .friction = std::nullopt,
                         .ends_at_sides = has_sides() && window.window().theta == nodes.widest.theta};
  if (load_case.penetration) problem.penetration = *load_case.penetration + pair.centrifugal;
  if (load_case.friction > 0.0) problem.friction = make_friction(window, *this);
  if (load_case.adhesion) problem.attraction = attraction_at(*this, window);
  problem.largest_tension = load_case.pulls_off;
  return problem;
}

RollingCase rolling_case(const PairAtSpeed& pair, const LoadCase& load_case, const Options& options, Watch& watch) {
  require_formulation(pair, options);
  require_adhesion(pair, load_case);
  if (load_case.penetration) require_penetration(pair, load_case);
  const ContactReach contact = estimate_contact(pair, load_case);
  const double radius = pair.body->radius();
  const double half_chord = kAssumedShare * contact.along;
  return {.pair = pair,
          .load_case = load_case,
          .options = options,
          .execution = {.threads = options.threads, .watch = watch},
          .contact = contact,
          .estimated_depth = radius - std::sqrt(std::max(std::pow(radius, 2) - std::pow(half_chord, 2), 0.0)),
          .equivalent_load = load_case.adhesion ? equivalent_load(pair, load_case) : 0.0};
}

ContactSetup assemble(const MeshModel& model, const RollingCase& given) {
  return {given,
          model,
          {.max_iterations = given.options.max_iterations},
          {.compliance = given.options.compliance,
           .patch_load = given.options.patch_load,
           .tangential = given.load_case.friction > 0.0,
           .collocation = model.collocation},
          nodes_of(model.pair, model.mesh)};
}

}  // namespace viscoroll::detail

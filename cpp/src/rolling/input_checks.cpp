#include "rolling/input_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "base/validate.hpp"
#include "contact/multilevel.hpp"
#include "rolling/contact_estimate.hpp"
#include "rolling/drives.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kMaxNodes = 25000000;  // in a window; as many nodes need about 10 GB

/// Layer whose modulus relaxes most between the contact frequency and rest.
struct Relaxation {
  std::string layer;
  double modulus;  ///< relaxed modulus [Pa]
  double ratio;    ///< relaxed modulus divided by the modulus at the contact frequency [-]
};

/// @param[in] contact_frequency angular frequency [rad/s]
Relaxation strongest_relaxation(const PairAtSpeed& pair, double contact_frequency) {
  const std::array frequencies{0.0, contact_frequency};
  Relaxation strongest{.layer = "", .modulus = 0.0, .ratio = 2.0};
  for (const auto& [name, layer] : layers(pair)) {
    const auto moduli = modulus_in_rolling(layer.shear_modulus, pair.angular_speed, frequencies);
    const double ratio = moduli.front().real() / std::abs(moduli.back());
    if (ratio < strongest.ratio) strongest = {.layer = name, .modulus = moduli.front().real(), .ratio = ratio};
  }
  return strongest;
}

/// Drive of a body that slides over its whole contact.
struct SlidingDrive {
  double force;   ///< force on the center [N]
  double moment;  ///< moment about the center [N m]
};

/// Drives of a body that skids (creepage 1) and of a body that spins in place (creepage -1).
std::array<SlidingDrive, 2> sliding_drives(const ContactSetup& setup, ContactProblem problem) {
  std::array<SlidingDrive, 2> drives{};
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    problem.friction->drive = std::make_shared<GivenCreepage>(side == 0 ? 1.0 : -1.0);
    const auto [boxed, contact] = solve_multilevel(problem, setup.contact_gap_limit(), setup.limits);
    const ContactState state{*boxed.surface, boxed.friction->arms, contact.force, own_displacement(contact)};
    drives[side] = {.force = slope_force(state).force - contact.force.col(kForward).sum(),
                    .moment = moment_about_center(state, setup.pressure_work_factor())};
  }
  return drives;
}

/// Reject a drive with which the body would slide permanently.
/// @param[in] least,most limits of the drive; between them the body rolls
void require_between(const DriveReport& report, double given, double least, double most, const RoundBody& body) {
  if (given > least && given < most) return;
  const auto in_units = [&](const std::string& number) { return number + " " + std::string(report.unit); };
  reject(report.parameter,
         "between " + in_units(rounded(report.factor * least)) + " and " + in_units(rounded(report.factor * most)) +
             ", otherwise the " + std::string(body.name()) + " slides permanently",
         in_units(text(report.factor * given)),
         Range{.unit = std::string(report.unit),
               .minimum = report.factor * least,
               .maximum = report.factor * most,
               .excludes_minimum = true,
               .excludes_maximum = true});
}

}  // namespace

void reject_load(const RollingPair& pair, const LoadCase& load_case, const std::string& reason) {
  const bool is_load = load_case.load.has_value();
  reject(is_load ? "load" : "penetration", "small enough for the coating",
         text(is_load ? *load_case.load : *load_case.penetration) + " " +
             std::string(is_load ? pair.body->form().load_unit : "m") + " (the " + std::string(pair.body->name()) +
             " " + reason + ")");
}

void reject_tension(const ContactSetup& setup, double load, double penetration) {
  const LoadCase& given = setup.load_case;
  const std::string unit(given.load ? setup.pair.body->form().load_unit : "m");
  const double least = given.load ? load : penetration - setup.pair.centrifugal;
  reject(given.load ? "load" : "penetration",
         "> " + rounded(least) + " " + unit + ", at which the " + std::string(setup.pair.body->name()) + " lifts off",
         text(given.load ? *given.load : *given.penetration) + " " + unit,
         Range{.unit = unit, .minimum = least, .excludes_minimum = true});
}

void reject_contact_over_60_degrees(const RollingPair& pair, const LoadCase& load_case) {
  reject_load(pair, load_case, "is in contact beyond 60 degrees to either side");
}

void reject_contact_over_60_degrees(const RollingPair& pair, double load) {
  reject_contact_over_60_degrees(pair, LoadCase{.load = load});
}

void require_depth(const RollingPair& pair, double load, double depth) {
  const double most = thickness(pair);
  if (!(depth < most)) {
    reject_load(pair, LoadCase{.load = load},
                "is pressed " + rounded(depth) + " m into a coating of thickness " + text(most) + " m");
  }
}

void require_formulation(const RollingPair& pair, const Options& options) {
  pair.body->require(options);
  if (pair.on->is_rigid()) return;
  const std::string why = " if the counterbody deforms";
  if (options.compliance == Compliance::vertical) reject("compliance", "RADIAL" + why, "VERTICAL");
  if (options.patch_load != PatchLoad::flat) reject("patch_load", "FLAT" + why, "SPHERICAL");
}

void require_penetration(const PairAtSpeed& pair, const LoadCase& load_case) {
  const double penetration = *load_case.penetration;
  const std::string value = text(penetration) + " m";
  if (!approach_exists(pair)) {
    reject("penetration", "left out in line contact on a half-space, where it is undetermined: give the load", value);
  }
  const double least = -pair.centrifugal;
  if (!load_case.adhesion && !(penetration > least)) {
    reject("penetration", "> " + (least == 0.0 ? "0 m" : rounded(least) + " m (minus the centrifugal displacement)"),
           value, Range{.unit = "m", .minimum = least, .excludes_minimum = true});
  }
  const double most = thickness(pair);
  if (!(penetration < most)) {
    reject("penetration", Range{.unit = "m", .maximum = most, .excludes_maximum = true}, value,
           ", the thickness of the coating");
  }
}

void require_supported(const MeshModel& model, const RollingCase& given) {
  const PairAtSpeed& pair = given.pair;
  const LoadCase& load_case = given.load_case;
  if (load_case.load && !(*load_case.load <= load_upper_bound(pair, model.stiffest_modulus))) {
    reject_load(pair, load_case, "would be pressed through any coating of this stiffness");
  }
  constexpr double kMinModulusRatio = 1e-5;  // at 1e-6, round-off stops the iteration at a relative residual of 4e-8
  const double contact_frequency = pair.angular_speed * std::max(1.0, pair.body->radius() / given.contact.along);
  const Relaxation relaxation = strongest_relaxation(pair, contact_frequency);
  if (relaxation.ratio >= kMinModulusRatio) return;
  reject(relaxation.layer + ".shear_modulus",
         "such that the relaxed modulus is at least " + text(kMinModulusRatio) +
             " times the modulus at the contact frequency",
         "a relaxed modulus of " + rounded(relaxation.modulus) + " Pa, which is " + rounded(relaxation.ratio) +
             " times that modulus");
}

void require_node_limit(const Window& window, const Mesh& mesh) {
  const double nodes = static_cast<double>(window.phi.count()) * static_cast<double>(window.theta.count());
  if (nodes <= kMaxNodes) return;
  throw MeshTooFine(mesh.nodes_per_revolution, std::to_string(kMaxNodes) + " nodes around the contact",
                    text(nodes) + " nodes");
}

void require_contact(const ContactSetup& setup, double friction, double penetration) {
  if (!std::isfinite(penetration)) throw ConvergenceError("the contact equations have no finite solution", 0, 1.0);
  if (approach_exists(setup.pair) && !setup.load_case.adhesion && !(penetration > 0.0)) {
    if (friction == 0.0) {
      setup.pair.body->require_stiffness();
      setup.pair.on->require_stiffness();
      // The remaining cause of a penetration that is not positive is a contact too wide for the equations.
      reject_load(setup.pair, setup.load_case, "would be pressed through the coating");
    }
    reject("friction",
           "so small that the tangential forces do not lift the " + std::string(setup.pair.body->name()) +
               " out of contact",
           text(friction));
  }
  if (setup.load_case.load) require_depth(setup.pair, *setup.load_case.load, penetration - setup.pair.centrifugal);
}

void require_reachable_drive(const ContactSetup& setup, const ContactProblem& problem) {
  if (!problem.friction) return;
  const LoadCase& load_case = setup.load_case;
  const GivenMotion given = given_motion(load_case);
  if (given.creepage) return;
  const RoundBody& body = *setup.pair.body;
  std::array<SlidingDrive, 2> limits{};
  try {
    limits = sliding_drives(setup, problem);
  } catch (const ConvergenceError&) {
    if (!load_case.load) return;
    // Bounds instead of solutions: the moment arms of friction and of pressure are at most the radius, and the slope of
    // the counterbody is at most 1.
    const double largest = (load_case.friction + 2.0) * *load_case.load;
    limits = {SlidingDrive{-largest, -largest * body.radius()}, SlidingDrive{largest, largest * body.radius()}};
  }
  const auto& [skidding, spinning] = limits;
  const DriveReport report = drive_report(load_case, body);
  const auto [least, most] =
      given.force ? std::minmax(skidding.force, spinning.force) : std::minmax(skidding.moment, spinning.moment);
  require_between(report, given.force ? *given.force : *given.torque, least, most, body);
}

}  // namespace viscoroll::detail

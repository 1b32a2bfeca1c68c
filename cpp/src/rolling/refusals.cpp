#include "rolling/refusals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "contact/multilevel.hpp"
#include "rolling/contact_estimate.hpp"
#include "rolling/drives.hpp"
#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kMostNodes = 25000000;  // of a window: some ten gigabytes

/// Layer that relaxes most, and the ratio of its relaxed modulus to that at the frequency of passing the contact.
struct Relaxation {
  std::string layer;
  double modulus;  ///< relaxed [Pa]
  double share;
};

Relaxation strongest_relaxation(const RollingPair& pair, double frequency) {
  const std::array frequencies{0.0, frequency};
  Relaxation strongest{.layer = "", .modulus = 0.0, .share = 2.0};
  for (const auto& [name, layer] : layers(pair)) {
    const auto moduli = complex_modulus(layer.shear_modulus, frequencies);
    const double share = moduli.front().real() / std::abs(moduli.back());
    if (share < strongest.share) strongest = {.layer = name, .modulus = moduli.front().real(), .share = share};
  }
  return strongest;
}

/// Drive of a body that slides as a whole.
struct Sliding {
  double force;   ///< on the center [N]
  double moment;  ///< about the center [N m]
};

/// Drives of a body that skids (creepage 1) and of a body that spins in place (creepage -1).
std::array<Sliding, 2> sliding(const Assembly& assembly, ContactProblem problem) {
  std::array<Sliding, 2> found{};
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    problem.friction->drive = std::make_shared<GivenCreepage>(side == 0 ? 1.0 : -1.0);
    const auto [held, contact] = solve_multilevel(problem, assembly.likely_depth(), assembly.limits);
    const ContactState state{*held.surface, held.friction->arms, contact.force, own_displacement(contact)};
    found[side] = {.force = pushback(state).force - contact.force.col(kForward).sum(),
                   .moment = moment_about_center(state, assembly.pressure_share())};
  }
  return found;
}

/// @param[in] least,most limits between which the body rolls without sliding permanently
void require_between(const std::string& name, double given, double least, double most, const RoundBody& body,
                     std::string_view unit) {
  if (given > least && given < most) return;
  const auto in_units = [unit](const std::string& number) { return number + " " + std::string(unit); };
  reject(name,
         "between " + in_units(rounded(least)) + " and " + in_units(rounded(most)) + ", otherwise the " +
             std::string(body.name()) + " slides without end",
         in_units(text(given)));
}

}  // namespace

void reject_load(const RollingPair& pair, double load, const std::string& reason) {
  reject("load", "small enough for the coating",
         text(load) + " " + std::string(pair.body->form().load_unit) + " (the " + std::string(pair.body->name()) + " " +
             reason + ")");
}

void reject_contact_over_60_degrees(const RollingPair& pair, double load) {
  reject_load(pair, load, "is in contact beyond 60 degrees to either side");
}

void require_depth(const RollingPair& pair, double load, double depth) {
  const double most = thickness(pair);
  if (!(depth < most)) {
    reject_load(pair, load, "is pressed " + rounded(depth) + " m into a coating of thickness " + text(most) + " m");
  }
}

void require_formulation(const MeshModel& model, const Options& options) {
  model.pair.body->require(options);
  if (!model.counterpart) return;
  const std::string why = " if the counterbody deforms";
  if (options.compliance == Compliance::vertical) reject("compliance", "RADIAL" + why, "VERTICAL");
  if (options.patch_load != PatchLoad::flat) reject("patch_load", "FLAT" + why, "SPHERICAL");
}

void require_bearable_load(const MeshModel& model, double load) {
  if (load <= unbearable_load(model.pair, model.stiffest_modulus)) return;
  reject_load(model.pair, load, "would be pressed through any coating of this stiffness");
}

void require_lasting_stiffness(const Assembly& assembly) {
  constexpr double kLeastShare = 3e-3;  // below this ratio, the sets of nodes in contact do not settle
  const double passing =
      assembly.load_case.angular_speed * std::max(1.0, assembly.nodes.grid.radius / assembly.contact.along);
  const Relaxation relaxation = strongest_relaxation(assembly.pair(), passing);
  if (relaxation.share >= kLeastShare) return;
  reject(relaxation.layer + ".shear_modulus",
         "such that the relaxed modulus is at least " + text(kLeastShare) +
             " of the modulus at the frequency of passing the contact",
         "a relaxed modulus of " + rounded(relaxation.modulus) + " Pa, a fraction of " + rounded(relaxation.share));
}

void require_few_nodes(const Window& window, const Mesh& mesh) {
  const double nodes = static_cast<double>(window.phi.count()) * static_cast<double>(window.theta.count());
  if (nodes <= kMostNodes) return;
  throw MeshTooFine(mesh.nodes_per_revolution, std::to_string(kMostNodes) + " nodes around the contact",
                    text(nodes) + " nodes");
}

void require_contact(const Assembly& assembly, double friction, double penetration) {
  if (!std::isfinite(penetration)) throw ConvergenceError("the contact equations have no finite solution", 0, 1.0);
  if (assembly.approach_exists() && !(penetration > 0.0)) {
    if (friction == 0.0) {
      assembly.pair().body->require_stiffness();
      assembly.pair().on->require_stiffness();
      // No other cause is possible; such a wide contact is outside the validity of the equations.
      reject_load(assembly.pair(), assembly.load_case.load, "would be pressed through the coating");
    }
    reject("friction",
           "so small that the tangential forces do not lift the " + std::string(assembly.pair().body->name()) +
               " out of contact",
           text(friction));
  }
  require_depth(assembly.pair(), assembly.load_case.load, penetration - assembly.model.centrifugal);
}

void require_reachable_drive(const Assembly& assembly, const ContactProblem& problem) {
  if (!problem.friction) return;
  const LoadCase& load_case = assembly.load_case;
  const GivenMotion given = given_motion(load_case.drive);
  if (given.creepage) return;
  const RoundBody& body = *assembly.pair().body;
  std::array<Sliding, 2> limits{};
  try {
    limits = sliding(assembly, problem);
  } catch (const ConvergenceError&) {
    // The moment arms of friction, and of the pressure about the center, are at most the radius, and so is the slope of
    // the counterbody times the radius.
    const double largest = (load_case.friction + 2.0) * load_case.load;
    limits = {Sliding{-largest, -largest * body.radius()}, Sliding{largest, largest * body.radius()}};
  }
  const auto& [skidding, spinning] = limits;
  if (given.force) {
    const auto [least, most] = std::minmax(skidding.force, spinning.force);
    require_between("drive.force", *given.force, least, most, body, body.form().load_unit);
  }
  if (given.torque) {
    const auto [least, most] = std::minmax(skidding.moment, spinning.moment);
    require_between("drive.torque", *given.torque, least, most, body, body.form().torque_unit);
  }
}

}  // namespace viscoroll::detail

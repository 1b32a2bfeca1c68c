#include "rolling/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/validate.hpp"
#include "rolling/adhesion.hpp"
#include "rolling/edge_works.hpp"
#include "rolling/result.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll::detail {
namespace {

constexpr int kMinNodesAcross = 10;        // with 5, the paper's example has an error of 14 % but an estimate of 1 %
constexpr double kLargestEstimate = 0.05;  // largest error estimate of a useful mesh
constexpr double kLargestPressureError = 0.1;  // a smooth pressure has 0.08 with ten nodes across the contact
constexpr double kLargestStrain = 0.2;  // no finite-strain computation supports the model error beyond this strain

/// Lines of nodes that cross the contact, in the direction with fewer of them.
int nodes_across(const Result& result) {
  const auto columns = static_cast<std::size_t>(result.theta_nodes);
  std::vector<bool> rows_touched(static_cast<std::size_t>(result.phi_nodes));
  std::vector<bool> columns_touched(columns);
  for (std::size_t node = 0; node < result.contact.size(); ++node) {
    if (result.contact[node] == 0) continue;
    rows_touched[node / columns] = true;
    columns_touched[node % columns] = true;
  }
  const auto along = std::count(rows_touched.begin(), rows_touched.end(), true);
  if (columns == 1) return static_cast<int>(along);  // line contact
  return static_cast<int>(std::min(along, std::count(columns_touched.begin(), columns_touched.end(), true)));
}

/// Text that names every layer with terms that do not relax at this speed, empty if there is none.
std::string slow_terms_text(const PairAtSpeed& pair) {
  std::string message;
  for (const auto& [name, layer] : layers(pair)) {
    const auto slow = slow_terms(layer.shear_modulus, pair.angular_speed);
    if (!slow) continue;
    message += (message.empty() ? "" : "; ") + name + ".shear_modulus has " + std::to_string(slow->count) +
               (slow->count == 1 ? " term" : " terms") + " with a relaxation time of at least " +
               rounded(slow->shortest_time) + " s, too slow to relax at this speed: " + rounded(slow->modulus) +
               " of the " + rounded(slow->modulus_at_rest) + " Pa of the modulus at rest belong to " +
               (slow->count == 1 ? "it" : "them");
  }
  return message;
}

std::string coarse_mesh_text(int across, double estimate) {
  return "the mesh is too coarse: " + std::to_string(across) + " nodes across the contact (recommended: at least " +
         std::to_string(kMinNodesAcross) + "), error estimate " + rounded(estimate) + " (recommended: at most " +
         rounded(kLargestEstimate) + "); refine the mesh or leave it out";
}

std::string long_zone_text(double relative_zone) {
  return "the mesh is too coarse for adhesion: its cohesive zones are " + rounded(relative_zone) +
         " times as long as the smaller of the half-width of the contact and the thickness of the outermost layer "
         "(recommended: at most " +
         rounded(kLongestZone) +
         "); the error estimate does not contain this error; refine the mesh or request a smaller accuracy";
}

std::string moments_of_edges_text(const Result& result) {
  return "the relative error of the power balance is " + rounded(result.energy_balance_error) +
         " (recommended: at most " + rounded(kLargestEstimate) +
         "): the moments of both edges almost cancel in resisting_torque; rolling_resistance_torque, which follows "
         "from the dissipated power, is more accurate";
}

std::string power_balance_text(const Result& result) {
  return "the relative error of the power balance is " + rounded(result.energy_balance_error) +
         " (recommended: at most " + rounded(kLargestEstimate) + "), for a rolling resistance coefficient of " +
         rounded(result.rolling_resistance_coefficient) + "; refine the mesh or leave it out";
}

std::string pressure_peak_text(const Result& result, double good) {
  return "the relative error estimate of the largest pressure is " + rounded(result.max_pressure_error) +
         " (recommended: at most " + rounded(good) +
         "): the nodes do not resolve the peak, for example if material enters the contact faster than it "
         "relaxes; torque and penetration do not depend on the peak";
}

/// Warnings about both bodies, each kind once.
std::vector<Warning> warnings_of_bodies(const RollingPair& pair, const ContactReach& reach) {
  const auto& [body, on] = pair;
  std::vector<Warning> warnings = body->warnings(reach, !on->is_rigid());
  for (Warning& warning : on->warnings(reach, !body->is_rigid())) {
    if (std::ranges::find(warnings, warning.kind, &Warning::kind) == warnings.end()) {
      warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

}  // namespace

std::vector<Warning> warnings_of(const Result& result, const RollingCase& given, bool mesh_given) {
  const Options& options = given.options;
  std::vector<Warning> warnings =
      warnings_of_bodies(given.pair, reach_of_patches(result, nodes_of(given.pair, result.mesh).grid));
  if (result.status == Status::max_iterations) {
    warnings.push_back(
        {WarningKind::max_iterations,
         "the contact still changed after " + std::to_string(options.max_iterations) + " iterations (max_iterations)"});
  }
  if (result.status == Status::accuracy_not_reached) {
    warnings.push_back({WarningKind::accuracy_not_reached, "the error estimate is " + rounded(result.error_estimate) +
                                                               ", above the requested accuracy of " +
                                                               rounded(options.accuracy)});
  }
  const int across = nodes_across(result);
  const double zone = given.load_case.adhesion ? relative_zone(given, result) : 0.0;
  if (mesh_given && across < kMinNodesAcross) {
    warnings.push_back({WarningKind::coarse_mesh, coarse_mesh_text(across, result.error_estimate)});
  } else if (zone > kLongestZone) {
    warnings.push_back({WarningKind::coarse_mesh, long_zone_text(zone)});
  } else if (given.load_case.adhesion && !(result.energy_balance_error <= kLargestEstimate)) {
    warnings.push_back({WarningKind::power_balance, moments_of_edges_text(result)});
  } else if (mesh_given && !(result.energy_balance_error <= kLargestEstimate)) {
    warnings.push_back({WarningKind::power_balance, power_balance_text(result)});
  }
  const double good = mesh_given ? kLargestPressureError : options.accuracy;
  if (across >= kMinNodesAcross && !(result.max_pressure_error <= good)) {
    warnings.push_back({WarningKind::pressure_peak, pressure_peak_text(result, good)});
  }
  if (result.strain && *result.strain > kLargestStrain) {
    warnings.push_back({WarningKind::large_strain, "the strain, penetration / coating thickness, is " +
                                                       rounded(*result.strain) + " (recommended: at most " +
                                                       rounded(kLargestStrain) +
                                                       "): linear theory may have a relative error of " +
                                                       rounded(*result.model_error) + " in the torque"});
  }
  if (const std::string message = slow_terms_text(given.pair); !message.empty()) {
    warnings.push_back({WarningKind::slow_terms, message});
  }
  return warnings;
}

}  // namespace viscoroll::detail

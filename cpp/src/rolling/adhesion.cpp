#include "rolling/adhesion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <vector>

#include "base/validate.hpp"
#include "rolling/adhesion_estimate.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll {

void validate(const Adhesion& adhesion) {
  detail::require_positive("work", adhesion.work, "J/m^2");
  if (adhesion.strength) detail::require_positive("strength", *adhesion.strength, "Pa");
  if (adhesion.range) {
    detail::require_positive("range", *adhesion.range, "m");
    if (adhesion.strength) {
      detail::reject("range", "left out if the strength is given", detail::text(*adhesion.range) + " m");
    }
  }
  if (adhesion.separation_work) {
    detail::require_positive("separation_work", *adhesion.separation_work, "J/m^2");
    if (*adhesion.separation_work < adhesion.work) {
      detail::reject("separation_work", "at least the work of adhesion, " + detail::text(adhesion.work) + " J/m^2",
                     *adhesion.separation_work);
    }
  }
}

}  // namespace viscoroll

namespace viscoroll::detail {
namespace {

double strength_of(const Adhesion& adhesion) {
  if (adhesion.strength) return *adhesion.strength;
  return adhesion.range ? 3.0 * adhesion.work / *adhesion.range : std::numeric_limits<double>::infinity();
}

/// Quantities from which the works at the edges follow.
struct Edges {
  EdgeCreep creep;
  SurfaceAdhesion surfaces;
  double speed;  ///< of rolling [m/s]

  [[nodiscard]] EdgeIntensities intensities(double fraction) const {
    return edge_intensities(creep, surfaces, fraction * speed);
  }
};

double speed_of(const PairAtSpeed& pair) { return pair.angular_speed * pair.body->radius(); }

/// Whether the outermost layers of both bodies are solids. A Prony series without a modulus at rest rolls as a solid if
/// its slowest terms do not relax (`slow_terms.hpp`), but has no creep compliance at rest.
bool are_solids(const PairAtSpeed& pair) {
  constexpr double kRoundOff = 1e-9;
  return std::ranges::all_of(std::array<const Body*, 2>{pair.body.get(), pair.on.get()}, [&](const Body* body) {
    if (body->is_rigid()) return true;
    const auto slow = slow_terms(body->layers().back().layer.shear_modulus, pair.angular_speed);
    return !slow || slow->modulus < (1.0 - kRoundOff) * slow->modulus_at_rest;
  });
}

/// Creep at the edges, in the times that material takes to pass a millionth of the contact, up to the whole contact.
EdgeCreep creep_at_edges(const RollingCase& given) {
  constexpr double kShortest = 1e-6;
  const double passage = 2.0 * given.contact.along / speed_of(given.pair);
  return edge_creep(given.pair, {.shortest = kShortest * passage, .longest = passage});
}

Edges edges_of(const RollingCase& given) {
  const Adhesion& adhesion = *given.load_case.adhesion;
  return {.creep = creep_at_edges(given),
          .surfaces = {.separation_work = adhesion.separation_work.value_or(adhesion.work),
                       .bonding_work = adhesion.work,
                       .strength = strength_of(adhesion)},
          .speed = speed_of(given.pair)};
}

}  // namespace

void require_adhesion(const RollingPair& pair, const LoadCase& load_case) {
  if (!load_case.adhesion) {
    if (load_case.pulls_off) reject("adhesion", "given for the largest tension", "none");
    return;
  }
  try {
    viscoroll::validate(*load_case.adhesion);
  } catch (const InvalidInput& error) {
    throw error.inside("adhesion");
  }
  if (load_case.friction != 0.0) {
    reject("friction", "0 with adhesion: the strength of an adhesive contact under shear is not known",
           load_case.friction);
  }
  if (std::isfinite(width(pair))) {
    reject("adhesion", "left out for bodies with side faces, whose edges would detach first", "an adhesion");
  }
}

std::optional<double> clean_adhesion_increase(const RollingCase& given, const Result& result) {
  constexpr Adhesion kClean{.work = 0.05, .range = 1e-9};
  constexpr double kSmallest = 0.01;
  const double torque = result.rolling_resistance_torque;
  if (given.load_case.adhesion || !(torque > 0.0)) return std::nullopt;
  if (std::isfinite(width(given.pair)) || !are_solids(given.pair)) return std::nullopt;
  const double added = adhesion_torque_estimate(
      creep_at_edges(given),
      {.separation_work = kClean.work, .bonding_work = kClean.work, .strength = strength_of(kClean)},
      {.half_length = 0.5 * result.contact_length,
       .width = result.contact_width.value_or(1.0),
       .radius = given.pair.body->radius(),
       .speed = speed_of(given.pair)});
  return added < kSmallest * torque ? std::nullopt : std::optional(added / torque);
}

EdgeReleases releases_at_edges(const RollingCase& given) {
  const Edges edges = edges_of(given);
  const double relaxed = edges.creep.relaxed();
  const EdgeIntensities intensities = edges.intensities(1.0);
  return {.opening = 0.5 * std::pow(intensities.opening, 2) * relaxed,
          .closing = 0.5 * std::pow(intensities.closing, 2) / relaxed,
          .shorter_zone = std::min(intensities.opening_zone, intensities.closing_zone)};
}

double node_spacing(const SurfaceGrid& grid, bool is_line) {
  return grid.radius * (is_line ? grid.phi_spacing : std::max(grid.phi_spacing, grid.theta_spacing));
}

double relative_zone(const RollingCase& given, const Result& result) {
  const bool is_line = result.theta_nodes == 1;
  const double zone = *result.cohesive_zone_nodes * node_spacing(nodes_of(given.pair, result.mesh).grid, is_line);
  if (releases_at_edges(given).shorter_zone >= zone) return 0.0;
  double shortest = 0.5 * std::min(result.contact_length, result.contact_width.value_or(result.contact_length));
  for (const Body* body : std::array<const Body*, 2>{given.pair.body.get(), given.pair.on.get()}) {
    if (!body->is_rigid()) shortest = std::min(shortest, body->layers().back().layer.thickness);
  }
  return zone / shortest;
}

Attraction attraction_at(const RollingCase& given, const SurfaceWindow& window) {
  const SurfaceGrid& grid = window.grid();
  const bool is_line = window.window().is_line();
  const Edges edges = edges_of(given);
  std::vector<Eigen::Index> every(static_cast<std::size_t>(window.shape().size()));
  std::iota(every.begin(), every.end(), Eigen::Index{0});
  // The normal of an ellipse with the semi-axes a and b at (x, z) has the direction (x, z (a / b)^2).
  const double aspect = is_line ? 1.0 : std::pow(given.contact.along / given.contact.across, 2);
  return {.equivalent_load = given.equivalent_load,
          .spacing = node_spacing(grid, is_line),
          .shortest_zone = given.shortest_zone,
          .x = window.x(),
          .z = aspect * window.z(),
          .area = window.patch_area(every),
          .laws = [edges, known = std::make_shared<std::map<double, EdgeIntensities>>()](double zone, double fraction,
                                                                                         const ContactSize& contact) {
            auto place = known->find(fraction);
            if (place == known->end()) place = known->emplace(fraction, edges.intensities(fraction)).first;
            return edge_laws(edges.creep, edges.surfaces, place->second, zone, fraction * edges.speed, contact);
          }};
}

}  // namespace viscoroll::detail

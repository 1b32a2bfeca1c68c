#include "transient/creeping_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "modal/spectrum.hpp"
#include "validate.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

CreepSpectrum checked_spectrum(const Body& body, std::string_view prefix, const HistoryOptions& options) {
  CreepSpectrum spectrum =
      common_spectrum(body.layers, prefix, {.shortest = options.shortest_time, .longest = options.longest_time});
  if (spectrum.error > options.spectrum_tolerance) {
    reject(std::string(prefix) + body.layers.back().name + ".shear_modulus",
           "one that discrete retardation times with weights >= 0 stand for within spectrum_tolerance = " +
               text(options.spectrum_tolerance),
           "one that they miss by " + rounded(spectrum.error));
  }
  return spectrum;
}

/// Rows around the one of two bodies; a body that turns beside another one need not have a whole number of them, and is
/// taken to be that much larger or smaller.
std::optional<Index> ring_of(const Body& body, const SurfaceGrid& grid) {
  if (body.radius == 0.0) return std::nullopt;
  const double distance = grid.radius * grid.phi_spacing;
  return std::lround(2.0 * std::numbers::pi * body.radius / distance);
}

/// Rows that tables may reach: the waves of some 500 low orders take 256 MB of them while they are summed.
constexpr Index kLongestTrack = 32768;

/// On a plane, which has no radius of its own, the mesh may be that of a larger body with the same nodes: sums are good
/// within a quarter of its revolution (theory.md section 15). The datum of a half-plane depends on it: along a line it
/// is the same for all reaches, so that tables can be made longer.
Crossing on_track(Crossing crossing, Index reach) {
  if (crossing.form.is_line()) reach = kLongestTrack;
  const auto nodes = static_cast<Index>(crossing.mesh.nodes_per_revolution);
  const auto times = static_cast<int>(std::max<Index>(1, (4 * reach + nodes - 1) / nodes));
  crossing.angular_speed /= times;
  crossing.radius *= times;
  crossing.mesh.nodes_per_revolution *= times;
  if (auto& across = crossing.mesh.theta_nodes_per_revolution) *across *= times;
  crossing.theta_spacing /= times;
  crossing.widest /= times;
  return crossing;
}

}  // namespace

Index CreepingPair::most_track_reach() const {
  constexpr Index kMostValues = 16777216;  // of a table: 128 MB
  const Index height = bodies.front().tables.height();
  return std::min(kMostValues / (height * height), kLongestTrack);
}

bool CreepingPair::ends_at_sides() const {
  return half_nodes() == most_half_nodes() && (pair.body.form.is_line() || std::isfinite(width(pair)));
}

std::vector<BodySpectrum> creep_spectra(const RollingPair& pair, const HistoryOptions& options) {
  std::vector<BodySpectrum> spectra;
  const auto append = [&](const Body& body, bool rolls, std::string_view prefix) {
    if (!body.is_rigid()) spectra.push_back({.rolls = rolls, .spectrum = checked_spectrum(body, prefix, options)});
  };
  append(pair.body, true, "");
  append(pair.on, false, "on.");
  return spectra;
}

double inertia_of(const RollingPair& pair, const std::vector<BodySpectrum>& spectra) {
  double inertia = 0.0;
  for (const auto& [rolls, spectrum] : spectra) {
    for (const auto& [name, layer] : (rolls ? pair.body : pair.on).layers) {
      const double relaxed = complex_modulus(layer.shear_modulus, std::array{0.0}).front().real();
      inertia = std::max(inertia, layer.density * std::pow(pair.body.radius, 2) * spectrum.instantaneous / relaxed);
    }
  }
  return inertia;
}

void require_followed(const RollingPair& pair, const HistoryOptions& options) {
  const bool is_on_rigid_plane =
      pair.body.type == "CoatedSphere" && pair.on.type == "CoatedPlane" && pair.on.is_rigid();
  if (is_on_rigid_plane) return;
  if (options.friction > 0.0) {
    reject("friction", "0 in transient rolling, but for a ball on the rigid plane", options.friction);
  }
  if (options.compliance != Compliance::radial) {
    reject("compliance", "RADIAL in transient rolling, but for a ball on the rigid plane", "VERTICAL");
  }
}

TableSize first_size(const RollingPair& at_rest, const Mesh& mesh, const ContactReach& contact) {
  constexpr double kDiesOut = 24.0;  // thicknesses, where a bonded layer has a billionth left
  const SurfaceGrid& grid = nodes_of(at_rest, mesh).grid;
  const double half_nodes = std::ceil(1.1 * contact.across / (grid.radius * grid.theta_spacing)) + 2.0;
  const double turn = 0.5 * mesh.nodes_per_revolution;  // farther only where it is rolled
  const double reach = std::min(kDiesOut * thickness(at_rest) / (grid.radius * grid.phi_spacing), turn);
  return {.half_nodes = static_cast<Index>(half_nodes), .track_reach = static_cast<Index>(std::ceil(reach))};
}

CreepingPair creeping_pair(const RollingPair& at_rest, const std::vector<BodySpectrum>& spectra,
                           const HistoryOptions& options, const TableSize& size, Watch& watch) {
  CreepingPair creeping{.pair = at_rest,
                        .nodes = nodes_of(at_rest, *options.mesh),
                        .compliance = options.compliance,
                        .friction = options.friction,
                        .driving_force = options.driving_force,
                        .mass = options.mass,
                        .track_reach = size.track_reach,
                        .bodies = {}};
  const bool along_plane = options.compliance == Compliance::vertical || options.friction > 0.0;
  RowShape shape{.components = along_plane ? 3 : 1,
                 .half_nodes = std::min(size.half_nodes, creeping.most_half_nodes()),
                 .ring = {},
                 .most = 0};
  // Of elastic layers without inertia any speed has the same tables.
  const Crossing crossing =
      crossing_of(at_rest, 1.0, *options.mesh, options.curvature, {options.threads, watch}, kInertiaTolerance);
  for (const auto& [rolls, spectrum] : spectra) {
    const Body& body = rolls ? at_rest.body : at_rest.on;
    shape.ring = ring_of(body, creeping.nodes.grid);
    shape.most = shape.ring ? *shape.ring / 2 : size.track_reach;
    const auto sum = body.table_sum(shape.ring ? crossing : on_track(crossing, shape.most));
    creeping.bodies.push_back({.rolls = rolls,
                               .spectrum = spectrum,
                               .ring = shape.ring,
                               .tables = MirroredTables(*sum, shape, options.threads, watch)});
  }
  return creeping;
}

}  // namespace viscoroll::detail

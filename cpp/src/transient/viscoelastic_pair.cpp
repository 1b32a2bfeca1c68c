#include "transient/viscoelastic_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/validate.hpp"
#include "modal/spectrum.hpp"
#include "transient/viscoelastic_body.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

void require_instantaneous_compliance(const Body& body, std::string_view prefix, const TimeRange& range) {
  for (const auto& [name, layer] : body.layers()) {
    if (std::isfinite(short_time_modulus(layer.shear_modulus, 1.0 / range.shortest))) continue;
    reject(
        std::string(prefix) + name + ".shear_modulus",
        "a material with instantaneous compliance in transient rolling if the layers have dissimilar creep functions",
        "KelvinVoigt, which has none");
  }
}

/// Spectrum of layers with different relaxation functions.
BodySpectrum layer_spectrum(LayeredBody body, const HistoryOptions& options, const TimeRange& range) {
  auto layers = std::make_shared<const LayerSpectrum>(std::move(body), range, options.spectrum_tolerance);
  const auto& times = layers->retardation_times();
  CreepSpectrum each{.weights = std::vector(times.size(), 1.0), .retardation_times = times};
  each.error = layers->error(range);
  return {.spectrum = std::move(each), .layers = std::move(layers)};
}

BodySpectrum checked_spectrum(const Body& body, std::string_view prefix, const ContactKinematics& kinematics,
                              const HistoryOptions& options) {
  const TimeRange range{.shortest = options.shortest_time, .longest = options.longest_time};
  BodySpectrum result;
  if (creep_identically(body.layers(), range)) {
    result.spectrum = creep_spectrum(body.layers().back().layer.shear_modulus, range);
  } else {
    require_instantaneous_compliance(body, prefix, range);
    result = layer_spectrum(body.layered(kinematics), options, range);
  }
  if (result.spectrum.error > options.spectrum_tolerance) {
    reject(std::string(prefix) + body.layers().back().name + ".shear_modulus",
           "such that discrete retardation times represent its creep within spectrum_tolerance = " +
               text(options.spectrum_tolerance),
           "a material with an error of " + rounded(result.spectrum.error));
  }
  return result;
}

/// Elastic layers without inertia have the same tables at any speed.
ContactKinematics kinematics_at_rest(const RollingPair& pair, const HistoryOptions& options, Watch& watch) {
  constexpr double kAnySpeed = 1.0;
  return kinematics_of(pair, kAnySpeed, *options.mesh, options.curvature, {options.threads, watch}, {});
}

/// Number of rows around one of the two bodies. A body that turns beside another one need not have a whole number of
/// rows; it is modeled as if it were slightly larger or smaller.
std::optional<Index> ring_of(const Body& body, const SurfaceGrid& grid) {
  if (body.radius() == 0.0) return std::nullopt;
  const double distance = grid.radius * grid.phi_spacing;
  return std::lround(2.0 * std::numbers::pi * body.radius() / distance);
}

/// Largest reach of tables in rows: while they are summed, the waves of some 500 low orders take 256 MB.
constexpr Index kLongestTrack = 32768;

/// A plane has no radius of its own, so that its mesh may be that of a larger body with the same nodes; sums are
/// accurate within a quarter of the revolution of that body (docs/theory/planes-and-pairs.md). The datum of a
/// half-plane depends on this revolution. In line contact it is therefore the same for all reaches, so that tables can
/// be extended.
ContactKinematics on_track(ContactKinematics kinematics, Index reach) {
  if (kinematics.form.is_line()) reach = kLongestTrack;
  const auto nodes = static_cast<Index>(kinematics.mesh.nodes_per_revolution);
  const auto times = static_cast<int>(std::max<Index>(1, (4 * reach + nodes - 1) / nodes));
  kinematics.angular_speed /= times;
  kinematics.radius *= times;
  kinematics.mesh.nodes_per_revolution *= times;
  if (auto& across = kinematics.mesh.theta_nodes_per_revolution) *across *= times;
  kinematics.theta_spacing /= times;
  kinematics.widest /= times;
  return kinematics;
}

}  // namespace

Index ViscoelasticPair::max_track_reach() const {
  constexpr Index kMaxValues = 16777216;  // of a table: 128 MB
  const Index height = bodies.front().tables.height();
  return std::min(kMaxValues / (height * height), kLongestTrack);
}

bool ViscoelasticPair::ends_at_sides() const {
  return half_nodes() == max_half_nodes() && (pair.body->form().is_line() || std::isfinite(width(pair)));
}

std::vector<BodySpectrum> creep_spectra(const RollingPair& pair, const HistoryOptions& options, Watch& watch) {
  const ContactKinematics kinematics = kinematics_at_rest(pair, options, watch);
  std::vector<BodySpectrum> spectra;
  const auto append = [&](const Body& body, bool rolls, std::string_view prefix) {
    if (body.is_rigid()) return;
    spectra.push_back(checked_spectrum(body, prefix, kinematics, options));
    spectra.back().rolls = rolls;
  };
  append(*pair.body, true, "");
  append(*pair.on, false, "on.");
  return spectra;
}

double inertia_of(const RollingPair& pair, const std::vector<BodySpectrum>& spectra) {
  double inertia = 0.0;
  for (const auto& [rolls, spectrum, layered] : spectra) {
    const auto& layers = (rolls ? *pair.body : *pair.on).layers();
    for (std::size_t l = 0; l < layers.size(); ++l) {
      const Layer& layer = layers[l].layer;
      const double at_once =
          layered ? layered->moduli()[l].instantaneous()
                  : complex_modulus(layer.shear_modulus, std::array{0.0}).front().real() / spectrum.instantaneous;
      inertia = std::max(inertia, layer.density * std::pow(pair.body->radius(), 2) / at_once);
    }
  }
  return inertia;
}

void require_supported_options(const RollingPair& pair, const HistoryOptions& options) {
  const bool is_ball = !pair.body->form().is_line() && std::isinf(width(pair));
  const bool is_on_rigid_plane = pair.on->is_rigid() && pair.on->curvatures() == Curvatures{};
  if (options.mass > 0.0 && pair.on->curvatures().along != 0.0) {
    reject("mass",
           "0 kg on a counterbody that is curved along the path, where center and contact move different distances",
           text(options.mass) + " kg");
  }
  if (!approach_exists(pair) && options.axle) {
    reject("axle", "left out in line contact on a half-space, where the penetration is undetermined", "an axle");
  }
  if (options.compliance != Compliance::radial && !(is_ball && is_on_rigid_plane)) {
    reject("compliance", "RADIAL in transient rolling, except for a ball on the rigid plane", "VERTICAL");
  }
}

TableSize first_size(const RollingPair& at_rest, const Mesh& mesh, const ContactReach& contact) {
  constexpr double kDiesOut = 24.0;  // thicknesses at which the influence of a bonded layer has fallen to 1e-9
  const SurfaceGrid& grid = nodes_of(at_rest, mesh).grid;
  const double half_nodes = std::ceil(1.1 * contact.across / (grid.radius * grid.theta_spacing)) + 2.0;
  const double turn = 0.5 * mesh.nodes_per_revolution;  // extended only if the body rolls farther
  const double reach = std::min(kDiesOut * thickness(at_rest) / (grid.radius * grid.phi_spacing), turn);
  return {.half_nodes = static_cast<Index>(half_nodes), .track_reach = static_cast<Index>(std::ceil(reach))};
}

ViscoelasticPair viscoelastic_pair(const RollingPair& at_rest, const std::vector<BodySpectrum>& spectra,
                                   const HistoryOptions& options, const TableSize& size, Watch& watch) {
  const Nodes nodes = nodes_of(at_rest, *options.mesh);
  ViscoelasticPair creeping{.pair = at_rest,
                            .nodes = nodes,
                            .compliance = options.compliance,
                            .friction = options.friction,
                            .driving_force = options.driving_force,
                            .driving_torque = options.driving_torque,
                            .mass = options.mass,
                            .axle = options.axle,
                            .heights = SurfaceHeights(options, nodes.grid),
                            .track_reach = size.track_reach,
                            .bodies = {}};
  const bool along_plane = options.compliance == Compliance::vertical || options.friction > 0.0;
  RowShape shape{.components = along_plane ? 3 : 1,
                 .half_nodes = std::min(size.half_nodes, creeping.max_half_nodes()),
                 .ring = {},
                 .most = 0};
  const ContactKinematics kinematics = kinematics_at_rest(at_rest, options, watch);
  for (const BodySpectrum& spectrum : spectra) {
    const Body& body = spectrum.rolls ? *at_rest.body : *at_rest.on;
    shape.ring = ring_of(body, creeping.nodes.grid);
    shape.most = shape.ring ? *shape.ring / 2 : size.track_reach;
    creeping.bodies.push_back({.rolls = spectrum.rolls,
                               .spectrum = spectrum.spectrum,
                               .ring = shape.ring,
                               .tables = tables_of(body, spectrum.layers.get(),
                                                   shape.ring ? kinematics : on_track(kinematics, shape.most), shape)});
  }
  return creeping;
}

}  // namespace viscoroll::detail

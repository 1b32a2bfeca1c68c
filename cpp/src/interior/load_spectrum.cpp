#include "interior/load_spectrum.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/validate.hpp"
#include "influence/waves.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll {

Tractions tractions_of(const RollingBody& body, const Result& result, const LoadCase& load_case,
                       const Options& options) {
  const double radius = std::visit([](const auto& shape) { return outer_radius(shape); }, body);
  const auto* wheel = std::get_if<CoatedWheel>(&body);
  std::optional<double> theta_spacing;
  if (wheel != nullptr && result.theta_nodes > 1) theta_spacing = std::abs(result.z[1] - result.z[0]) / radius;
  return {.mesh = result.mesh,
          .radius = radius,
          .theta_spacing = theta_spacing,
          .crown_radius = wheel != nullptr ? std::optional(wheel->crown_radius) : std::nullopt,
          .line = std::holds_alternative<CoatedCylinder>(body),
          .phi_nodes = result.phi_nodes,
          .theta_nodes = result.theta_nodes,
          .pressure = result.pressure,
          .shear_traction = result.shear_traction,
          .friction = load_case.friction > 0.0,
          .compliance = options.compliance,
          .curvature = options.curvature,
          .patch_load = options.patch_load};
}

namespace detail {
namespace {

using cplx = std::complex<double>;
using Eigen::ArrayXd;
using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kMaxColumns = 2.0 * kMaxNodesPerRevolution;  // two revolutions

/// Forces on the rolling body along x, y and z [N].
VectorField nodal_forces(const Tractions& tractions, const SurfaceWindow& window) {
  const SurfaceGrid& grid = window.grid();
  ArrayXd area =
      ArrayXd::Constant(window.shape().size(), grid.radius * grid.radius * grid.phi_spacing * grid.theta_spacing);
  if (tractions.patch_load == PatchLoad::spherical) area *= window.theta().sin();
  const auto field = [&](const std::vector<double>& values, Index part) {
    return Eigen::Map<const ArrayXd>(values.data() + part * area.size(), area.size());
  };
  VectorField force(area.size(), 3);
  force.col(kForward) = area * field(tractions.shear_traction, 0);
  force.col(kDown) = -area * field(tractions.pressure, 0);
  force.col(kSideways) = area * field(tractions.shear_traction, 1);
  return force;
}

/// Contribution of patches at the columns theta to orders n: real parts that are even and odd in n, the odd one times
/// -i.
struct ThetaWaves {
  RowMajor even;  // nodes by orders
  RowMajor odd;
};

ThetaWaves theta_waves(const NodeRange& range, double spacing, const ArrayXd& n, int shape) {
  ThetaWaves waves{.even = RowMajor(range.count(), n.size()), .odd = RowMajor(range.count(), n.size())};
  for (Index j = 0; j < n.size(); ++j) {
    const double bessel = spherical_bessel(shape, 0.5 * n[j] * spacing);
    for (int k = range.first; k <= range.last; ++k) {
      const double angle = n[j] * k * spacing;
      // (-i)^p j_p e^{-i n theta}, split into even and odd part
      const double cosine = bessel * std::cos(angle);
      const double sine = bessel * std::sin(angle);
      waves.even(k - range.first, j) = shape == 0 ? cosine : shape == 1 ? -sine : -cosine;
      waves.odd(k - range.first, j) = shape == 0 ? sine : shape == 1 ? cosine : -sine;
    }
  }
  return waves;
}

/// Transform from rows phi to orders m: sinc(m Delta / 2) e^{-i m phi}.
Eigen::MatrixXcd phi_waves(const NodeRange& range, double spacing, const ArrayXd& m) {
  Eigen::MatrixXcd waves(m.size(), range.count());
  for (int i = range.first; i <= range.last; ++i) {
    for (Index j = 0; j < m.size(); ++j) {
      waves(j, i - range.first) = std::polar(sinc(0.5 * m[j] * spacing), -m[j] * i * spacing);
    }
  }
  return waves;
}

}  // namespace

SurfaceGrid grid_of(const Tractions& tractions, double radius) {
  const double turns = tractions.radius / radius;
  const double theta = tractions.theta_spacing.value_or(theta_spacing(tractions.mesh));
  return {.radius = radius,
          .phi_spacing = phi_spacing(tractions.mesh) * turns,
          .theta_spacing = tractions.line ? 1.0 / radius : theta * turns,
          .crown_radius = tractions.crown_radius};
}

SurfaceWindow window_of(const Tractions& tractions, double radius) {
  const int phi = tractions.phi_nodes / 2;
  const int theta = tractions.theta_nodes / 2;
  return {grid_of(tractions, radius), {{-phi, phi}, {-theta, theta}}};
}

void validate(const Tractions& tractions) {
  viscoroll::validate(tractions.mesh);
  require_orders(tractions.curvature);
  const auto require_odd = [](const char* name, int nodes, int most, const char* which) {
    if (nodes < 1 || nodes % 2 == 0 || nodes > most) {
      reject(name, "odd and in [1, " + std::to_string(most) + "] (" + which + ")", std::to_string(nodes),
             Range{.minimum = 1.0, .maximum = static_cast<double>(most)});
    }
  };
  constexpr auto kHalf = "at most half of the nodes per revolution";
  require_odd("tractions.phi_nodes", tractions.phi_nodes, tractions.mesh.nodes_per_revolution / 2, kHalf);
  if (tractions.theta_spacing) {
    require_positive("tractions.theta_spacing", *tractions.theta_spacing, "rad");
    require_odd("tractions.theta_nodes", tractions.theta_nodes,
                static_cast<int>(std::min(4.0 * std::numbers::pi / *tractions.theta_spacing, kMaxColumns)),
                "at most two revolutions");
  } else {
    require_odd("tractions.theta_nodes", tractions.theta_nodes, theta_nodes_per_revolution(tractions.mesh) / 2, kHalf);
  }
  if (tractions.crown_radius && !(*tractions.crown_radius > 0.0)) {
    reject("tractions.crown_radius", Range{.unit = "m", .minimum = 0.0, .excludes_minimum = true},
           *tractions.crown_radius);
  }
  if (tractions.line && tractions.theta_nodes != 1) {
    reject("tractions.theta_nodes", "1 in line contact", std::to_string(tractions.theta_nodes));
  }
  require_positive("tractions.radius", tractions.radius, "m");
  for (const double curvature : tractions.counterbody_curvature) {
    require_finite("tractions.counterbody_curvature", curvature);
  }
  const auto count = static_cast<std::size_t>(tractions.phi_nodes) * static_cast<std::size_t>(tractions.theta_nodes);
  const auto require_values = [](const char* name, const std::vector<double>& values, std::size_t wanted) {
    if (values.size() != wanted) {
      reject(name, "an array of " + std::to_string(wanted) + " values", std::to_string(values.size()) + " values");
    }
    for (const double value : values) require_finite(name, value);
  };
  require_values("tractions.pressure", tractions.pressure, count);
  require_values("tractions.shear_traction", tractions.shear_traction, 2 * count);
}

LoadSpectrum::LoadSpectrum(const Tractions& tractions, const Metric& metric, const ArrayXd& m, const ArrayXd& n)
    : count_(n.size()) {
  const SurfaceWindow window = window_of(tractions, metric.radius);
  const Formulation formulation{.compliance = tractions.compliance,
                                .patch_load = tractions.patch_load,
                                .tangential = tractions.friction,
                                .is_counterbody = tractions.counterbody,
                                .counterbody_curvatures = {.along = tractions.counterbody_curvature[0],
                                                           .across = tractions.counterbody_curvature[1]}};
  const VectorField force = nodal_forces(tractions, window);
  const auto directions = load_directions(formulation, window.points());
  const auto weights = patch_weights(formulation, window.points());
  const Eigen::MatrixXcd to_m = phi_waves(window.window().phi, window.grid().phi_spacing, m);
  std::vector<ThetaWaves> to_n;
  to_n.reserve(weights.size());
  for (std::size_t shape = 0; shape < weights.size(); ++shape) {
    to_n.push_back(theta_waves(window.window().theta, window.grid().theta_spacing, n, static_cast<int>(shape)));
  }
  // The sum of all forces is this area times the stress of order (0, 0).
  const double scale = metric.radius / metric.area_of_waves();
  const cplx i(0.0, 1.0);
  for (std::size_t component = 0; component < directions.size(); ++component) {
    const auto& direction = directions[component];
    const ArrayXd load = direction[0].values() * force.col(0) + direction[1].values() * force.col(1) +
                         direction[2].values() * force.col(2);
    if ((load == 0.0).all()) continue;
    loaded_[component] = true;
    Orders even = Orders::Zero(m.size(), n.size());
    Orders odd = even;
    for (std::size_t shape = 0; shape < weights.size(); ++shape) {
      const ArrayXd weighted = weights[shape].replicate(window.shape().phi_nodes, 1) * load;
      const Eigen::Map<const RowMajor> nodes(weighted.data(), window.shape().phi_nodes, window.shape().theta_nodes);
      const Eigen::MatrixXcd rows = to_m * nodes;
      even += rows * to_n[shape].even;
      odd += rows * to_n[shape].odd;
    }
    // Real form: stresses along the surface are i times their real unknowns.
    const cplx unit = component == 0 ? cplx(scale) : -i * scale;
    const bool theta = component == 2;
    orders_[static_cast<std::size_t>(theta ? Mirror::opposite : Mirror::same)][component] = unit * even;
    orders_[static_cast<std::size_t>(theta ? Mirror::same : Mirror::opposite)][component] = -i * unit * odd;
  }
  find_present();
}

LoadSpectrum::LoadSpectrum(Stresses stresses) : orders_(std::move(stresses)) {
  for (const auto& parts : orders_) {
    for (std::size_t component = 0; component < parts.size(); ++component) {
      if (parts[component].size() == 0) continue;
      loaded_[component] = true;
      count_ = parts[component].cols();
    }
  }
  find_present();
}

void LoadSpectrum::find_present() {
  // Round-off of terms that cancel in sums over a symmetric window.
  constexpr double kRoundOff = 1e-13;
  std::array<double, 2> largest{};
  for (std::size_t mirror = 0; mirror < 2; ++mirror) {
    for (const Orders& part : orders_[mirror]) {
      if (part.size() > 0) largest[mirror] = std::max(largest[mirror], part.cwiseAbs().maxCoeff());
    }
  }
  for (std::size_t mirror = 0; mirror < 2; ++mirror) {
    present_[mirror] = largest[mirror] > kRoundOff * std::max(largest[0], largest[1]);
  }
}

LoadRows LoadSpectrum::loads(Mirror mirror, Index i) const {
  LoadRows rows = LoadRows::Zero(3, count_);
  for (std::size_t component = 0; component < 3; ++component) {
    const Orders& part = orders_[static_cast<std::size_t>(mirror)][component];
    if (part.size() > 0) rows.row(static_cast<Index>(component)) = part.row(i);
  }
  return rows;
}

}  // namespace detail
}  // namespace viscoroll

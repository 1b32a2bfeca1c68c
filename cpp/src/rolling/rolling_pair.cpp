#include "rolling/rolling_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "base/validate.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll::detail {
namespace {

/// Types of bodies, in the order in which messages list them.
template <class... Types>
struct Shapes {};

template <class Shape>
struct Traits;
template <>
struct Traits<CoatedSphere> {
  static constexpr std::string_view name = "CoatedSphere";
  using Counterbodies = Shapes<CoatedPlane, Groove, CoatedSphere>;
};
template <>
struct Traits<CoatedCylinder> {
  static constexpr std::string_view name = "CoatedCylinder";
  using Counterbodies = Shapes<CoatedPlane, CoatedCylinder, Groove>;
};
template <>
struct Traits<CoatedWheel> {
  static constexpr std::string_view name = "CoatedWheel";
  using Counterbodies = Shapes<CoatedPlane, Groove, CoatedCylinder, CoatedWheel>;
};
template <>
struct Traits<CoatedPlane> {
  static constexpr std::string_view name = "CoatedPlane";
};
template <>
struct Traits<Groove> {
  static constexpr std::string_view name = "Groove";
};

template <class Shape, class On, class... Possible>
void require_counterbody(Shapes<Possible...> /*types*/) {
  if constexpr (!(std::is_same_v<On, Possible> || ...)) {
    std::string all;
    ((all += (all.empty() ? "a " : " or a ") + std::string(Traits<Possible>::name)), ...);
    reject("on", all + " for a " + std::string(Traits<Shape>::name), "a " + std::string(Traits<On>::name));
  }
}

template <class Shape>
auto checked_body(const Shape& shape) {
  validate(shape);
  return make_body(shape);
}

/// Nodes from the lowest one to the place at which a convex counterbody has turned by 60 degrees as well.
NodeRange within_60_degrees(const NodeRange& range, double curvature, double distance) {
  const double turned = curvature * distance;  // from node to node [rad]
  const double most = turned > 0.0 ? std::numbers::pi / 3.0 / turned : range.last;
  const int last = most < range.last ? static_cast<int>(most) : range.last;
  return {-last, last};
}

}  // namespace

RollingPair rolling_pair(const RollingBody& body, const Counterbody& on) {
  RollingPair pair{
      .body = std::visit([](const auto& shape) { return checked_body(shape); }, body),
      .on = std::visit([](const auto& shape) { return std::unique_ptr<const Body>(checked_body(shape)); }, on)};
  std::visit(
      []<class Shape, class On>(const Shape& /*body*/, const On& /*on*/) {
        require_counterbody<Shape, On>(typename Traits<Shape>::Counterbodies());
      },
      body, on);
  if (pair.body->is_rigid() && pair.on->is_rigid()) {
    reject("layers", "a list of at least one layer unless on.layers or on.base of the counterbody is given",
           "two rigid bodies");
  }
  for (const auto& [name, layer] : pair.on->layers()) {
    require_length("on." + name + ".thickness", layer.thickness, pair.body->radius(), "the rolling body");
  }
  pair.on->require_room_for(*pair.body);
  return pair;
}

Nodes nodes_of(const RollingPair& pair, const Mesh& mesh) {
  Nodes nodes = pair.body->nodes(mesh, *pair.on);
  const SurfaceGrid& grid = nodes.grid;
  const Curvatures& counterbody = pair.on->curvatures();
  auto& [phi, theta] = nodes.widest;
  phi = within_60_degrees(phi, counterbody.along, grid.radius * grid.phi_spacing);
  theta = within_60_degrees(theta, counterbody.across, grid.radius * grid.theta_spacing);
  return nodes;
}

SurfaceMotion motion_of(const RollingPair& pair, double angular_speed, Curvature curvature) {
  return {
      .angular_speed = angular_speed, .radius = pair.body->radius(), .curvature = curvature, .form = pair.body->form()};
}

ContactKinematics kinematics_of(const RollingPair& pair, double angular_speed, const Mesh& mesh, Curvature curvature,
                                const Execution& execution, const TableNeeds& needs) {
  const Nodes nodes = pair.body->nodes(mesh, *pair.on);
  const double theta_spacing = nodes.grid.theta_spacing;
  return {motion_of(pair, angular_speed, curvature),        mesh,  theta_spacing,
          (nodes.widest.theta.count() - 1) * theta_spacing, needs, execution};
}

double relative_radius(const RollingPair& pair) {
  return pair.body->radius() / (1.0 + pair.body->radius() * pair.on->curvatures().along);
}

double width(const RollingPair& pair) { return std::min(pair.body->width(), pair.on->width()); }

std::vector<NamedLayer> layers(const RollingPair& pair) {
  std::vector<NamedLayer> all = pair.body->layers();
  for (const auto& [name, layer] : pair.on->layers()) all.push_back({.name = "on." + name, .layer = layer});
  return all;
}

double thickness(const RollingPair& pair) {
  double sum = 0.0;
  for (const NamedLayer& named : layers(pair)) sum += named.layer.thickness;
  return sum;
}

bool approach_exists(const RollingPair& pair) {
  return pair.body->form().half_space_rests || std::isfinite(thickness(pair));
}

double layer_thickness(const RollingPair& pair) {
  double sum = 0.0;
  for (const NamedLayer& named : layers(pair)) {
    if (std::isfinite(named.layer.thickness)) sum += named.layer.thickness;
  }
  return sum;
}

double half_space_share(const RollingPair& pair, double angular_speed) {
  double base = std::numeric_limits<double>::infinity();
  double softest = std::numeric_limits<double>::infinity();
  for (const NamedLayer& named : layers(pair)) {
    const std::array rest{0.0};
    const double modulus = modulus_in_rolling(named.layer.shear_modulus, angular_speed, rest).front().real();
    double& least = std::isinf(named.layer.thickness) ? base : softest;
    least = std::min(least, modulus);
  }
  if (std::isinf(base)) return 0.0;
  return std::min(1.0, softest / base);
}

}  // namespace viscoroll::detail

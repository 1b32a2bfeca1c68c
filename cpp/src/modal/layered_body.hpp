/// @file
/// @brief The one description of whatever has layers: sphere, cylinder, wheel, plane and half-space.
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

#include "modal/medium.hpp"
#include "viscoroll/cylinder.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll::detail {

/// @brief The crown that the layers of a wheel follow across, as what a cylinder of some radius changes and how many
/// times that, see crown.hpp: a rounder crown than can be told from its cylinder is told from a flatter one.
struct Crown {
  double radius = std::numeric_limits<double>::infinity();  ///< [m]; infinite: straight across
  double proportion = 1.0;                                  ///< of the crown's curvature and that of this radius

  [[nodiscard]] bool is_flat() const { return std::isinf(radius); }
};

/// @brief Layers bonded to one another, the surface that they end at, and what they lie on. What a body is not said to
/// be here nobody after this asks for.
struct LayeredBody {
  Metric metric;
  std::vector<Layer> layers;                    ///< outwards; a half-space is one of infinite thickness
  InnerBoundary within = InnerBoundary::rigid;  ///< the innermost layer
  /// Where each layer begins and the outermost ends, outwards: places along the normal, see `Metric` [m].
  std::vector<double> boundaries;
  Crown crown;  ///< of a wheel

  /// @brief The layers at one frequency.
  /// @param[in] moduli complex or real shear moduli of the layers [Pa]
  /// @param[in] angular_speed Omega [rad/s]
  template <class Scalar>
  [[nodiscard]] LayerStack<Scalar> stack(const std::vector<Scalar>& moduli, double angular_speed) const {
    LayerStack<Scalar> stack{.metric = metric, .within = within, .media = {}};
    stack.media.reserve(layers.size());
    for (std::size_t j = 0; j < layers.size(); ++j) {
      stack.media.push_back({.inner = boundaries[j],
                             .outer = boundaries[j + 1],
                             .mu = moduli[j],
                             .b = shear_ratio(layers[j], moduli[j]),
                             .inertia = layers[j].density * angular_speed * angular_speed});
    }
    return stack;
  }
};

/// @return the base of a plane, unless it is rigid, as a layer of infinite thickness, and the layers
[[nodiscard]] std::vector<Layer> layers_from_base(const CoatedPlane& plane);

/// @return the layers of a sphere, which has been checked
/// @param[in] sphere core and layers
/// @param[in] curvature how much of it the equations keep
/// @throws std::invalid_argument for bad input
[[nodiscard]] LayeredBody layered_body(const CoatedSphere& sphere, Curvature curvature = Curvature::sphere);

/// @return those of a cylinder, likewise
[[nodiscard]] LayeredBody layered_body(const CoatedCylinder& cylinder);

/// @return those of a wheel, likewise, as of a tread without sides, as thick everywhere. What sides and hub make of it
/// is the business of its section.
[[nodiscard]] LayeredBody layered_body(const CoatedWheel& wheel);

/// @return those of a plane, likewise, its base among them
/// @param[in] plane layers and base
/// @param[in] radius that makes wave numbers orders [m], > 0: that of what rolls
[[nodiscard]] LayeredBody layered_body(const CoatedPlane& plane, double radius);

}  // namespace viscoroll::detail

/// @file
/// @brief Common description of all bodies with layers: sphere, cylinder, wheel, plane and half-space.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

#include "modal/layer_stack.hpp"
#include "viscoroll/cylinder.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll::detail {

/// @brief Depth of a circle below its highest point, 1/k - sqrt(1/k^2 - x^2), without the round-off of small
/// curvatures.
/// @param[in] x horizontal distance from the highest point [m]; beyond the radius 1/k the depth is k x^2
/// @param[in] curvature curvature k [1/m]
/// @return depth [m]
[[nodiscard]] inline double drop_of_circle(double x, double curvature) {
  const double slope = curvature * x;
  return slope * x / (1.0 + std::sqrt(std::max(1.0 - slope * slope, 0.0)));
}

/// @brief Crown of the layers of a wheel: the radius of a cylinder, and a factor on the change of the compliance that
/// its curvature causes (compliance_recursion.hpp). The effect of a strong crown is extrapolated from a flatter
/// reference.
struct Crown {
  double radius = std::numeric_limits<double>::infinity();  ///< radius of the reference [m]; infinite: straight across
  double proportion = 1.0;                                  ///< curvature of the crown relative to the reference

  [[nodiscard]] bool is_flat() const { return std::isinf(radius); }
};

/// @brief Bonded layers with their surface and inner boundary. Later stages use only these members.
struct LayeredBody {
  Metric metric;
  std::vector<Layer> layers;  ///< from inside outwards; a half-space has an infinite thickness
  InnerBoundary inner_boundary = InnerBoundary::rigid;  ///< inner boundary of the innermost layer
  /// Boundaries of the layers, from inside outwards: places along the normal, see `Metric` [m].
  std::vector<double> boundaries;
  Crown crown;  ///< crown of a wheel

  /// @brief Layers at one frequency.
  /// @param[in] moduli complex or real shear moduli of the layers [Pa]
  /// @param[in] angular_speed Omega [rad/s]
  template <class Scalar>
  [[nodiscard]] LayerStack<Scalar> stack(const std::vector<Scalar>& moduli, double angular_speed) const {
    LayerStack<Scalar> stack{.metric = metric, .inner_boundary = inner_boundary, .media = {}};
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

/// @return modulus at zero frequency [Pa]
[[nodiscard]] double relaxed_modulus(const ShearModulus& modulus);

/// @brief Replace the modulus of a layer by its relaxed value, and remove its inertia.
void relax_layer(Layer& layer);

/// @return layers of a plane from the base outwards; the base is a layer of infinite thickness, unless it is rigid
[[nodiscard]] std::vector<Layer> layers_from_base(const CoatedPlane& plane);

/// @brief Describe a checked sphere.
/// @param[in] sphere core and layers
/// @param[in] curvature curvature terms in the layer equations
[[nodiscard]] LayeredBody layered_body(const CoatedSphere& sphere, Curvature curvature = Curvature::sphere);

/// @brief Describe a checked cylinder.
[[nodiscard]] LayeredBody layered_body(const CoatedCylinder& cylinder);

/// @brief Describe the unbounded tread of a checked wheel, with layers of the same thickness everywhere. The folder
/// `section` adds the effects of faces and hub.
[[nodiscard]] LayeredBody layered_body(const CoatedWheel& wheel);

/// @brief Describe a checked plane with its base.
/// @param[in] plane layers and base
/// @param[in] radius radius of the rolling body [m], > 0; orders are wave numbers times this radius
[[nodiscard]] LayeredBody layered_body(const CoatedPlane& plane, double radius);

/// @brief Check a body that a user gave, and describe it. Parameters after the body are those of `layered_body`.
/// @throws InvalidInput for invalid input
template <class Shape, class... Settings>
[[nodiscard]] LayeredBody checked_layered_body(const Shape& shape, const Settings&... settings) {
  validate(shape);
  return layered_body(shape, settings...);
}

}  // namespace viscoroll::detail

/// @file
/// @brief Layers of a body at the frequency of one Fourier order: the metric of their surface, the condition at their
/// inner boundary, and their moduli.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "viscoroll/sphere.hpp"

namespace viscoroll::detail {

/// @brief Kind of one of the two tangential axes of a surface.
enum class AxisKind {
  ring,     ///< a circle around the center: orders are per radian
  line,     ///< a straight line: orders are per radius of the metric
  nothing,  ///< a straight line along which nothing varies: forces and powers are per unit length
};

/// @brief Value of k^2 below which some orders (m, n) have no counterpart on a sphere, whose lowest tangential
/// harmonics are the rigid motions, L = l (l + 1) = 2.
constexpr double kLowOrders = 4.0;

/// @brief Metric of a surface: conversion of orders to wave numbers and of angles to lengths. Positions along the
/// normal are radii if an axis is a ring, else heights above the surface.
struct Metric {
  double radius;                            ///< r [m]; order k has the wave number k / r at the surface
  AxisKind along = AxisKind::ring;          ///< axis phi, in which material crosses the contact
  AxisKind across = AxisKind::ring;         ///< axis theta
  Curvature curvature = Curvature::sphere;  ///< curvature terms in the layer equations of a sphere

  [[nodiscard]] constexpr bool is_curved() const { return along == AxisKind::ring; }
  [[nodiscard]] constexpr bool is_sphere() const { return is_curved() && across == AxisKind::ring; }
  [[nodiscard]] constexpr bool is_wheel() const { return is_curved() && across == AxisKind::line; }
  /// @return 1 if the surface is curved along an axis, else 0
  static constexpr double curvature_flag(AxisKind kind) { return kind == AxisKind::ring ? 1.0 : 0.0; }
  /// @return number of curved axes; multiplied by u_r / r, the relative change of area due to an outward displacement
  [[nodiscard]] constexpr double curved_axes() const { return curvature_flag(along) + curvature_flag(across); }

  /// @return position of the surface [m]
  [[nodiscard]] constexpr double surface() const { return is_curved() ? radius : 0.0; }

  /// @return number of e-folds of an order 1 between two positions
  [[nodiscard]] double depth(double outer, double inner) const {
    return is_curved() ? std::log1p((outer - inner) / inner) : (outer - inner) / radius;
  }
  /// @return position that lies `depth` e-folds of an order 1 deeper than another position [m]
  [[nodiscard]] double deeper_position(double position, double depth) const {
    return is_curved() ? position * std::exp(-depth) : position - depth * radius;
  }

  /// @return ratio of the order across at a position to that at the surface; on a wheel the wave number across is the
  /// same at all radii, so that the order is proportional to the radius
  [[nodiscard]] constexpr double shrinkage(double position) const { return is_wheel() ? position / radius : 1.0; }

  /// @return length of a radian of an axis at a position [m]; 1 if nothing varies along the axis
  [[nodiscard]] constexpr double length(AxisKind kind, double position) const {
    return kind == AxisKind::ring ? position : kind == AxisKind::line ? radius : 1.0;
  }
  /// @return length of a radian of phi [m]: a wave number is an order divided by it, and the stresses of a state are
  /// multiplied by it
  [[nodiscard]] constexpr double length(double position) const { return length(along, position); }
  /// @return area per dphi dtheta at a position, so that the volume element is measure dr dphi dtheta
  [[nodiscard]] constexpr double measure(double position) const {
    return length(along, position) * length(across, position);
  }

  /// @return area of a period of the surface, over which the work of waves of integer orders is summed [m^2], or [m]
  /// in plane strain
  [[nodiscard]] constexpr double area_of_waves() const {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    return measure(surface()) * kTurn * (across == AxisKind::nothing ? 1.0 : kTurn);
  }

  /// @return decay exponent with depth of the slowest solution of an order. On cylinders and wheels it is k - 1,
  /// because the directions turn with the material and order 1 is a translation.
  [[nodiscard]] constexpr double decay_exponent(double k) const { return is_curved() && !is_sphere() ? k - 1.0 : k; }

  /// @brief Membrane stiffness of the surface against tangential displacements, per mu (docs/theory/layers.md).
  ///
  /// It is L - 2 on a sphere, with rigid motions at L = 2, and k^2 in equation (26) of the paper and on a surface that
  /// is straight across.
  /// @param[in] k2 k^2 = m^2 + n^2; L = l (l + 1) for the exact sphere
  /// @return stiffness [-]
  [[nodiscard]] constexpr double membrane_stiffness(double k2) const {
    if (!is_sphere() || curvature == Curvature::paper) return k2;
    return curvature == Curvature::sphere && k2 < kLowOrders ? 0.5 * k2 : k2 - 2.0;
  }
};

/// @brief Properties of an inner boundary, from inner_boundaries.def.
struct InnerSurface {
  bool is_core;  ///< the layer is bonded to a rigid core, which excludes rigid motions
  bool is_free;  ///< the inner surface of the layer is free of stress

  /// @return whether there is a core or a cavity, and with it an inner radius
  [[nodiscard]] constexpr bool exists() const { return is_core || is_free; }
};

[[nodiscard]] constexpr InnerSurface inner_surface(InnerBoundary boundary) {
#define VISCOROLL_INNER_BOUNDARY(name, NAME, details, is_core, is_free) \
  case InnerBoundary::name:                                             \
    return {is_core, is_free};
  switch (boundary) {
#include "viscoroll/inner_boundaries.def"
  }
#undef VISCOROLL_INNER_BOUNDARY
  return {true, false};
}

/// @brief A layer at one frequency. `Scalar` is double if all moduli are real, else std::complex<double>.
template <class Scalar>
struct Medium {
  double inner;    ///< radius or height of the inner boundary, see `Metric` [m]; -infinity for a half-space
  double outer;    ///< radius or height of the outer boundary [m]
  Scalar mu;       ///< shear modulus [Pa]
  Scalar b;        ///< mu / (lambda + 2 mu), see `shear_ratio`
  double inertia;  ///< rho Omega^2 [Pa/m^2]

  [[nodiscard]] bool is_half_space() const { return std::isinf(inner); }
};

/// @brief The layers of a body at one frequency.
template <class Scalar>
struct LayerStack {
  Metric metric;
  InnerBoundary inner_boundary = InnerBoundary::rigid;  ///< condition below the innermost layer
  std::vector<Medium<Scalar>> media;                    ///< layers from the inside out; a half-space is the first

  /// @return rho (Omega length)^2 / modulus, square of the ratio of the speed of the material to its shear wave speed
  [[nodiscard]] Scalar mach2(const Medium<Scalar>& medium) const {
    const double length = metric.length(medium.outer);
    return medium.inertia * length * length / medium.mu;
  }
};

/// @brief Append all numbers that determine the compliance of layers in units of a modulus, for the key of a cache.
template <class Scalar>
void append_numbers(const LayerStack<Scalar>& layers, const Scalar& unit, std::vector<double>& numbers) {
  const Metric& metric = layers.metric;
  const auto number = [](auto name) { return static_cast<double>(name); };
  numbers.insert(numbers.end(), {std::log(metric.radius), number(metric.along), number(metric.across),
                                 number(metric.curvature), number(layers.inner_boundary)});
  const auto append = [&](std::complex<double> value) { numbers.insert(numbers.end(), {value.real(), value.imag()}); };
  for (const Medium<Scalar>& medium : layers.media) {
    numbers.insert(numbers.end(), {medium.inner / metric.radius, medium.outer / metric.radius});
    append(medium.mu / unit);
    append(medium.b);
    append(medium.inertia * metric.radius * metric.radius / unit);
  }
}

/// @brief Ratio b of the shear modulus to the confined modulus.
///
/// b = mu / (lambda + 2 mu) = (1 - 2 nu) / (2 (1 - nu)) = mu / (K + 4/3 mu); 0 for an incompressible layer.
/// @param[in] layer layer with a Poisson's ratio nu or a bulk modulus K
/// @param[in] mu shear modulus [Pa]
/// @return ratio [-]
template <class Scalar>
[[nodiscard]] Scalar shear_ratio(const Layer& layer, Scalar mu) {
  if (layer.bulk_modulus) return mu / (*layer.bulk_modulus + 4.0 / 3.0 * mu);
  return Scalar((1.0 - 2.0 * *layer.poisson_ratio) / (2.0 * (1.0 - *layer.poisson_ratio)));
}

}  // namespace viscoroll::detail

/// @file
/// @brief Fixed cases of the benchmarks, with references for their errors.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>
#include <viscoroll/viscoroll.hpp>

namespace cases {

/// Example of Zehil and Gavin, section 14.
inline viscoroll::CoatedSphere paper_sphere(double density = 1000.0, double thickness = 1e-3) {
  return {.core_radius = 20e-3,
          .layers = {{.thickness = thickness,
                      .shear_modulus = viscoroll::standard_linear_solid(6e6, 3e6, 0.125),
                      .poisson_ratio = 0.5,
                      .density = density}}};
}

/// A sphere of 21 mm with a coating of the same material, half of the radius thick.
inline viscoroll::CoatedSphere thick_coating() {
  viscoroll::CoatedSphere sphere = paper_sphere(0.0, 10.5e-3);
  sphere.core_radius = 10.5e-3;
  return sphere;
}

/// Two layers with different relaxation functions.
inline viscoroll::CoatedSphere dissimilar_layers() {
  return {.core_radius = 20e-3,
          .layers = {{.thickness = 0.5e-3,
                      .shear_modulus = viscoroll::standard_linear_solid(6e6, 3e6, 0.125),
                      .poisson_ratio = 0.5},
                     {.thickness = 0.5e-3,
                      .shear_modulus = viscoroll::FractionalZener{6e6, 3e6, 0.05, 0.6},
                      .poisson_ratio = 0.49}}};
}

/// A coating with the retardation time `viscosity` [Pa s] / 3 MPa.
inline viscoroll::CoatedSphere kelvin_voigt(double viscosity) {
  return {
      .core_radius = 20e-3,
      .layers = {{.thickness = 1e-3, .shear_modulus = viscoroll::KelvinVoigt{3e6, viscosity}, .poisson_ratio = 0.5}}};
}

/// A stiff fractional skin over soft rubber.
inline viscoroll::CoatedSphere stiff_skin() {
  return {
      .core_radius = 20e-3,
      .layers = {
          {.thickness = 2e-3, .shear_modulus = viscoroll::standard_linear_solid(2e6, 1e6, 0.05), .poisson_ratio = 0.5},
          {.thickness = 0.5e-3,
           .shear_modulus = viscoroll::FractionalZener{60e6, 20e6, 0.01, 0.5},
           .poisson_ratio = 0.45}}};
}

/// The coating of `stiff_skin`, with the modulus of the skin tabulated at eight frequencies per decade.
inline viscoroll::CoatedSphere measured_skin() {
  viscoroll::CoatedSphere sphere = stiff_skin();
  viscoroll::MasterCurve curve{.frequency = {0.0}};
  for (int i = -8; i <= 56; ++i) curve.frequency.push_back(2.5 * std::pow(10.0, i / 8.0));
  for (const auto& mu : viscoroll::complex_modulus(sphere.layers.back().shear_modulus, curve.frequency)) {
    curve.storage.push_back(mu.real());
    curve.loss.push_back(mu.imag());
  }
  sphere.layers.back().shear_modulus = curve;
  return sphere;
}

/// A crowned wheel, 40 mm wide, whose contact is 37 mm wide under `kWheelRolling`. The tread is `number` nanometers
/// thicker than 10 mm, so that a new number gives a wheel without cached data.
inline viscoroll::CoatedWheel crowned_wheel(viscoroll::Sides sides, int number = 0) {
  return {.core_radius = 40e-3,
          .layers = {{.thickness = 10e-3 + 1e-9 * number,
                      .shear_modulus = viscoroll::standard_linear_solid(6e6, 3e6, 0.125),
                      .poisson_ratio = 0.5}},
          .width = 40e-3,
          .crown_radius = 300e-3,
          .hub = viscoroll::Hub::crowned,
          .sides = sides};
}

/// A mat of the example's rubber on a rigid base, or half of it on a softer layer with a shorter relaxation time.
inline viscoroll::CoatedPlane mat(bool dissimilar) {
  viscoroll::Layer layer = paper_sphere(0.0).layers.front();
  if (!dissimilar) return {.layers = {layer}};
  layer.thickness = 0.5e-3;
  viscoroll::Layer softer = layer;
  softer.shear_modulus = viscoroll::standard_linear_solid(4e6, 1e6, 0.02);
  return {.layers = {softer, layer}};
}

/// A roller with a core radius of 50 mm and 10 mm of the same rubber.
inline viscoroll::CoatedCylinder roller() { return {.core_radius = 50e-3, .layers = paper_sphere(0.0, 10e-3).layers}; }

/// A rough surface of 1 mm by 1 mm with 256 waves, from a quarter to a 128th of its side, with eight nodes in the
/// shortest wave at 1024 nodes per side. It is nearly self-affine with the Hurst exponent 0.8: each octave has as many
/// waves, whose amplitudes fall as q^-0.8. The rms slope is 0.1.
inline viscoroll::HeightMap rough_surface(int nodes) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  constexpr double kSide = 1e-3;
  constexpr int kWaves = 256;
  viscoroll::HeightMap map{.heights = std::vector<double>(static_cast<std::size_t>(nodes) * nodes),
                           .rows = nodes,
                           .columns = nodes,
                           .spacing_x = kSide / nodes,
                           .spacing_z = kSide / nodes};
  for (int wave = 0; wave < kWaves; ++wave) {
    const double q = 4.0 * std::pow(32.0, (wave + 0.5) / kWaves);
    const double direction = kTurn * 0.618034 * wave;  // the golden ratio distributes the directions evenly
    const double phase = kTurn * 0.414214 * wave * wave;
    const int i = static_cast<int>(std::lround(q * std::cos(direction)));
    const int j = static_cast<int>(std::lround(q * std::sin(direction)));
    const double amplitude = 2.4e-7 * std::pow(4.0 / q, 0.8);
    for (int row = 0; row < nodes; ++row) {
      for (int column = 0; column < nodes; ++column) {
        const double turns = (static_cast<double>(i) * row + static_cast<double>(j) * column) / nodes;
        map.heights[static_cast<std::size_t>(row) * nodes + column] += amplitude * std::cos(kTurn * turns + phase);
      }
    }
  }
  return map;
}

inline const viscoroll::LoadCase kRolling{.load = 100.0, .angular_speed = 2.5};
inline const viscoroll::LoadCase kWheelRolling{.load = 500.0, .angular_speed = 2.5};

/// An entry of table 2 of the paper.
struct TableEntry {
  int nodes_per_revolution;
  int max_order;
  double torque;  ///< printed [mN m]
};

inline constexpr std::array<TableEntry, 51> kTable2{{
    {100, 250, 10.50},  {100, 500, 10.36},  {100, 750, 10.43},  {100, 1000, 10.46}, {100, 1250, 10.44},
    {100, 1500, 10.43}, {150, 250, 11.42},  {150, 500, 11.47},  {150, 750, 11.50},  {150, 1000, 11.44},
    {150, 1250, 11.43}, {150, 1500, 11.42}, {200, 250, 11.22},  {200, 500, 11.01},  {200, 750, 11.01},
    {200, 1000, 11.03}, {200, 1250, 11.01}, {200, 1500, 11.01}, {300, 250, 11.09},  {300, 500, 11.10},
    {300, 750, 11.11},  {300, 1000, 11.10}, {300, 1250, 11.11}, {300, 1500, 11.10}, {400, 250, 11.33},
    {400, 500, 11.31},  {400, 750, 11.32},  {400, 1000, 11.32}, {400, 1250, 11.31}, {400, 1500, 11.32},
    {500, 250, 11.41},  {500, 500, 11.38},  {500, 750, 11.39},  {500, 1000, 11.40}, {500, 1250, 11.40},
    {500, 1500, 11.39}, {600, 500, 11.42},  {600, 750, 11.41},  {600, 1000, 11.42}, {600, 1250, 11.43},
    {600, 1500, 11.42}, {700, 500, 11.45},  {700, 750, 11.44},  {700, 1000, 11.45}, {700, 1250, 11.44},
    {700, 1500, 11.45}, {800, 500, 11.45},  {800, 750, 11.44},  {800, 1000, 11.44}, {800, 1250, 11.44},
    {800, 1500, 11.44},
}};

}  // namespace cases

/// @file
/// @brief How two bodies touch: in a spot, or along a line.
#pragma once

#include <numbers>
#include <string_view>

namespace viscoroll::detail {

/// @brief What follows from a contact's form alone. Along a line loads, forces, torques and powers are per length.
///
/// With shear modulus G, Poisson's ratio 0, the confined modulus M, relative radius R and thickness h, a contact that
/// reaches `a` to either side and has d dimensions bears, where the layer is thick, Hertz's load `thick` G a^(d+1) / R,
/// and where it is thin, `incompressible` G a^(d+4) / (R h^3) or `confined` M a^(d+2) / (R h).
struct ContactForm {
  int dimensions;  ///< 2 of a spot, 1 of a line
  std::string_view load_unit;
  std::string_view torque_unit;
  bool half_space_rests;  ///< far away; under a line each octave of longer waves adds as much to displacements
  double thick;
  double incompressible;
  double confined;

  [[nodiscard]] bool is_line() const { return dimensions == 1; }
};

inline constexpr ContactForm kSpotContact{.dimensions = 2,
                                          .load_unit = "N",
                                          .torque_unit = "N m",
                                          .half_space_rests = true,
                                          .thick = 8.0 / 3.0,
                                          .incompressible = std::numbers::pi / 32.0,
                                          .confined = std::numbers::pi / 4.0};

inline constexpr ContactForm kLineContact{.dimensions = 1,
                                          .load_unit = "N/m",
                                          .torque_unit = "N",
                                          .half_space_rests = false,
                                          .thick = std::numbers::pi / 2.0,
                                          .incompressible = 2.0 / 15.0,
                                          .confined = 2.0 / 3.0};

}  // namespace viscoroll::detail

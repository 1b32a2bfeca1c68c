/// @file
/// @brief Point contact and line contact.
#pragma once

#include <numbers>
#include <string_view>

namespace viscoroll::detail {

/// @brief Constants that depend only on the form of the contact. In line contact, loads, forces, torques and powers are
/// per length.
///
/// With shear modulus G, Poisson's ratio 0, confined modulus M, relative radius R and thickness h, a contact with d
/// dimensions and half-width a supports Hertz's load `thick` G a^(d+1) / R on a thick layer, and `incompressible` G
/// a^(d+4) / (R h^3) or `confined` M a^(d+2) / (R h) on a thin layer.
struct ContactForm {
  int dimensions;  ///< 2 for a point contact, 1 for a line contact
  std::string_view load_unit;
  std::string_view torque_unit;
  bool half_space_rests;  ///< whether a half-space is at rest far away; in line contact, every octave of longer waves
                          ///< adds the same displacement
  double thick;
  double incompressible;
  double confined;

  [[nodiscard]] bool is_line() const { return dimensions == 1; }
};

inline constexpr ContactForm kPointContact{.dimensions = 2,
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

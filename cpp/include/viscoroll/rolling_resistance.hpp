/// @file
/// @brief Rolling resistance as a fitted surface over load and speed, for equations of motion that cannot solve for it.
///
/// Python's `RollingResistance.from_study` fits it, and `save("torque.json")` writes it for `from_json`.
#pragma once

#include <array>
#include <vector>

#include "viscoroll/materials.hpp"

namespace viscoroll {

/// @brief Torque T(P, Omega) = power lost / Omega, a polynomial of ln P and ln Omega for ln T, with its error.
struct RollingResistance {
  std::array<double, 2> load{};           ///< P from and to [N], > 0
  std::array<double, 2> angular_speed{};  ///< Omega from and to [rad/s], > 0
  double radius = 0.0;                    ///< r_o [m], > 0
  /// Of Chebyshev polynomials of ln P (rows) and ln Omega (columns), each mapped to [-1, 1], for ln(T / N m)
  std::vector<std::vector<double>> coefficients;
  double error = 0.0;          ///< root mean square relative error of points left out of the fit one by one [-]
  double largest_error = 0.0;  ///< their largest [-]
};

/// @brief Evaluate a surface, odd in the speed.
///
/// Below the lowest speed T goes to 0 in proportion to it, as it does in the end for every material whose relaxation
/// ends: T(P, Omega_1) Omega / Omega_1.
/// @param[in] surface as it was fitted
/// @param[in] load P [N], >= 0
/// @param[in] angular_speed Omega [rad/s], of either sign
/// @param[in] outside whether loads outside and speeds above the fitted range are refused, or the nearest T / P is held
/// @return torque against the turning, of the sign of Omega [N m]
/// @throws std::invalid_argument naming parameter, value, unit and range
[[nodiscard]] double resisting_torque(const RollingResistance& surface, double load, double angular_speed,
                                      Extrapolation outside = Extrapolation::error);

/// @brief Check a surface.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const RollingResistance& surface);

/// @brief Take a surface from JSON, by nlohmann/json, which finds this by itself:
/// `nlohmann::json::parse(file).get<viscoroll::RollingResistance>()`.
/// @param[in] json what `save("torque.json")` wrote
/// @param[out] surface as it was fitted
/// @throws Json::exception where a value is missing or of another type
/// @throws std::invalid_argument naming parameter, value, unit and range
template <class Json>
void from_json(const Json& json, RollingResistance& surface) {
  json.at("load").get_to(surface.load);
  json.at("angular_speed").get_to(surface.angular_speed);
  json.at("radius").get_to(surface.radius);
  json.at("coefficients").get_to(surface.coefficients);
  json.at("error").get_to(surface.error);
  json.at("largest_error").get_to(surface.largest_error);
  validate(surface);
}

}  // namespace viscoroll

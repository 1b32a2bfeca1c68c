/// @file
/// @brief Rolling resistance as a fitted surface over load and speed, for simulations that cannot solve the contact in
/// every step.
///
/// In Python, `RollingResistance.from_study` fits the surface and `save("torque.json")` writes it for `from_json`.
#pragma once

#include <array>
#include <vector>

#include "viscoroll/materials.hpp"

namespace viscoroll {

/// @brief Torque T(P, Omega) = dissipated power / Omega: a polynomial in ln P and ln Omega for ln T, with its error.
struct RollingResistance {
  std::array<double, 2> load{};           ///< lowest and highest load P of the fit [N], > 0
  std::array<double, 2> angular_speed{};  ///< lowest and highest speed Omega of the fit [rad/s], > 0
  double radius = 0.0;                    ///< outer radius r_o [m], > 0
  /// Coefficients of ln(T / N m) in Chebyshev polynomials of ln P (rows) and ln Omega (columns), each mapped to [-1,
  /// 1].
  std::vector<std::vector<double>> coefficients;
  double error = 0.0;          ///< root mean square of the relative leave-one-out errors of the fit [-]
  double largest_error = 0.0;  ///< largest relative leave-one-out error [-]
};

/// @brief Evaluate the torque of a surface. It is odd in the speed.
///
/// Below the lowest speed Omega_1 of the fit the torque is proportional to the speed, T(P, Omega_1) Omega / Omega_1,
/// which is the limit of every material with a longest relaxation time.
/// @param[in] surface fitted surface
/// @param[in] load P [N], >= 0
/// @param[in] angular_speed Omega [rad/s], either sign
/// @param[in] outside treatment of a load outside the range of the fit, or of a speed above it: throw an error, or use
/// T / P at the nearer end of the range
/// @return resisting torque, with the sign of Omega [N m]
/// @throws InvalidInput naming parameter, value, unit and range
[[nodiscard]] double resisting_torque(const RollingResistance& surface, double load, double angular_speed,
                                      Extrapolation outside = Extrapolation::error);

/// @brief Check a surface.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const RollingResistance& surface);

/// @brief Read a surface from JSON. The library nlohmann/json finds this function by argument-dependent lookup:
/// `nlohmann::json::parse(file).get<viscoroll::RollingResistance>()`.
/// @param[in] json content of a file that `save("torque.json")` wrote
/// @param[out] surface fitted surface
/// @throws Json::exception if a value is missing or has another type
/// @throws InvalidInput naming parameter, value, unit and range
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

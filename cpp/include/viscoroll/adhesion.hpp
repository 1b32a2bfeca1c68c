/// @file
/// @brief Adhesion of two smooth, clean surfaces.
#pragma once

#include <optional>
#include <tuple>

#include "viscoroll/fields.hpp"

namespace viscoroll {

/// @brief Attraction of two surfaces across their gap g: sigma = strength (1 - g / range)^2 up to the range, above a
/// hard wall at g = 0. The work of adhesion is strength * range / 3.
///
/// At most one of `strength` and `range` is given. Without both, the range is taken to be so short that results do not
/// depend on it. See docs/theory/adhesion.md.
struct Adhesion {
  double work = 0.0;                      ///< work of adhesion w, gained where the surfaces come together [J/m^2], > 0
  std::optional<double> strength;         ///< attraction at g = 0 [Pa], > 0
  std::optional<double> range;            ///< gap at which the attraction ends [m], > 0
  std::optional<double> separation_work;  ///< work to separate the surfaces, if it is larger than `work` [J/m^2]

  static constexpr auto fields() {
    return std::tuple{Field{"work", &Adhesion::work}, Field{"strength", &Adhesion::strength, true},
                      Field{"range", &Adhesion::range, true},
                      Field{"separation_work", &Adhesion::separation_work, true}};
  }
};

/// @brief Check an adhesion.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const Adhesion& adhesion);

}  // namespace viscoroll

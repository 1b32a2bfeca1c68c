/// @file
/// @brief Load or penetration, speed, friction and drive of a rolling body.
#pragma once

#include <optional>
#include <tuple>

#include "viscoroll/adhesion.hpp"
#include "viscoroll/drive.hpp"
#include "viscoroll/fields.hpp"

namespace viscoroll {

/// @brief Speed of the ground or belt, in place of the angular speed of a model.
struct GroundSpeed {
  double speed = 0.0;  ///< V [m/s], > 0
};

/// @brief Load or penetration, speed, friction and drive of a rolling body. Exactly one of load and penetration is
/// given, and one of angular_speed and speed; the others are results.
struct LoadCase {
  /// Normal load P [N], > 0; for rollers per unit length [N/m]. With adhesion it may be zero or negative.
  std::optional<double> load = {};
  /// Penetration r_o - H [m], the same quantity as `Result::penetration`: radius at rest minus height of the center. It
  /// is larger than minus the centrifugal displacement and smaller than the thickness of the layers.
  std::optional<double> penetration = {};
  double angular_speed = 0.0;  ///< Omega [rad/s], > 0; left out if the speed is given
  /// Speed V of the ground or belt [m/s], > 0, without friction. Linear theory is then solved at V / r_o, and the
  /// angular speed of the body follows from the overspeed.
  std::optional<double> speed = {};
  double friction = 0.0;  ///< Coulomb's coefficient mu between the bodies [-], in [0, 4]; infinite: full stick
  Drive drive;            ///< without friction, a force of 0 or a creepage
  std::optional<Adhesion> adhesion = {};  ///< adhesion of the surfaces, without friction; none for surfaces that do not
                                          ///< attract each other
  /// Whether to find the largest tension that adhesion supports; load and penetration are then left out.
  bool pulls_off = false;

  static constexpr auto fields() {
    return std::tuple{Field{"load", &LoadCase::load, true},
                      Field{"penetration", &LoadCase::penetration, true},
                      Field{"angular_speed", &LoadCase::angular_speed, true},
                      Field{"speed", &LoadCase::speed, true},
                      Field{"friction", &LoadCase::friction, true},
                      Field{"drive", &LoadCase::drive, true},
                      Field{"adhesion", &LoadCase::adhesion, true},
                      Field{"pulls_off", &LoadCase::pulls_off, true}};
  }
};

}  // namespace viscoroll

/// @file
/// @brief Estimate of the torque that adhesion adds, without a solution of the contact with adhesion:
/// docs/theory/adhesion.md, "When adhesion matters".
#pragma once

#include "rolling/edge_works.hpp"

namespace viscoroll::detail {

/// @brief Contact without adhesion, as far as the estimate depends on it.
struct RollingStrip {
  double half_length;  ///< half-width of the contact along the path [m]
  double width;        ///< width of the contact across the path; 1 for quantities per unit length [m]
  double radius;       ///< radius of the rolling body [m]
  double speed;        ///< speed at which material passes the contact [m/s], > 0
};

/// @brief Additional torque due to adhesion, width R (w_open chi - w_close / chi), with chi = J(1.2 a / V) / J(l / V).
///
/// chi is the ratio of the compliance on the scale of the contact to that on the scale l = w / (J_inf sigma_0^2) of the
/// edges, with the instantaneous compliance if the strength is infinite. The factor 1.2 is fitted. The estimate is
/// within a fifth of nine solved cases of a ball on a mat if adhesion is weak; it can be twice too large for rollers
/// with strong adhesion.
/// @param[in] creep creep compliance at the edges
/// @param[in] adhesion works and strength of the surfaces
/// @param[in] contact contact without adhesion
/// @return torque [N m], or per unit length [N]; infinite for an infinite strength without an instantaneous compliance
[[nodiscard]] double adhesion_torque_estimate(const EdgeCreep& creep, const SurfaceAdhesion& adhesion,
                                              const RollingStrip& contact);

}  // namespace viscoroll::detail

/// @file
/// @brief Estimate of the contact size before the contact is solved.
#pragma once

#include "rolling/mesh_model.hpp"
#include "viscoroll/load_case.hpp"

namespace viscoroll::detail {

/// @brief Extent of the contact of two bodies, rather too large than too small, for the size of the candidate window.
///
/// The load of a contact of half-width a is the sum of Hertz's, P = 8 G a^3 / (3 R), and of the smaller of two loads of
/// a thin bonded layer: P = pi G a^6 / (32 R h^3) (incompressible) and P = pi M a^4 / (4 R h) (confined modulus M). The
/// true load at a given a is larger. The smallest modulus of all layers is used. The modulus of a layer is the larger
/// of its relaxed modulus and half of its modulus at the frequency Omega r_o / a at which material passes the contact:
/// a coating that relaxes almost completely, but not within this time, is estimated by its stiffness in rolling.
///
/// - Roller: P = pi G a^2 / (2 R), 2 G a^5 / (15 R h^3) and 2 M a^3 / (3 R h) per length.
/// - Two bodies, or layers on a half-space: the compliances (the inverse of the load at a given a) add up.
/// - Groove: a circle with the mean of both curvatures.
/// - Wheel: strips of its width, each a roller with the gap that the crown leaves.
///
/// @param[in] pair rolling body and counterbody
/// @param[in] angular_speed Omega [rad/s]
/// @param[in] load P [N], for a roller per length
/// @return half-widths along and across; both are a for a ball
[[nodiscard]] ContactReach estimate_contact(const RollingPair& pair, double angular_speed, double load);

/// @brief Same estimate for a load case, whose load or penetration is given, or which has the largest tension.
///
/// A contact of half-width a on thin layers has the penetration a^2 / (2 R), or d a^2 / (2 (d + 2) R) in d dimensions
/// if they are incompressible, and on a thick layer that of Hertz, a^2 / R in point contact. Each part contributes the
/// mean of both limits weighted by their loads; parts are weighted by their compliance. The result is made as much too
/// large as that for a load.
/// @param[in] pair rolling body and counterbody, whose centrifugal displacement adds to the penetration
/// @param[in] load_case load case
[[nodiscard]] ContactReach estimate_contact(const PairAtSpeed& pair, const LoadCase& load_case);

/// @brief Load without adhesion at which the contact is about as large as that of a load case with adhesion.
///
/// It is P plus the tension that the edges take from a contact of half-width a (K. L. Johnson, K. Kendall and A. D.
/// Roberts, Proc. R. Soc. A 324 (1971) 301-313): sqrt(8 pi w E* a^3) on a half-space, sqrt(2 pi w E* a) for a roller,
/// and on a thin bonded layer the load of a layer that is lifted by sqrt(2 w h / M), whichever is larger.
/// @param[in] pair both bodies
/// @param[in] load_case load case with adhesion; P = 0 if its load is negative or not given, since the solver finds
/// tensile states from that of P = 0
/// @return load [N], for a roller per length
[[nodiscard]] double equivalent_load(const RollingPair& pair, const LoadCase& load_case);

/// @brief Upper bound of the loads that a coating of such layers can support: a thousand times the loads of Hertz and
/// of the thin incompressible bonded layer for a contact as wide as the body, with the stiffest layer at the highest
/// harmonic.
/// @param[in] pair rolling body and counterbody
/// @param[in] stiffest_modulus largest shear modulus of a layer at the highest harmonic [Pa]
/// @return load [N], for a roller per length
[[nodiscard]] double load_upper_bound(const RollingPair& pair, double stiffest_modulus);

}  // namespace viscoroll::detail

/// @file
/// @brief Forms of the contact equations between which a user may choose.
#pragma once

namespace viscoroll {

/// @brief The compliance in the contact condition (46). Their difference is of the order of the strain: a measure of
/// what linear theory does not know.
enum class Compliance {
  radial,    ///< C_RR (the paper's section 12): pressure along the radius; the one nearer to finite strain,
             ///< docs/theory/normal-contact.md
  vertical,  ///< C_WW, the vertical block of Q^T C_s Q: pressure on the normals of the undeformed sphere
};

/// @brief Traction on the patch of a node under unit nodal force.
enum class PatchLoad {
  flat,       ///< uniform in (phi, theta), equation (53)
  spherical,  ///< proportional to 1/sin(theta), equation (38)
};

/// @brief How far material travels between neighboring nodes of an undeformed sphere that rolls over the plane.
enum class SlipKinematics {
  exact,  ///< the integral of y = r_o sin(theta) sin(phi): away from the middle plane the radius is smaller
  flat,   ///< r_o times the spacing everywhere, the last form of (55a), for comparison with the paper
};

}  // namespace viscoroll

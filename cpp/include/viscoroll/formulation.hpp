/// @file
/// @brief Options that select a form of the contact equations.
#pragma once

namespace viscoroll {

/// @brief Compliance in the contact condition (46).
///
/// The two choices differ by terms of the order of the strain. Their difference measures the error of linear theory.
enum class Compliance {
  radial,    ///< C_RR (section 12 of the paper): the pressure acts along the radius; closer to finite strain, see
             ///< docs/theory/normal-contact.md
  vertical,  ///< C_WW, the vertical block of Q^T C_s Q: the pressure acts along the normals of the undeformed sphere
};

/// @brief Distribution of the traction on the patch of a node under a unit nodal force.
enum class PatchLoad {
  flat,       ///< uniform in (phi, theta), equation (53)
  spherical,  ///< proportional to 1/sin(theta), equation (38)
};

/// @brief Distance that undeformed material travels from a node to the next as the sphere rolls over the plane. It
/// enters the slip.
enum class SlipKinematics {
  exact,  ///< integral over phi of y = r_o sin(theta) sin(phi): the distance to the axis varies over the contact
  flat,   ///< r_o times the spacing at every node, the last form of (55a); for comparison with the paper
};

}  // namespace viscoroll

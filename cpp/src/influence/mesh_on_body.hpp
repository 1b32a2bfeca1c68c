/// @file
/// @brief Nodes of a mesh on either of two bodies in rolling contact.
#pragma once

#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief Mesh of the rolling body, transferred to a body of another radius at the same arc lengths. Angles are larger
/// by the ratio of angular speeds.
class MeshOnBody {
 public:
  /// @param[in] mesh mesh of the rolling body
  /// @param[in] turns revolutions of this body per revolution of the rolling body, > 0
  MeshOnBody(const Mesh& mesh, double turns = 1.0);
  /// @param[in] mesh,turns same as above
  /// @param[in] theta_spacing angle between neighbors across, on the rolling body [rad]; the mesh alone does not give
  /// it for a wheel
  /// @param[in] widest largest angle between nodes across, on the rolling body [rad]
  MeshOnBody(const Mesh& mesh, double turns, double theta_spacing, double widest);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] double turns() const { return turns_; }
  /// @return angle between neighbors along phi, on this body [rad]
  [[nodiscard]] double phi_spacing() const { return turns_ * viscoroll::phi_spacing(mesh_); }
  /// @return angle between neighbors along theta, on this body [rad]
  [[nodiscard]] double theta_spacing() const { return turns_ * theta_spacing_; }
  /// @return largest angle between nodes across, on this body [rad]
  [[nodiscard]] double widest() const { return turns_ * widest_; }

  /// @return mesh around this body for the choice of orders and reaches. The number of nodes per revolution need not be
  /// an integer and is rounded; a truncation keeps its wave number.
  [[nodiscard]] const Mesh& rounded() const { return rounded_; }

 private:
  Mesh mesh_;
  double turns_;
  double theta_spacing_;
  double widest_;
  Mesh rounded_;
};

}  // namespace viscoroll::detail

/// @file
/// @brief The nodes of a mesh on either of two bodies that roll on one another.
#pragma once

#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief The mesh of what rolls, whose nodes lie at the same arcs on a body of another radius: at angles that are as
/// much larger as the body turns faster.
class MeshOnBody {
 public:
  /// @param[in] mesh of what rolls
  /// @param[in] turns of the body per turn of what rolls, > 0
  MeshOnBody(const Mesh& mesh, double turns = 1.0);
  /// @param[in] theta_spacing angle of what rolls between neighbors across, which the mesh alone does not say of a
  /// wheel [rad]
  /// @param[in] widest largest angle of what rolls across, between nodes [rad]
  MeshOnBody(const Mesh& mesh, double turns, double theta_spacing, double widest);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] double turns() const { return turns_; }
  /// @return angle of the body between neighbors along phi [rad]
  [[nodiscard]] double phi_spacing() const { return turns_ * viscoroll::phi_spacing(mesh_); }
  /// @return angle of the body between neighbors along theta [rad]
  [[nodiscard]] double theta_spacing() const { return turns_ * theta_spacing_; }
  /// @return largest angle of the body across, between nodes [rad]
  [[nodiscard]] double widest() const { return turns_ * widest_; }

  /// @return the mesh around the body itself, for the choice of orders and reaches: a revolution of it need not be a
  /// whole number of nodes, which are rounded; a truncation keeps its wave number
  [[nodiscard]] const Mesh& rounded() const { return rounded_; }

 private:
  Mesh mesh_;
  double turns_;
  double theta_spacing_;
  double widest_;
  Mesh rounded_;
};

}  // namespace viscoroll::detail

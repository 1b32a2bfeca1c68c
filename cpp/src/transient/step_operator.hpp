/// @file
/// @brief Displacement of the nodes in the contact due to the forces at the end of a step, in the frame of the plane: a
/// sum of elastic surfaces, each scaled by its share.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "creep/mirrored_tables.hpp"
#include "surface/surface_operator.hpp"

namespace viscoroll::detail {

/// @brief Directions of the plane's frame, by `Axis`: forward, down and sideways, each by its components r, phi and
/// theta at the nodes.
using Axes = std::array<std::array<HalfField, 3>, 3>;

/// @return component of a vector field along a direction
[[nodiscard]] HalfField along(const std::array<HalfField, 3>& direction, const HalfField& field);

/// @return values at the nodes of a half field, given row by row, with one column for each row
[[nodiscard]] inline HalfField as_field(const Eigen::ArrayXd& values, Eigen::Index half_nodes) {
  return values.matrix().reshaped(half_nodes, values.size() / half_nodes);
}

/// @param[in] axes directions at the nodes
/// @param[in] force of the plane on the coating at the nodes of a half field, row by row
/// @return the forces of the coating on the plane, by components
[[nodiscard]] HalfField on_plane(const Axes& axes, const VectorField& force);

/// @brief Sum of share_i A_i K_i A_i^T over tables of equal rows and components; A_i are the directions of the plane.
class StepOperator {
 public:
  struct Part {
    double share;
    const MirroredTables* tables;  ///< must outlive the operator
    const Axes* axes;        ///< of the nodes of a window; must outlive the operator; ignored for tables of r only
    const Axes* level_axes;  ///< of the nodes of a window whose middle row is the lowest one; must outlive the operator
  };

  /// @param[in] parts at least one
  /// @param[in] checkpoint called every few milliseconds
  StepOperator(std::vector<Part> parts, std::function<void()> checkpoint)
      : parts_(std::move(parts)), checkpoint_(std::move(checkpoint)) {}

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  /// @brief Check for cancellation. Long computations besides the products must call this; products call it themselves.
  void checkpoint() const { checkpoint_(); }
  [[nodiscard]] Eigen::Index half_nodes() const { return parts_.front().tables->half_nodes(); }
  /// @return displacement of a node in the middle along r under a unit force on it
  [[nodiscard]] double diagonal_compliance() const;
  /// @return displacement of a node of the window along the plane under a unit force on it
  [[nodiscard]] double compliance_along(Eigen::Index node) const;

  /// @return upward displacements of some nodes under normal forces on others
  [[nodiscard]] Eigen::MatrixXd normal_compliance(const std::vector<Eigen::Index>& displaced,
                                                  const std::vector<Eigen::Index>& loaded) const;

  /// @return upward displacements of a window under normal forces on rows from the first to the last
  [[nodiscard]] HalfField normal_displacement(const HalfField& pressing, Eigen::Index first, Eigen::Index last) const;

  /// @return shares of the parts
  [[nodiscard]] std::vector<double> shares() const;
  /// @return the same parts with other shares
  [[nodiscard]] StepOperator with_shares(const std::vector<double>& shares) const;
  /// @brief Transformation of the displacement of a node from the axes to a frame in which the compliance depends on
  /// offsets only. For a single body, the frame is r, phi and theta, which turn with the body. The frames of several
  /// bodies turn relative to each other; for these, the frame is that of the plane, and the compliance is that of nodes
  /// whose middle row is the lowest one, from which they turn by less than half a spacing.
  [[nodiscard]] Eigen::Matrix3d to_frame(Eigen::Index node) const;
  /// @return compliance in that frame, [3 * displaced + component][3 * loaded + component], from tables of three
  /// components
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& displaced,
                                           const std::vector<Eigen::Index>& loaded) const;

  /// @param[in] force of the plane at the nodes of the window
  /// @return displacements of the window under the opposite forces, for each part without its share
  [[nodiscard]] std::vector<HalfField> displaced(const VectorField& force) const;
  /// @return displacements along the axes, from the displacements of the parts
  [[nodiscard]] VectorField displacement(const std::vector<HalfField>& displaced) const;
  /// @return displacements under some forces minus those according to `compliance`
  [[nodiscard]] VectorField excess(const VectorField& force, const std::vector<HalfField>& displaced) const;

 private:
  [[nodiscard]] bool is_single() const { return parts_.size() == 1; }

  std::vector<Part> parts_;
  std::function<void()> checkpoint_;
};

}  // namespace viscoroll::detail

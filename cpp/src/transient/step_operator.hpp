/// @file
/// @brief What forces at the end of a step displace: a sum of elastic surfaces, each by the share that has crept.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "transient/mirrored_tables.hpp"
#include "transient/plane_frame.hpp"

namespace viscoroll::detail {

/// @brief sum of share_i A_i K_i A_i^T over tables of the same rows and components, A_i the directions of the plane.
class StepOperator {
 public:
  struct Part {
    double share;
    const MirroredTables* tables;  ///< outlives the sum
    const Axes* axes;              ///< of the nodes of a window, likewise; not looked at where there is r alone
    const Axes* level_axes;        ///< of the nodes of a window whose middle row is the lowest one, likewise
  };

  /// @param[in] parts at least one
  /// @param[in] checkpoint called every few milliseconds
  StepOperator(std::vector<Part> parts, std::function<void()> checkpoint)
      : parts_(std::move(parts)), checkpoint_(std::move(checkpoint)) {}

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  /// @brief To be called by what takes long beside the products, which do it themselves.
  void checkpoint() const { checkpoint_(); }
  [[nodiscard]] Eigen::Index half_nodes() const { return parts_.front().tables->half_nodes(); }
  /// @return displacement of a node in the middle by a unit force on it: along r,
  [[nodiscard]] double own_compliance() const;
  /// @return and along the plane, of a node of the window
  [[nodiscard]] double compliance_along(Eigen::Index node) const;

  /// @return upward displacements of some nodes by pressing forces on others
  [[nodiscard]] Eigen::MatrixXd normal_compliance(const std::vector<Eigen::Index>& displaced,
                                                  const std::vector<Eigen::Index>& loaded) const;

  /// @return upward displacements of a window by pressing forces on rows from the first to the last
  [[nodiscard]] HalfField normal_displacement(const HalfField& pressing, Eigen::Index first, Eigen::Index last) const;

  /// @return shares of the parts
  [[nodiscard]] std::vector<double> shares() const;
  /// @return the same parts by other shares
  [[nodiscard]] StepOperator with_shares(const std::vector<double>& shares) const;
  /// @brief Components of displacements along the axes, of a node, in a frame in which compliance knows offsets alone:
  /// r, phi and theta of a single body, which turn with it. Of several, whose frames turn against each other, it is the
  /// axes of the plane, and compliance that of nodes whose middle row is the lowest one: they turn less than half a
  /// spacing from there.
  [[nodiscard]] Eigen::Matrix3d to_frame(Eigen::Index node) const;
  /// @return [3 * displaced + component][3 * loaded + component] in that frame, of tables of three components
  [[nodiscard]] Eigen::MatrixXd compliance(const std::vector<Eigen::Index>& displaced,
                                           const std::vector<Eigen::Index>& loaded) const;

  /// @param[in] force of the plane at the nodes of the window
  /// @return displacements of the window by the opposite forces, for each part without its share
  [[nodiscard]] std::vector<HalfField> displaced(const VectorField& force) const;
  /// @return displacements along the axes by the forces of which those are
  [[nodiscard]] VectorField displacement(const std::vector<HalfField>& displaced) const;
  /// @return by how much those of some forces are more than `compliance` has them
  [[nodiscard]] VectorField excess(const VectorField& force, const std::vector<HalfField>& displaced) const;

 private:
  [[nodiscard]] bool is_single() const { return parts_.size() == 1; }

  std::vector<Part> parts_;
  std::function<void()> checkpoint_;
};

}  // namespace viscoroll::detail

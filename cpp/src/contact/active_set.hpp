/// @file
/// @brief Active set for frictionless contact, independent of the method that solves its linear systems.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace viscoroll::detail {

/// @brief Nodes in contact and the forces that press on them.
struct PressedNodes {
  Eigen::ArrayXd pressing;          ///< force on every node [N], 0 outside the contact
  std::vector<Eigen::Index> nodes;  ///< nodes in contact, ascending
  /// Penetration [m]; if a guess has none, it follows from the gaps under the forces of the guess.
  std::optional<double> penetration;
  Eigen::ArrayXd gap = {};  ///< gap of every node [m]
  /// Whether the gap belongs to the present forces and penetration; otherwise it is older, or empty.
  bool is_gap_current = false;
  /// Largest gap [m] that the residual of the last linear system leaves at a node in contact; 0 if it is negligible.
  double gap_error = 0.0;
  int passes = 0;  ///< linear systems solved
  bool converged = false;
};

/// @brief A surface above a plane, with the linear system that presses given nodes flat against the plane.
class PressedSurface {
 public:
  virtual ~PressedSurface() = default;

  /// @brief Find the penetration and the forces at which the gap of the nodes in contact is 0 and the forces sum to the
  /// load.
  /// @param[in,out] contact nodes in contact; initial forces and penetration, replaced by the solution
  /// @param[in] tolerance relative residual
  virtual void press(PressedNodes& contact, double tolerance) = 0;

  /// @return height of every node above the plane at zero penetration, under the forces of `contact` [m]
  [[nodiscard]] virtual Eigen::ArrayXd height(const PressedNodes& contact) = 0;

  /// @return weight of the penetration at every node: 1, or the number of nodes that an unknown represents
  [[nodiscard]] virtual const Eigen::ArrayXd& weights() const = 0;

  /// @return force per displacement that it causes at its own node [N/m]
  [[nodiscard]] virtual double stiffness() const = 0;
};

/// @brief Limits and tolerances of the active set.
struct ActiveSetOptions {
  int max_passes;
  double first_tolerance;  ///< residual while the set still changes much
  double tightening;       ///< factor on the tolerance from pass to pass
  double tolerance;        ///< residual of the last passes
  /// Residual that all passes keep until the set no longer changes. If it is 0, the tolerance decreases from pass to
  /// pass until few nodes change.
  double settling_tolerance = 0.0;
  double unsettled = 0.0;  ///< fraction of nodes that may still leave or join
};

/// @brief Find the contact with an active set, which ends when the set no longer changes.
/// Each pass drops all tensile nodes and adds all overclosed ones. The first passes do both at once, which is fast but
/// may cycle; later passes add nodes only if there are none to drop. A node whose force and gap are both below the
/// residual would leave and join in every pass; later passes do not count it as a change.
/// @param[in,out] surface the surface, which may keep data between its linear systems
/// @param[in] guess initial contact
/// @param[in] options limits and tolerances
/// @throws ConvergenceError if no node is loaded
[[nodiscard]] PressedNodes find_contact(PressedSurface& surface, PressedNodes guess, const ActiveSetOptions& options);

}  // namespace viscoroll::detail

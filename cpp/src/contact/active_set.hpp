/// @file
/// @brief Who touches, where forces press alone: one active set, whatever solves its linear systems.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace viscoroll::detail {

/// @brief Nodes in contact and what presses them.
struct PressedNodes {
  Eigen::ArrayXd pressing;            ///< force on every node [N], 0 apart
  std::vector<Eigen::Index> nodes;    ///< in contact, ascending
  std::optional<double> penetration;  ///< [m]; none of a guess that leaves it to the gaps under its forces
  Eigen::ArrayXd gap = {};            ///< of every node [m]; may be of the pass before where none has left
  int passes = 0;                     ///< linear systems solved
  bool converged = false;
};

/// @brief A surface over a plane, and how nodes of it are pressed flat.
class PressedSurface {
 public:
  virtual ~PressedSurface() = default;

  /// @brief Find forces on the nodes and the penetration: gap = 0 there, and the load is borne.
  /// @param[in,out] contact nodes; forces and penetration to start from
  /// @param[in] tolerance of the residual, relative
  virtual void press(PressedNodes& contact, double tolerance) = 0;

  /// @return rise of every node above the plane at no penetration [m], by the forces on it
  [[nodiscard]] virtual Eigen::ArrayXd height(const PressedNodes& contact) = 0;

  /// @return what the penetration counts at every node: 1, but for nodes that stand for more than one
  [[nodiscard]] virtual const Eigen::ArrayXd& weights() const = 0;

  /// @return force per own displacement of a node [N/m]
  [[nodiscard]] virtual double stiffness() const = 0;
};

/// @brief How far passes go.
struct ActiveSetOptions {
  int most_passes;
  double first_tolerance;  ///< of residuals, while the set is far from the right one
  double tightening;       ///< of the tolerance from pass to pass
  double tolerance;        ///< of the last ones
  double unsettled = 0.0;  ///< share of nodes that may be about to leave or join
};

/// @brief Active set, until nothing changes: drop all tensile nodes and add all overclosed ones, at first in the same
/// pass, which is quick but may cycle, then only when there are none to drop.
/// @param[in,out] surface and what it keeps for its systems
/// @param[in] guess to start from
/// @param[in] options limits
[[nodiscard]] PressedNodes find_contact(PressedSurface& surface, PressedNodes guess, const ActiveSetOptions& options);

}  // namespace viscoroll::detail

/// @file
/// @brief Interface between the search for stick and slip and its system of equations. Slip may be relative to upstream
/// neighbors or to the node's own position one step earlier.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief State of a node in contact.
struct TangentialState {
  bool stick;
  Eigen::Array2d direction;  ///< unit vector along the traction of a slipping node
  double rigidity;           ///< kappa = mu p / |t - k_t S| in [0, 1] of a slipping node; 1 without slip
};

/// @brief Nodes in contact in a step, and the state of each.
struct ContactSets {
  std::vector<Eigen::Index> contact;  ///< ascending
  std::vector<TangentialState> states;
};

/// @brief Stiffnesses that convert gaps and slips to forces [N/m].
struct ConditionScales {
  double normal;      ///< k_n
  double tangential;  ///< k_t
};

/// @brief Equations of contact, stick and slip on a surface, linear for given sets.
class StickSlipSystem {
 public:
  virtual ~StickSlipSystem() = default;

  [[nodiscard]] virtual ConditionScales scales() const = 0;
  /// @return sum of the pressing forces [N]
  [[nodiscard]] virtual double load() const = 0;
  /// @return number of the first node that may be in contact: earlier ones have no upstream neighbor
  [[nodiscard]] virtual Eigen::Index first_node() const = 0;
  /// @return violation of the conditions on load and drive by the forces of a state [N]
  [[nodiscard]] virtual double imbalance(const ContactSolution& state) const = 0;

  /// @brief Compute displacements, gaps and slips of all nodes from the forces, penetration and creepage of a state.
  virtual void find_displacements(ContactSolution& state) = 0;

  /// @brief Solve the conditions of given sets: stick, S = 0; slip, along e' normal to the direction e of a node, (1 -
  /// kappa) t . e' + kappa k_t S . e' = 0, which turns e towards -S.
  /// @param[in] friction coefficient of friction, which may be infinite
  /// @param[in] sets nodes in contact and their states
  /// @param[in] tolerance residual relative to that of `state`; direct solutions are exact
  /// @param[in,out] state forces, penetration, creepage, gaps and slips are replaced. If its displacements are empty
  /// afterwards, gaps and slips are those of the equations and 0 at other nodes. Values are not finite if there is no
  /// solution.
  virtual void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) = 0;

  /// @return number of operator applications so far
  [[nodiscard]] virtual int products() const = 0;
};

}  // namespace viscoroll::detail

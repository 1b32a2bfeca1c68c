/// @file
/// @brief What a contact with friction is to the search for its stick and slip: one system of equations, whatever way
/// nodes slip from, upstream neighbors or themselves a step ago, and whoever solves it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "contact/contact_solution.hpp"

namespace viscoroll::detail {

/// @brief What a node in contact does.
struct TangentialState {
  bool stick;
  Eigen::Array2d direction;  ///< of the traction of a slipping node, a unit vector
  double rigidity;           ///< kappa = mu p / |r| in [0, 1) of a slipping node: how much its direction may turn
};

/// @brief Sets of a step: a node for each state.
struct ContactSets {
  std::vector<Eigen::Index> contact;  ///< ascending
  std::vector<TangentialState> states;
};

/// @brief Forces per displacement by which conditions on gaps and slips are weighed against forces [N/m].
struct ConditionScales {
  double normal;
  double tangential;
};

/// @brief The equations of contact, stick and slip on a surface, linear once it is known who does what.
class StickSlipSystem {
 public:
  virtual ~StickSlipSystem() = default;

  [[nodiscard]] virtual ConditionScales scales() const = 0;
  /// @return sum of the pressing forces [N]
  [[nodiscard]] virtual double load() const = 0;
  /// @return number of the first node that may touch: those before it have no upstream neighbor
  [[nodiscard]] virtual Eigen::Index first_node() const = 0;
  /// @return how far the forces of a state are from the load and from what drives the body [N]
  [[nodiscard]] virtual double imbalance(const ContactSolution& state) const = 0;

  /// @brief Displacements, gaps and slips of all nodes by the forces, penetration and creepage of a state.
  virtual void find_displacements(ContactSolution& state) = 0;

  /// @brief Solve the conditions of given sets: stick, S = 0, and along a slipping node's e' normal to its direction e,
  /// (1 - kappa) t . e' + kappa c S . e' = 0, which turns e towards -S.
  /// @param[in] friction coefficient, which may be infinite
  /// @param[in] sets nodes in contact and what they do
  /// @param[in] tolerance of the residual, relative to that of `state`; a direct solution is exact
  /// @param[in,out] state forces, penetration, creepage, gaps and slips are replaced; without displacements
  /// afterwards, gaps and slips are those of the equations alone, and elsewhere 0. Not finite where there is no
  /// solution
  virtual void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) = 0;

  /// @return products with the compliance so far
  [[nodiscard]] virtual int products() const = 0;
};

}  // namespace viscoroll::detail

/// @file
/// @brief Contact with adhesion for one traction law: semismooth Newton method with three states of a node, contact,
/// cohesive zone and free. See docs/theory/adhesion.md.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "contact/contact_problem.hpp"
#include "contact/flat_equations.hpp"
#include "contact/traction_law.hpp"

namespace viscoroll::detail {

/// @brief Forces and penetration of a contact with adhesion, and the gaps that belong to them.
struct AdhesiveState {
  Eigen::ArrayXd pressing;         ///< force on every node [N]; negative in tension
  double penetration = 0.0;        ///< [m]
  Eigen::ArrayXd gap = {};         ///< gap of every node [m]; negative where the state overlaps
  std::vector<char> touches = {};  ///< whether a node is in contact, of every node
  double residual = 1.0;           ///< norm of the violated conditions, relative to that of the forces [-]
  bool converged = false;

  [[nodiscard]] double load() const { return pressing.sum(); }
};

/// @brief Newton's method on a window.
class AdhesiveNewton {
 public:
  /// @param[in] problem surface, initial gap, and load or penetration; must outlive this object
  /// @param[in] options limits
  AdhesiveNewton(const ContactProblem& problem, const ContactOptions& options);

  /// @brief Solve for forces and penetration under a law.
  /// @param[in] problem the problem of the constructor, or the same at another load or penetration
  /// @param[in] law traction law
  /// @param[in] start forces and penetration; their gaps are not used
  /// @return the last state, converged or not
  [[nodiscard]] AdhesiveState solve(const ContactProblem& problem, const TractionLaw& law, AdhesiveState start);

  /// @return nodes in contact, ascending
  [[nodiscard]] std::vector<Eigen::Index> touching(const TractionLaw& law, const AdhesiveState& state) const;
  /// @return nodes of the cohesive zone, ascending
  [[nodiscard]] std::vector<Eigen::Index> zone(const TractionLaw& law, const AdhesiveState& state) const;

  [[nodiscard]] int systems() const { return systems_; }
  [[nodiscard]] int products() const { return products_; }

 private:
  /// Pressure of the hard wall on a node, times its area [N].
  [[nodiscard]] double wall_force(const TractionLaw& law, const AdhesiveState& state, Eigen::Index node) const;
  [[nodiscard]] bool touches(const TractionLaw& law, const AdhesiveState& state, Eigen::Index node) const;
  [[nodiscard]] double violation(const TractionLaw& law, const AdhesiveState& state) const;
  [[nodiscard]] LawRows rows_of(const ContactProblem& problem, const TractionLaw& law,
                                const AdhesiveState& state) const;
  [[nodiscard]] AdhesiveState shorten(const TractionLaw& law, const AdhesiveState& from, const AdhesiveState& to) const;
  void find_gap(const ContactProblem& problem, AdhesiveState& state);

  const Attraction& attraction_;
  ContactOptions options_;
  bool mirrored_;
  double stiffness_;
  InverseConvolution inverse_;
  int systems_ = 0;
  int products_ = 0;
};

}  // namespace viscoroll::detail

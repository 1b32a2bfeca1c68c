/// @file
/// @brief Stick and slip of an instant, whose equations are solved by dense factors: contacts of some hundred nodes.
#pragma once

#include <vector>

#include "transient/matched_surfaces.hpp"
#include "transient/stick_slip_equations.hpp"

namespace viscoroll::detail {

/// @brief Factors of the nodes that touch, or did lately.
class MatchedByFactors final : public MatchedSurfaces {
 public:
  /// @param[in] problem which outlives this object
  /// @param[in] guess of the forces
  /// @param[in,out] stiffness of an earlier contact
  MatchedByFactors(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness);

  /// The equations hold to round-off, but that the center's may have moved since.
  [[nodiscard]] double imbalance(const ContactSolution&) const override { return imbalance_; }
  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override;
  void find_displacements(ContactSolution& state) override;

 private:
  MatchedByFactors(const StickSlipProblem& problem, const VectorField& guess, const std::vector<HalfField>& displaced,
                   ContactStiffness& stiffness);
  [[nodiscard]] std::vector<Condition> conditions(double friction, const ContactSets& sets) const;

  StickSlipEquations equations_;
  double imbalance_ = 0.0;
};

}  // namespace viscoroll::detail

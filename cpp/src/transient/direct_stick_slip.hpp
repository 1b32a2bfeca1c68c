/// @file
/// @brief Direct solver for stick and slip at an instant, with dense factors: for contacts of some hundred nodes.
#pragma once

#include <vector>

#include "transient/stick_slip_equations.hpp"
#include "transient/transient_stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief Direct stick-slip solver with factors of the nodes that are, or recently were, in contact.
class DirectStickSlip final : public TransientStickSlipSystem {
 public:
  /// @param[in] problem must outlive this object
  /// @param[in] guess forces to start from
  /// @param[in,out] stiffness of an earlier contact
  DirectStickSlip(const StickSlipProblem& problem, const VectorField& guess, ContactStiffness& stiffness);

  /// The equations hold to round-off, except that the condition of the center may have changed since.
  [[nodiscard]] double imbalance(const ContactSolution&) const override { return imbalance_; }
  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override;
  void find_displacements(ContactSolution& state) override;

 private:
  DirectStickSlip(const StickSlipProblem& problem, const VectorField& guess, const std::vector<HalfField>& displaced,
                  ContactStiffness& stiffness);
  [[nodiscard]] std::vector<Condition> conditions(double friction, const ContactSets& sets) const;

  StickSlipEquations equations_;
  double imbalance_ = 0.0;
};

}  // namespace viscoroll::detail

/// @file
/// @brief Iterative solver for stick and slip at an instant, with products with the compliance: for large contacts.
#pragma once

#include "transient/transient_stick_slip_system.hpp"

namespace viscoroll::detail {

/// @brief Iterative stick-slip solver: a Krylov method, about twenty products per system. The preconditioner contains
/// the own block of each node.
class IterativeStickSlip final : public TransientStickSlipSystem {
 public:
  /// @param[in] problem must outlive this object
  /// @param[in] guess forces to start from
  IterativeStickSlip(const StickSlipProblem& problem, const VectorField& guess);

  [[nodiscard]] double imbalance(const ContactSolution& state) const override;
  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override;

 private:
  class Equations;

  void take_off_apart(const ContactSets& sets, ContactSolution& state);
};

}  // namespace viscoroll::detail

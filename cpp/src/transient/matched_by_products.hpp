/// @file
/// @brief Stick and slip of an instant, whose equations are solved by products with the compliance: large contacts.
#pragma once

#include "transient/matched_surfaces.hpp"

namespace viscoroll::detail {

/// @brief Krylov's method, preconditioned as if nodes displaced themselves alone: some twenty products a system.
class MatchedByProducts final : public MatchedSurfaces {
 public:
  /// @param[in] problem which outlives this object
  /// @param[in] guess of the forces
  MatchedByProducts(const StickSlipProblem& problem, const VectorField& guess);

  [[nodiscard]] double imbalance(const ContactSolution& state) const override;
  void solve(double friction, const ContactSets& sets, double tolerance, ContactSolution& state) override;

 private:
  class Equations;

  void take_off_apart(const ContactSets& sets, ContactSolution& state);
};

}  // namespace viscoroll::detail

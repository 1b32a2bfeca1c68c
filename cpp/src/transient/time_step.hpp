/// @file
/// @brief Effect of one time step on the memory of a node whose force changes linearly in the step.
#pragma once

#include <vector>

#include "transient/creep_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Exponential integration of lambda_j a_j' + a_j = F. It is exact for forces that are linear in time, hence of
/// second order in the step. See docs/theory/transient.md.
struct TimeStep {
  /// Coefficients of a term of the spectrum: a_new = decay a + on_old F_old + on_new F_new. The energy that it
  /// dissipates is lost_change dF.K dF + lost_mixed dF.K e + lost_state e.K e with dF = F_new - F_old and e = F_old -
  /// a.
  struct Term {
    double weight;  ///< J_j
    double decay;
    double on_old;
    double on_new;
    double lost_change;
    double lost_mixed;
    double lost_state;
  };

  /// @param[in] spectrum spectrum of the coating
  /// @param[in] duration [s], 0 for a jump
  TimeStep(const CreepSpectrum& spectrum, double duration);

  double compliance;  ///< c = J_0 + sum J_j on_new: compliance for the new force at the end of the step
  std::vector<Term> terms;
};

/// @brief A step of all bodies.
struct PairStep {
  double duration;              ///< [s], 0 for a jump
  std::vector<TimeStep> parts;  ///< one for each body
};

}  // namespace viscoroll::detail

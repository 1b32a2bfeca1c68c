/// @file
/// @brief What one step of time does to the memory of a node whose force changes linearly in it.
#pragma once

#include <vector>

#include "transient/creep_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Exponential integration of lambda_j a_j' + a_j = F: exact for forces that are linear in time, so of second
/// order in the step. See docs/theory/transient.md.
struct TimeStep {
  /// What a term of the spectrum becomes: a_new = decay a + on_old F_old + on_new F_new, and the energy it loses,
  /// change dF.K dF + mixed dF.K e + state e.K e with dF = F_new - F_old and e = F_old - a.
  struct Term {
    double weight;  ///< J_j
    double decay;
    double on_old;
    double on_new;
    double lost_change;
    double lost_mixed;
    double lost_state;
  };

  /// @param[in] spectrum of the coating
  /// @param[in] duration [s], 0 for a jump
  TimeStep(const CreepSpectrum& spectrum, double duration);

  double compliance;  ///< c = J_0 + sum J_j on_new: share of the new force that has yielded at the end
  std::vector<Term> terms;
};

/// @brief A step of all bodies.
struct PairStep {
  double duration;              ///< [s], 0 for a jump
  std::vector<TimeStep> parts;  ///< one for each body
};

}  // namespace viscoroll::detail

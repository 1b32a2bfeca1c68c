/// @file
/// @brief Contact with adhesion at a given load of any sign, at a given penetration, or at the largest tension:
/// continuation in the range of the attraction, on meshes from coarse to fine. See docs/theory/adhesion.md.
#pragma once

#include <stdexcept>

#include "contact/contact_problem.hpp"
#include "contact/transfer.hpp"

namespace viscoroll::detail {

/// @brief The tension exceeds the largest one that the contact supports.
class LiftsOff : public std::runtime_error {
 public:
  /// @param[in] load load at the last state in contact [N]
  /// @param[in] penetration its penetration [m]
  LiftsOff(double load, double penetration)
      : std::runtime_error("the bodies separate"), load_(load), penetration_(penetration) {}

  [[nodiscard]] double load() const noexcept { return load_; }
  [[nodiscard]] double penetration() const noexcept { return penetration_; }

 private:
  double load_;
  double penetration_;
};

/// @brief Solve a contact with adhesion on the whole window of the problem.
/// @param[in] problem problem with an attraction, without friction
/// @param[in] contact_gap_limit undeformed gap below which nodes are assumed to be in contact at first [m]
/// @param[in] options limits
/// @throws LiftsOff if the bodies separate at the given load or penetration
/// @throws ConvergenceError if no state was found
[[nodiscard]] LocatedContact solve_adhesive_contact(const ContactProblem& problem, double contact_gap_limit,
                                                    const ContactOptions& options);

}  // namespace viscoroll::detail

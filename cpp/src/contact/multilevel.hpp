/// @file
/// @brief Contact on fine meshes: started from coarser ones, and solved on the box around the contact.
#pragma once

#include "contact/candidate_surface.hpp"
#include "contact/frictional_contact.hpp"
#include "contact/normal_contact.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {

/// @brief Frictionless contact. Small windows are solved as a whole; larger ones in a box around the contact that every
/// other node leads to, and so on: the number of Krylov iterations does not grow with the mesh.
/// @param[in] surface candidates
/// @param[in] load [N], > 0
/// @param[in] estimate radius of the contact [m], from above
/// @param[in] options limits
/// @param[in] execution threads and progress
[[nodiscard]] LocatedContact solve_multilevel(const CandidateSurface& surface, double load, double estimate,
                                              const ContactOptions& options, const Execution& execution);

/// @brief The same on the whole window, from a state there.
[[nodiscard]] LocatedContact solve_on_window(const ContactSolution& start, const CandidateSurface& surface, double load,
                                             const ContactOptions& options, const Execution& execution);

/// @brief How a contact with friction is loaded and moved.
struct FrictionalLoad {
  LoadCase load_case;
  SlipKinematics slip_kinematics;
};

/// @brief Contact with friction, by the same levels. A level that fails from the coarser one's state is started from
/// its own frictionless contact.
/// @param[in] surface candidates
/// @param[in] load load, friction and drive
/// @param[in] estimate radius of the contact [m], from above
/// @param[in] options limits
/// @param[in] execution threads and progress
/// @throws ConvergenceError where no state was found
/// @throws std::invalid_argument for a driving torque with which the sphere slides without end
[[nodiscard]] LocatedContact solve_multilevel(const CandidateSurface& surface, const FrictionalLoad& load,
                                              double estimate, const ContactOptions& options,
                                              const Execution& execution);

/// @brief Contact with friction from a frictionless one, or from a state with friction, on its own window.
[[nodiscard]] LocatedContact add_friction(LocatedContact start, const CandidateSurface& surface,
                                          const FrictionalLoad& load, const ContactOptions& options);

}  // namespace viscoroll::detail

/// @file
/// @brief One load case on one mesh, from input to result.
#pragma once

#include <optional>

#include "rolling/mesh_model.hpp"
#include "rolling/window_search.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief Solve one load case: tables, contact, powers. If the contact touches the edge of the window, the window
/// grows.
/// @param[in] model the bodies of the load case on a mesh
/// @param[in] given load case; the mesh and the accuracy of its options are ignored
/// @param[in] coarse_contact extent of the contact on a coarser mesh, if there is a result on one
/// @throws InvalidInput if the load presses the rolling body through its coating
/// @throws ConvergenceError if no contact was found
/// @throws MeshTooFine if the mesh needs too many nodes
[[nodiscard]] Result solve_load_case(const MeshModel& model, const RollingCase& given,
                                     const std::optional<ContactReach>& coarse_contact = std::nullopt);

/// @brief Solve one load case with the sets of contacting, sticking and slipping nodes of a state on the same mesh.
/// @throws InvalidInput if the state belongs to another mesh
/// @throws ConvergenceError if there is no solution near the state
[[nodiscard]] Result solve_frozen_case(const MeshModel& model, const RollingCase& given, const FrozenContact& state);

/// @brief Solve one load case without friction and losses from a similar state on the same mesh.
/// @throws the errors of `solve_load_case`
[[nodiscard]] Result solve_near(const MeshModel& model, const RollingCase& given, const FrozenContact& state);

}  // namespace viscoroll::detail

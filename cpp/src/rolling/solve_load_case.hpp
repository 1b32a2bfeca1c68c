/// @file
/// @brief One load case on one mesh, from input to result.
#pragma once

#include <optional>

#include "parallel.hpp"
#include "rolling/mesh_model.hpp"
#include "rolling/window_search.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief Solve one load case: tables, contact, powers. A window whose edge is touched grows.
/// @param[in] model of both bodies at the load case's speed, on a mesh
/// @param[in] load_case load, friction and drive
/// @param[in] options how to solve; its mesh and accuracy are not looked at
/// @param[in] watch progress and cancellation
/// @param[in] seen reach of the contact on a coarser mesh, where there was one
/// @throws std::invalid_argument where the load presses what rolls through its coating
/// @throws ConvergenceError where no contact was found
/// @throws MeshTooFine where the mesh needs too many nodes
[[nodiscard]] Result solve_load_case(const MeshModel& model, const LoadCase& load_case, const Options& options,
                                     Watch& watch, const std::optional<ContactReach>& seen = std::nullopt);

/// @brief The same with who touches, sticks and slips kept as in a state on that mesh.
/// @throws std::invalid_argument for a state that is not of that mesh
/// @throws ConvergenceError where there is no solution near the state
[[nodiscard]] Result solve_kept_case(const MeshModel& model, const LoadCase& load_case, const Options& options,
                                     Watch& watch, const KeptContact& state);

}  // namespace viscoroll::detail

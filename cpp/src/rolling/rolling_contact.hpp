/// @file
/// @brief One load case on one mesh, from input to result.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "parallel.hpp"
#include "rolling/mesh_model.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"

namespace viscoroll::detail {

/// @brief A mesh that makes more around the contact than can be held.
class MeshTooFine : public std::invalid_argument {
 public:
  /// @param[in] nodes_per_revolution of the mesh
  /// @param[in] most,made what can be held, and what the mesh makes
  MeshTooFine(int nodes_per_revolution, const std::string& most, const std::string& made);
};

/// @brief How far a contact reaches from the lowest node.
struct ContactReach {
  double along;   ///< upstream or downstream, the larger one [m]
  double across;  ///< to either side [m]
};

/// @return reach of the contact of a result
[[nodiscard]] ContactReach contact_reach(const Result& result);

/// @brief Solve one load case: tables, contact, powers. A window whose edge is touched grows.
/// @param[in] model coating at the load case's speed, on a mesh
/// @param[in] load_case load, friction and drive
/// @param[in] options how to solve; its mesh and accuracy are not looked at
/// @param[in] watch progress and cancellation
/// @param[in] seen reach of the contact on a coarser mesh, where there was one
/// @throws std::invalid_argument where the load presses the plane to the core
/// @throws MeshTooFine where the mesh needs too many nodes
[[nodiscard]] Result solve_load_case(const MeshModel& model, const LoadCase& load_case, const Options& options,
                                     Watch& watch, const std::optional<ContactReach>& seen = std::nullopt);

}  // namespace viscoroll::detail

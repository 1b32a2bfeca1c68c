/// @file
/// @brief One load case on one mesh, from input to result.
#pragma once

#include <Eigen/Core>

#include "modal/medium.hpp"
#include "parallel.hpp"
#include "viscoroll/solve.hpp"

namespace viscoroll::detail {

/// @brief Unknown forces of a dense matrix: 0.8 GB.
constexpr Eigen::Index kMaxUnknowns = 10000;

/// @brief Solve on the given mesh: spectrum, tables, contact, powers. A window whose edge is touched grows.
/// @param[in] coating layers at the harmonics 0 ... mesh.max_order
/// @param[in] load_case load and rolling speed
/// @param[in] mesh spacing and truncation
/// @param[in] options how to solve; its mesh and accuracy are not looked at
/// @param[in] watch progress and cancellation
/// @throws std::invalid_argument where the load presses the plane to the core or the mesh needs too many nodes
[[nodiscard]] Result solve_on_mesh(const HarmonicCoating& coating, const LoadCase& load_case, const Mesh& mesh,
                                   const Options& options, Watch& watch);

}  // namespace viscoroll::detail

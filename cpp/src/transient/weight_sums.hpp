/// @file
/// @brief Influence tables of layers that share no relaxation function: one set for each of their retardation times.
#pragma once

#include <memory>
#include <vector>

#include "influence/mesh_on_body.hpp"
#include "influence/table_sum.hpp"
#include "parallel.hpp"
#include "transient/layer_spectrum.hpp"

namespace viscoroll::detail {

/// @brief What the tables of every weight are summed from: as those of an elastic body, whose compliance it is.
/// @param[in] layers of a sphere or a plane
/// @param[in] mesh spacings
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @return of what yields at once, and of each retardation time
[[nodiscard]] std::vector<std::unique_ptr<const TableSum>> weights_under_spot(const LayerSpectrum& layers,
                                                                              const MeshOnBody& mesh, int threads,
                                                                              Watch& watch);

/// @return the same under a line, of a cylinder or a plane
[[nodiscard]] std::vector<std::unique_ptr<const TableSum>> weights_under_line(const LayerSpectrum& layers,
                                                                              const MeshOnBody& mesh, int threads,
                                                                              Watch& watch);

}  // namespace viscoroll::detail

/// @file
/// @brief Influence tables of layers with different relaxation functions: one set for each retardation time.
#pragma once

#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "influence/mesh_on_body.hpp"
#include "influence/table_sum.hpp"
#include "transient/layer_spectrum.hpp"

namespace viscoroll::detail {

/// @brief Sums for the tables of every weight, as for an elastic body with this weight as its compliance.
/// @param[in] layers layers of a sphere or a plane
/// @param[in] mesh spacings of the nodes
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @return sums for the instantaneous compliance and for each retardation time
[[nodiscard]] std::vector<std::unique_ptr<const TableSum>> weights_under_spot(const LayerSpectrum& layers,
                                                                              const MeshOnBody& mesh, int threads,
                                                                              Watch& watch);

/// @return the same sums in line contact, for a cylinder or a plane
[[nodiscard]] std::vector<std::unique_ptr<const TableSum>> weights_under_line(const LayerSpectrum& layers,
                                                                              const MeshOnBody& mesh, int threads,
                                                                              Watch& watch);

}  // namespace viscoroll::detail

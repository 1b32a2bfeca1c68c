/// @file
/// @brief What of a body its histories know: an elastic surface on rows of nodes, and how it creeps.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "rolling/body.hpp"
#include "transient/creep_spectrum.hpp"
#include "transient/mirrored_tables.hpp"

namespace viscoroll::detail {

/// @brief A body whose layers share one relaxation function, so that its displacements are those of an elastic one
/// under loads that creep.
struct CreepingBody {
  bool rolls;                        ///< it is what rolls, else what that rolls on
  CreepSpectrum spectrum;            ///< per the compliance at rest
  std::optional<Eigen::Index> ring;  ///< rows of nodes around it; none of a track
  MirroredTables tables;             ///< at rest
};

/// @brief The creep spectrum that all layers of a body share.
/// @param[in] layers at least one
/// @param[in] prefix what stands before their names in messages
/// @param[in] range in which continuous spectra are resolved
/// @throws std::invalid_argument where they do not, or a bulk modulus makes creep depend on the order
[[nodiscard]] CreepSpectrum common_spectrum(const std::vector<NamedLayer>& layers, std::string_view prefix,
                                            const TimeRange& range);

/// @return what rolls, with every modulus as it is at rest, without inertia
[[nodiscard]] RollingBody at_rest(const RollingBody& body);
/// @return what it rolls on, likewise
[[nodiscard]] Counterpart at_rest(const Counterpart& on);

}  // namespace viscoroll::detail

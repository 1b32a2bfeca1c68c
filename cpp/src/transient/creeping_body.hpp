/// @file
/// @brief What of a body its histories know: an elastic surface on rows of nodes, and how it creeps.
#pragma once

#include <optional>
#include <vector>

#include "rolling/body.hpp"
#include "transient/creep_spectrum.hpp"
#include "transient/creeping_tables.hpp"

namespace viscoroll::detail {

/// @brief A body whose displacements are those of elastic ones under loads that creep: of one, where its layers share a
/// relaxation function, else of one for each retardation time.
struct CreepingBody {
  bool rolls;                        ///< it is what rolls, else what that rolls on
  CreepSpectrum spectrum;            ///< per what its tables displace; of tables for each time all weights are 1
  std::optional<Eigen::Index> ring;  ///< rows of nodes around it; none of a track
  CreepingTables tables;

  /// @return parts of a force that have yielded, for each of the tables: of one that has just come,
  [[nodiscard]] std::vector<double> parts_at_once() const;
  /// @return of one that has been there for ever,
  [[nodiscard]] std::vector<double> parts_at_rest() const;
  /// @return and of what a force changes by in a step, at its end
  [[nodiscard]] std::vector<double> parts_after(const TimeStep& step) const;
};

/// @return whether layers creep alike at every order: they share one relaxation function, and no bulk modulus
/// @param[in] layers at least one
/// @param[in] range of the times at which they are compared
[[nodiscard]] bool creep_alike(const std::vector<NamedLayer>& layers, const TimeRange& range);

/// @return what rolls, with every modulus as it is at rest, without inertia
[[nodiscard]] RollingBody at_rest(const RollingBody& body);
/// @return what it rolls on, likewise
[[nodiscard]] Counterpart at_rest(const Counterpart& on);

}  // namespace viscoroll::detail

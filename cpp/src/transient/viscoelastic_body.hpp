/// @file
/// @brief A viscoelastic body in transient rolling: elastic surface on rows of nodes, and its creep.
#pragma once

#include <optional>
#include <vector>

#include "rolling/body.hpp"
#include "transient/creep_spectrum.hpp"
#include "transient/creep_tables.hpp"

namespace viscoroll::detail {

/// @brief Body whose displacements are those of elastic bodies under retarded forces: of one elastic body if its layers
/// share one relaxation function, else of one for each retardation time.
struct ViscoelasticBody {
  bool rolls;                        ///< whether it is the rolling body, else the counterbody
  CreepSpectrum spectrum;            ///< relative to the tables; all weights are 1 if every time has its own table
  std::optional<Eigen::Index> ring;  ///< number of rows around the body; none for a track
  CreepTables tables;

  /// @return compliance factor of each table for a force that has just been applied
  [[nodiscard]] std::vector<double> instantaneous_factors() const;
  /// @return compliance factor of each table for a force that has acted for an infinite time
  [[nodiscard]] std::vector<double> relaxed_factors() const;
  /// @return compliance factor of each table for the change of a force in a step, at the end of the step
  [[nodiscard]] std::vector<double> step_factors(const TimeStep& step) const;
};

/// @brief Whether all orders of the layers creep in the same way: the layers share one relaxation function, and no
/// viscoelastic layer has a bulk modulus.
/// @param[in] layers at least one
/// @param[in] range times at which they are compared
[[nodiscard]] bool creep_identically(const std::vector<NamedLayer>& layers, const TimeRange& range);

/// @return the rolling body with relaxed moduli, without inertia
[[nodiscard]] RollingBody with_relaxed_moduli(const RollingBody& body);
/// @return the counterbody with relaxed moduli, without inertia
[[nodiscard]] Counterbody with_relaxed_moduli(const Counterbody& on);

}  // namespace viscoroll::detail

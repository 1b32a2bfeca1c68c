/// @file
/// @brief Two bodies that roll on one another, and what both together are.
#pragma once

#include <memory>
#include <vector>

#include "rolling/body.hpp"

namespace viscoroll::detail {

/// @brief The rolling body and the counterbody. Copies share them.
struct RollingPair {
  std::shared_ptr<const RoundBody> body;
  std::shared_ptr<const Body> on;
};

/// @throws std::invalid_argument naming parameter, value, unit and range, where a body is none or the two cannot roll
/// on one another
[[nodiscard]] RollingPair rolling_pair(const RollingBody& body, const Counterpart& on);

/// @return nodes of a mesh on what rolls, where neither surface has turned by more than 60 degrees
[[nodiscard]] Nodes nodes_of(const RollingPair& pair, const Mesh& mesh);

/// @brief How the material of both crosses the contact.
/// @param[in] pair both bodies
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] mesh spacing and truncation
/// @param[in] curvature what is kept of it in the equations of the layers
/// @param[in] execution of the sums
/// @param[in] inertia_tolerance relative error of the compliance that may be left of inertia
[[nodiscard]] Crossing crossing_of(const RollingPair& pair, double angular_speed, const Mesh& mesh, Curvature curvature,
                                   const Execution& execution, double inertia_tolerance);

/// @return R of 1/R = 1/R_1 + 1/R_2 along the path [m]
[[nodiscard]] double relative_radius(const RollingPair& pair);

/// @return across, within which they touch; infinite where neither has sides [m]
[[nodiscard]] double width(const RollingPair& pair);

/// @return all layers of both, those of the body first
[[nodiscard]] std::vector<NamedLayer> layers(const RollingPair& pair);

/// @return whether displacements are those from a place that rests
[[nodiscard]] bool approach_exists(const RollingPair& pair);

/// @return thickness of all of them together [m], maybe infinite
[[nodiscard]] double thickness(const RollingPair& pair);

/// @return the same without half-spaces [m]
[[nodiscard]] double layer_thickness(const RollingPair& pair);

/// @return how soft a half-space is, beside the softest layer, at rest: from 0, rigid or none, to 1
[[nodiscard]] double half_space_share(const RollingPair& pair);

}  // namespace viscoroll::detail

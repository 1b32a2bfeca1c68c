/// @file
/// @brief Two bodies that roll on one another, and properties of the pair.
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

/// @brief Check and combine both bodies.
/// @throws InvalidInput with parameter, value, unit and range, if a body is invalid or the two cannot roll on
/// one another
[[nodiscard]] RollingPair rolling_pair(const RollingBody& body, const Counterbody& on);

/// @return nodes of a mesh on the rolling body at which neither surface has turned by more than 60 degrees
[[nodiscard]] Nodes nodes_of(const RollingPair& pair, const Mesh& mesh);

/// @return motion of both surfaces at an angular speed Omega [rad/s], > 0
[[nodiscard]] SurfaceMotion motion_of(const RollingPair& pair, double angular_speed, Curvature curvature);

/// @brief Motion of the material of both bodies through the contact.
/// @param[in] pair both bodies
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] mesh spacing and truncation
/// @param[in] curvature curvature terms retained in the layer equations
/// @param[in] execution threads, progress and cancellation
/// @param[in] needs results for which tables are computed
[[nodiscard]] ContactKinematics kinematics_of(const RollingPair& pair, double angular_speed, const Mesh& mesh,
                                              Curvature curvature, const Execution& execution, const TableNeeds& needs);

/// @return relative radius R along the path, 1/R = 1/R_1 + 1/R_2 [m]
[[nodiscard]] double relative_radius(const RollingPair& pair);

/// @return width within which the bodies can touch; infinite if neither has side faces [m]
[[nodiscard]] double width(const RollingPair& pair);

/// @return all layers of both bodies, those of the rolling body first
[[nodiscard]] std::vector<NamedLayer> layers(const RollingPair& pair);

/// @return whether displacements are relative to a place at rest, so that the approach of the bodies is defined
[[nodiscard]] bool approach_exists(const RollingPair& pair);

/// @return total thickness of all layers [m]; infinite with a half-space
[[nodiscard]] double thickness(const RollingPair& pair);

/// @return total thickness without half-spaces [m]
[[nodiscard]] double layer_thickness(const RollingPair& pair);

/// @param[in] pair rolling body and counterbody
/// @param[in] angular_speed angular speed of the rolling body [rad/s]
/// @return ratio of the compliance of the half-space to that of the softest layer at rest, at most 1; 0 without a
/// half-space
[[nodiscard]] double half_space_share(const RollingPair& pair, double angular_speed);

}  // namespace viscoroll::detail

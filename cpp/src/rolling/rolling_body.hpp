/// @file
/// @brief What spheres and rollers, and what they roll on, have in common.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "viscoroll/rolling_body.hpp"

namespace viscoroll::detail {

/// @brief Two bodies that roll on one another.
struct RollingPair {
  RollingBody body;
  Counterpart on;
};

/// @brief A layer that deforms, with its name in messages.
struct NamedLayer {
  std::string name;
  Layer layer;
};

[[nodiscard]] double outer_radius(const RollingBody& body);

/// @return whether the contact is a line, and loads are per length
[[nodiscard]] bool is_roller(const RollingBody& body);

/// @return its name in messages
[[nodiscard]] std::string_view name(const RollingBody& body);
/// @return unit of its load
[[nodiscard]] std::string_view load_unit(const RollingBody& body);

/// @return whether nothing of it deforms
[[nodiscard]] bool is_rigid(const RollingBody& body);
[[nodiscard]] bool is_rigid(const Counterpart& on);

/// @return radius of the counterpart [m], infinite for a plane
[[nodiscard]] double radius_of(const Counterpart& on);

/// @return R of 1/R = 1/R_1 + 1/R_2 [m]
[[nodiscard]] double relative_radius(const RollingPair& pair);

/// @return curvature of the counterpart along the path [1/m]: > 0 of a roller, < 0 where the path is hollow
[[nodiscard]] double counterpart_curvature(const RollingPair& pair);

/// @return the plane, or the groove's surface, that a ball rolls on
[[nodiscard]] const CoatedPlane& plane_of(const Counterpart& on);

/// @brief Curvature of what a ball rolls on, > 0 where it is hollow [1/m].
struct TrackCurvature {
  double along = 0.0;
  double across = 0.0;
};
[[nodiscard]] TrackCurvature track_curvature(const Counterpart& on);

/// @return all layers of both; a half-space is one of infinite thickness
[[nodiscard]] std::vector<NamedLayer> layers(const RollingPair& pair);

/// @return thickness of all of them together [m], maybe infinite
[[nodiscard]] double thickness(const RollingPair& pair);

/// @return the same without half-spaces [m]
[[nodiscard]] double layer_thickness(const RollingPair& pair);

/// @return how soft a half-space is, beside the softest layer, at rest: from 0, rigid or none, to 1
[[nodiscard]] double half_space_share(const RollingPair& pair);

/// @brief Check both bodies, and that they can roll on one another.
/// @throws std::invalid_argument naming parameter, value, unit and range
void validate(const RollingPair& pair);

}  // namespace viscoroll::detail

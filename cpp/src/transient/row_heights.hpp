/// @file
/// @brief Heights of the ground and of the tread at the rows of nodes: docs/theory/ground.md.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "surface/surface_window.hpp"
#include "transient/numbers.hpp"
#include "viscoroll/profile.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

/// @brief Heights at consecutive rows [m]. Both arrays are empty if ground and tread are smooth.
struct RowHeights {
  Eigen::ArrayXd ground;
  Eigen::ArrayXd tread;
};

/// @brief Rows of one of the phase-shifted meshes, and their position along the track.
struct TrackRows {
  Eigen::Index first;  ///< number of the first row
  Eigen::Index count;
  double shift;  ///< of the nodes at angle 0 [spacings]
  /// Distance by which the center has moved farther than the body has rolled [m]; the ground moves against the rows by
  /// this distance.
  double ahead;
};

/// @brief Profiles of the ground and of the tread. Row I of either body lies at the distance -(I + shift) * spacing *
/// r_o along the track, where row I of the other body meets it.
class SurfaceHeights {
 public:
  /// @param[in] options both profiles
  /// @param[in] grid nodes of the rolling body
  /// @throws InvalidInput if the tread does not fit around the body
  SurfaceHeights(const HistoryOptions& options, const SurfaceGrid& grid);

  /// @return whether all heights are 0
  [[nodiscard]] bool are_smooth() const { return !ground_ && !tread_; }
  /// @return largest possible sum of the heights of ground and tread [m]
  [[nodiscard]] double largest() const { return largest_; }
  /// @return heights at some rows
  [[nodiscard]] RowHeights at(const TrackRows& rows) const;

  /// @brief Write numbers that identify both profiles.
  void write(NumberWriter& numbers) const;
  /// @brief Read what `write` has written.
  /// @throws InvalidInput if the profiles are others
  void require_same(NumberReader& numbers) const;

 private:
  SurfaceGrid grid_;
  Eigen::Index rows_around_;  // rows around the rolling body
  std::optional<HeightProfile> ground_;
  std::optional<HeightProfile> tread_;
  double largest_ = 0.0;
};

}  // namespace viscoroll::detail

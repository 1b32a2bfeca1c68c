/// @file
/// @brief Displacement, strain, stress and dissipation inside the layers under a sliding rough surface.
///
/// The components are those of interior.hpp: r is the outward normal of the plane, phi points against the direction x
/// in which the surface slides, and theta against z. See docs/theory/inside.md.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "viscoroll/interior.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sliding.hpp"

namespace viscoroll {

/// @brief Tractions of a sliding rough surface on the layers. Node (i, j) is at x = i spacing_x, z = j spacing_z.
struct SlidingTractions {
  int rows = 0;                  ///< nodes along x, >= 3
  int columns = 1;               ///< nodes along z, >= 1; with 1, a line contact in plane strain
  double spacing_x = 0.0;        ///< distance of the nodes along x [m], > 0
  double spacing_z = 0.0;        ///< distance of the nodes along z [m], > 0; no effect in line contact
  bool periodic = true;          ///< whether the tractions repeat themselves in both directions
  std::vector<double> pressure;  ///< pressure at every node [Pa], row-major [x][z]
  double friction = 0.0;         ///< shear traction on the layers along x per pressure [-], >= 0
};

/// @brief Tractions of a solution.
/// @param[in] map rough surface
/// @param[in] result solution
/// @param[in] friction coefficient of friction of the solution [-]
/// @return the tractions
[[nodiscard]] SlidingTractions tractions_of(const HeightMap& map, const SlidingResult& result, double friction = 0.0);

/// @brief Fields on surfaces of equal depth.
struct SlidingFields {
  std::vector<Place> places;  ///< surfaces, in the order of the argument
  std::vector<double> x;      ///< positions along x [m]
  std::vector<double> z;      ///< positions along z [m]
  /// Displacement [m], stress [Pa] and strain [-], row-major [place][component][x][z].
  std::vector<double> values;
};

/// @brief Fields inside the layers under a sliding surface.
///
/// The fields of periodic tractions are the sum over all waves of the pressure at the nodes: the wave with the mean
/// pressure, of which an unbounded layer also has a stress along the surface, and all others. The displacement of a
/// half-space under the mean pressure is infinite; the displacement is then relative to the mean displacement of the
/// surface. Other tractions are constant on the patch of each node, see `interior_fields`.
/// @param[in] on layers and base, not rigid
/// @param[in] speed sliding speed along x [m/s], >= 0; at 0 the layers are relaxed
/// @param[in] tractions tractions on the layers
/// @param[in] places positions along the normal
/// @param[in] x,z positions along the surface [m]; unless the tractions are periodic, within a distance of the middle
/// that is 4/3 of the longer side; z has no effect in line contact
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] observer progress and cancellation
/// @return the fields at all places
/// @throws InvalidInput for invalid input
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] SlidingFields sliding_fields(const CoatedPlane& on, double speed, const SlidingTractions& tractions,
                                           std::span<const Place> places, std::span<const double> x,
                                           std::span<const double> z, int threads = 0, const Observer& observer = {});

/// @brief Energy and power dissipated inside the layers; in line contact, powers are per unit length.
struct SlidingLoss {
  std::vector<Place> places;  ///< the requested places; if none were requested, those of the volume integral
  /// Positions along z [m]: the nodes of periodic tractions, else equally spaced positions beyond the map on both
  /// sides; 0 in line contact.
  std::vector<double> z;
  std::vector<double> density;     ///< w(depth, z) per volume and passage of the map [J/m^3], [place][z]
  std::vector<double> frequency;   ///< angular frequencies of the waves along x [rad/s], ascending
  std::vector<double> wave_power;  ///< power dissipated in each layer by each wave along x [W], [layer][wave]
  double track_distance = 0.0;     ///< period along z [m]: of the tractions, or the distance of parallel tracks
  double volume_power = 0.0;       ///< volume integral of the dissipated power [W]
  double surface_power = 0.0;      ///< power of the tractions at the surface, from the same waves [W]
};

/// @brief Energy dissipated per volume and passage of the map.
///
/// The loss of periodic tractions contains all waves that the power of `SlidingResult` contains. That of other
/// tractions is an integral over waves up to a highest order, with parallel tracks at a distance of at least four times
/// the longer side of the map.
/// @param[in] on,speed,tractions same as in `sliding_fields`
/// @param[in] places places at which w is returned; empty: the places of the volume integral
/// @param[in] shortest_wave shortest wavelength of the sum [m], > 0, at most four times the longer side; no effect on
/// periodic tractions
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] observer progress and cancellation
/// @return density and powers
/// @throws InvalidInput for invalid input
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] SlidingLoss sliding_loss(const CoatedPlane& on, double speed, const SlidingTractions& tractions,
                                       std::span<const Place> places, double shortest_wave, int threads = 0,
                                       const Observer& observer = {});

}  // namespace viscoroll

/// @file
/// @brief Steady sliding of a rigid rough surface on viscoelastic layers. See docs/theory/sliding.md.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "viscoroll/observer.hpp"
#include "viscoroll/plane.hpp"

namespace viscoroll {

/// @brief A rigid rough surface, as heights at equal distances: one period, or a surface of finite size.
///
/// x is the direction in which the surface slides, z the direction across. A profile that is constant along z has one
/// column, and its contact is a line contact in plane strain.
struct HeightMap {
  std::vector<double> heights;  ///< heights towards the layers [m], row-major [x][z]
  int rows = 0;                 ///< nodes along x, in [8, 16384]
  int columns = 1;              ///< nodes along z, 1 or in [8, 16384]
  double spacing_x = 0.0;       ///< distance of the nodes along x [m], > 0
  double spacing_z = 0.0;       ///< distance of the nodes along z [m], > 0; no effect on a profile
  /// Whether the surface repeats itself in both directions. If not, the layers are free around it.
  bool periodic = true;
};

/// @brief Check a height map.
/// @throws InvalidInput naming parameter, value, unit and range
void validate(const HeightMap& map);

/// @brief Options of sliding.
struct SlidingOptions {
  double friction = 0.0;     ///< Coulomb's coefficient of friction at the interface [-], >= 0
  double tolerance = 1e-9;   ///< relative residual of the contact equations, in [1e-13, 1e-3]
  int max_iterations = 200;  ///< largest number of linear systems on a mesh, >= 1
  int threads = 0;           ///< number of threads, 0 for all cores
  Observer observer;         ///< progress and cancellation
};

/// @brief Scalar results in SI units. The members have the names in `sliding_scalars.def`.
struct SlidingScalars {
#define VISCOROLL_SLIDING_SCALAR(type, name, unit, label, details) type name{};
#include "viscoroll/sliding_scalars.def"
#undef VISCOROLL_SLIDING_SCALAR
};

/// @brief Steady contact of a sliding rough surface.
struct SlidingResult : SlidingScalars {
  bool converged = false;        ///< whether all contact conditions are satisfied
  std::vector<double> pressure;  ///< pressure at every node [Pa], in the order of the heights, >= 0
  std::vector<double> gap;       ///< distance of the surfaces at every node [m], in the order of the heights
};

/// @brief Solve the contact of a rigid rough surface that slides steadily on a plane.
///
/// At speed 0 the layers are relaxed. With friction, all nodes in contact slip, and the friction pulls the layers
/// along.
/// @param[in] map rough surface
/// @param[in] on layers and base, not rigid
/// @param[in] pressure mean pressure over the map [Pa], > 0
/// @param[in] speed sliding speed along x [m/s], >= 0; > 0 with friction
/// @param[in] options friction, tolerances, threads, progress and cancellation
/// @throws InvalidInput for invalid input
/// @throws ConvergenceError if the solver found no usable state
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] SlidingResult slide(const HeightMap& map, const CoatedPlane& on, double pressure, double speed,
                                  const SlidingOptions& options = {});

/// @brief Estimate by Persson's theory, to be compared with `SlidingResult`.
struct PerssonEstimate {
  double friction_coefficient;  ///< [-]
  double contact_share;         ///< real contact area per nominal area [-]
};

/// @brief Estimate friction and contact area by Persson's theory, from the spectrum of a surface.
///
/// With the spectrum h_k and the compliance C, the share of contact up to the wave number q is
/// A(q) = erf(p / sqrt(2 sum_{|k| <= q} |h_k / C_k|^2)), and the friction coefficient is
/// sum |h_k|^2 |k_x Im(1/C_k)| A(k) S(k) / p with S = gamma + (1 - gamma) A^2. See B. N. J. Persson, J. Chem. Phys. 115
/// (2001) 3840-3861, and M. Scaraggi and B. N. J. Persson, J. Phys.: Condens. Matter 27 (2015) 105102 for S.
/// @param[in] map,on,pressure,speed,options same as in `slide`; the map must be periodic, and friction has no effect
/// @param[in] gamma parameter of the reduction factor S, in [0, 1]; 1/2 is usual, 1 is the theory without reduction
/// @throws InvalidInput for invalid input
[[nodiscard]] PerssonEstimate persson_estimate(const HeightMap& map, const CoatedPlane& on, double pressure,
                                               double speed, double gamma = 0.5, const SlidingOptions& options = {});

}  // namespace viscoroll

/// @file
/// @brief Compliance of the layers for the waves of a periodic surface, and its influence table.
#pragma once

#include <complex>
#include <vector>

#include "base/parallel.hpp"
#include "influence/spectral_product.hpp"
#include "influence/table.hpp"
#include "modal/layered_body.hpp"
#include "viscoroll/plane.hpp"

namespace viscoroll::detail {

/// @brief Period of a rough surface. Rows follow one another along xi, against the sliding direction: material crosses
/// the surface from row to row.
struct SlidingPeriod {
  WindowShape nodes;
  double length_x;  ///< [m]
  double length_z;  ///< [m]

  [[nodiscard]] bool is_line() const { return nodes.theta_nodes == 1; }
  /// @return area of the patch of a node [m^2]; per length of a profile, its length [m]
  [[nodiscard]] double patch_area() const;
  /// @return wave number along xi of the i-th wave, or along z of the j-th wave [1/m]
  [[nodiscard]] double k_x(int i) const;
  [[nodiscard]] double k_z(int j) const;
};

/// @brief Displacement per pressure of the waves (i, j), C(k_x, k_z; V k_x). The waves follow the material's frame, in
/// which wave i has the frequency V k_x; waves along z alone, and all waves at rest, meet relaxed layers.
class SlidingSymbol {
 public:
  /// @param[in] on checked plane, not rigid
  /// @param[in] period period
  /// @param[in] speed sliding speed [m/s], >= 0
  /// @param[in] friction Coulomb's coefficient at the interface, >= 0: the friction, this multiple of the pressure,
  /// also displaces the surface
  /// @param[in] threads,watch threads, progress and cancellation
  SlidingSymbol(const CoatedPlane& on, const SlidingPeriod& period, double speed, double friction, int threads,
                Watch& watch);

  [[nodiscard]] const SlidingPeriod& period() const { return period_; }

  /// @param[in] i wave along xi, in [-n/2, n/2]; negative waves are complex conjugates
  /// @param[in] j wave along z, in [0, n/2]
  /// @return compliance [m/Pa]; that of (0, 0) is a positive stand-in, see `table`
  [[nodiscard]] std::complex<double> operator()(int i, int j) const { return value(values_, i, j); }
  /// @brief Compliance whose imaginary part gives the loss in the layers, due to pressure and friction together.
  /// Reciprocity, C_phir = -C_rphi, cancels the work of either at the displacement due to the other.
  [[nodiscard]] std::complex<double> of_losses(int i, int j) const {
    return value(losses_.empty() ? values_ : losses_, i, j);
  }

  /// @brief Periodic influence table of the surface [m/N].
  /// The mean pressure only shifts the mean displacement, on which neither pressure nor gap depends, since the load is
  /// given. The compliance of the wave (0, 0), infinite on a half-space and 0 on incompressible layers, is therefore
  /// replaced by that of the longest wave, which keeps the linear systems regular.
  [[nodiscard]] Table table() const;

 private:
  [[nodiscard]] std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(period_.nodes.theta_nodes / 2 + 1) +
           static_cast<std::size_t>(j);
  }
  [[nodiscard]] std::complex<double> value(const std::vector<std::complex<double>>& values, int i, int j) const {
    const std::complex<double> value = values[place(i < 0 ? -i : i, j)];
    return i < 0 ? std::conj(value) : value;
  }

  SlidingPeriod period_;
  std::vector<std::complex<double>> values_;  // [i][j]
  std::vector<std::complex<double>> losses_;  // [i][j]; empty without friction
};

/// Angular speed of relaxed layers, whose compliance does not depend on it [rad/s].
inline constexpr double kAnySpeed = 1.0;

/// @return the body at rest, with relaxed moduli
[[nodiscard]] LayeredBody relaxed_layers(LayeredBody body);

/// @brief Distance in which the slowest layer recovers: speed times its retardation time, estimated at the frequency of
/// a wave [m].
/// @param[in] on layers and base
/// @param[in] speed sliding speed [m/s], >= 0
/// @param[in] wavelength wavelength along the path [m]
/// @param[in] highest_frequency frequency at which a `CustomModulus` is evaluated in place of its short-time limit
[[nodiscard]] double memory_length(const CoatedPlane& on, double speed, double wavelength, double highest_frequency);

}  // namespace viscoroll::detail

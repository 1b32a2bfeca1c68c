/// @file
/// @brief What happens inside the coating under tractions that are known: displacement, strain, stress, and loss.
///
/// Components are those along r, phi and theta, of tensors rr, phiphi, thetatheta, rphi, rtheta and phitheta; stress is
/// positive in tension. Theory.md section 10.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "viscoroll/formulation.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"
#include "viscoroll/sphere.hpp"

namespace viscoroll {

/// @brief A radius in a layer. Three of the stresses and of the strains jump where layers meet: there both have it.
struct Place {
  double radius = 0.0;  ///< r [m], in the closed layer
  int layer = 0;        ///< number of the layer, from the center outwards

  friend bool operator==(const Place&, const Place&) = default;
};

/// @brief Components of the fields: displacement (3), stress (6) and strain (6).
inline constexpr std::size_t kFieldComponents = 15;

/// @brief Places at radii: two where layers meet, the outer layer's first.
/// @param[in] sphere core and layers
/// @param[in] radii [m], each within the layers and > 0
/// @throws std::invalid_argument for bad input
[[nodiscard]] std::vector<Place> places_at(const CoatedSphere& sphere, std::span<const double> radii);

/// @brief Fields of single orders (m, n) per unit surface stress: displacement [m/Pa], stress [-] and strain [1/Pa].
/// @param[in] sphere core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] m,n orders of any sign, as many of the one as of the other
/// @param[in] places where
/// @param[in] curvature sphere or paper
/// @param[in] observer progress and cancellation
/// @return row-major [order][place][component][surface stress along r, phi, theta]
/// @throws std::invalid_argument for bad input
/// @throws Cancelled where the observer stopped it
[[nodiscard]] std::vector<std::complex<double>> order_fields(const CoatedSphere& sphere, double angular_speed,
                                                             std::span<const int> m, std::span<const int> n,
                                                             std::span<const Place> places,
                                                             Curvature curvature = Curvature::sphere,
                                                             const Observer& observer = {});

/// @brief What the plane does to the coating, and in which model: a solved contact.
struct Tractions {
  Mesh mesh;                                   ///< on whose nodes they are
  int phi_nodes = 0;                           ///< rows of the window
  int theta_nodes = 0;                         ///< columns of the window
  std::vector<double> pressure;                ///< [Pa], [phi][theta]
  std::vector<double> shear_traction;          ///< along x and z [Pa], [2][phi][theta]
  bool friction = false;                       ///< whether there are shear tractions
  Compliance compliance = Compliance::radial;  ///< along which normals the pressure acts
  Curvature curvature = Curvature::sphere;     ///< sphere or paper
  PatchLoad patch_load = PatchLoad::flat;      ///< how a patch is loaded
};

/// @return the tractions of a solution
/// @param[in] result solution
/// @param[in] load_case,options of the solve
[[nodiscard]] Tractions tractions_of(const Result& result, const LoadCase& load_case, const Options& options = {});

/// @brief Fields on surfaces r = const.
struct InteriorFields {
  std::vector<Place> places;  ///< surfaces, in the order asked for
  std::vector<double> phi;    ///< [rad]
  std::vector<double> theta;  ///< [rad]
  /// Displacement [m], stress [Pa] and strain [-], row-major [place][component][phi][theta].
  std::vector<double> values;
};

/// @brief Fields inside the coating, by the sum over orders of what the tractions make there. Above a quarter of a
/// spacing below the surface they are those of the patches, not of a smooth pressure.
/// @param[in] sphere core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] tractions of the plane
/// @param[in] places where along r
/// @param[in] phi,theta where along the surface [rad], within half a revolution of the lowest point, pi/2
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] observer progress and cancellation
/// @throws std::invalid_argument for bad input
/// @throws Cancelled where the observer stopped it
[[nodiscard]] InteriorFields interior_fields(const CoatedSphere& sphere, double angular_speed,
                                             const Tractions& tractions, std::span<const Place> places,
                                             std::span<const double> phi, std::span<const double> theta,
                                             int threads = 0, const Observer& observer = {});

/// @brief Energy lost inside the coating, of the orders |m|, |n| <= max_order.
struct LossDensity {
  std::vector<Place> places;           ///< asked for, or those of the volume integral
  std::vector<double> radial_weights;  ///< dr of each place in the volume integral [m]; 0 where it was asked for
  std::vector<double> theta;           ///< once around the torus from -pi/2, at equal spacings [rad]
  std::vector<double> density;         ///< w(r, theta), per volume and revolution [J/m^3], [place][theta]
  std::vector<double> order_power;     ///< lost in each layer by each order m = 0 ... max_order [W], [layer][m]
  double volume_power = 0.0;           ///< Omega times the volume integral of w, in which there is no sin(theta) [W]
  double surface_power = 0.0;          ///< put in by the tractions at the surface, of the same orders [W]
};

/// @brief Energy lost per volume and revolution.
/// @param[in] sphere core and layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] tractions of the plane
/// @param[in] places where w is wanted besides those of the volume integral, which are all where this is empty
/// @param[in] max_order orders that are summed, in [1, 20000]
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] observer progress and cancellation
/// @throws std::invalid_argument for bad input
/// @throws Cancelled where the observer stopped it
[[nodiscard]] LossDensity loss_density(const CoatedSphere& sphere, double angular_speed, const Tractions& tractions,
                                       std::span<const Place> places, int max_order, int threads = 0,
                                       const Observer& observer = {});

}  // namespace viscoroll

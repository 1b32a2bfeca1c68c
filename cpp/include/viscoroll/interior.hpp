/// @file
/// @brief What happens inside layers under tractions that are known: displacement, strain, stress, and loss.
///
/// Components are those along r, phi and theta, of tensors rr, phiphi, thetatheta, rphi, rtheta and phitheta; stress is
/// positive in tension. On every body r points out of it, phi is the way of its material through the contact, and theta
/// the way of the axis that is theta of what rolls. See docs/theory/inside.md.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "viscoroll/cylinder.hpp"
#include "viscoroll/formulation.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/observer.hpp"
#include "viscoroll/options.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/result.hpp"
#include "viscoroll/rolling_body.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace viscoroll {

/// @brief What has an inside. That of a wheel is a tread straight across and without sides; a roller under a wheel is
/// one, too.
using LayeredShape = std::variant<CoatedSphere, CoatedCylinder, CoatedPlane, CoatedWheel>;

/// @brief A place along the normal. Three of the stresses and of the strains jump where layers meet: there both have
/// it.
struct Place {
  double position = 0.0;  ///< r, or in a plane the height above its surface, <= 0 [m]; in the closed layer
  int layer = 0;          ///< number of the layer, from the center or the base outwards

  friend bool operator==(const Place&, const Place&) = default;
};

/// @brief Components of the fields: displacement (3), stress (6) and strain (6).
inline constexpr std::size_t kFieldComponents = 15;

/// @brief Places at positions: two where layers meet, the outer layer's first.
/// @param[in] shape with layers
/// @param[in] positions [m], each within the layers; radii > 0
/// @throws std::invalid_argument for bad input
[[nodiscard]] std::vector<Place> places_at(const LayeredShape& shape, std::span<const double> positions);

/// @brief Fields of single orders (m, n) per unit surface stress: displacement [m/Pa], stress [-] and strain [1/Pa].
/// @param[in] shape with layers
/// @param[in] angular_speed Omega of what rolls [rad/s], > 0
/// @param[in] m,n orders of any sign, as many of the one as of the other; in a plane not both 0; n = 0 in a cylinder;
/// n of a wheel per its outer radius
/// @param[in] places where
/// @param[in] radius of what rolls, that makes wave numbers of a plane orders [m], > 0; the others have their own
/// @param[in] curvature sphere or paper, of a sphere
/// @param[in] observer progress and cancellation
/// @return row-major [order][place][component][surface stress along r, phi, theta]
/// @throws std::invalid_argument for bad input
/// @throws Cancelled where the observer stopped it
[[nodiscard]] std::vector<std::complex<double>> order_fields(const LayeredShape& shape, double angular_speed,
                                                             std::span<const int> m, std::span<const int> n,
                                                             std::span<const Place> places, double radius,
                                                             Curvature curvature = Curvature::sphere,
                                                             const Observer& observer = {});

/// @brief What one body does to the surface of the other, and in which model: a solved contact.
struct Tractions {
  Mesh mesh;            ///< on whose nodes they are
  double radius = 0.0;  ///< at which its angles are arcs: that of what rolls [m]
  /// Of columns, where a wheel has others than the mesh [rad].
  std::optional<double> theta_spacing = std::nullopt;
  /// Of a wheel that rolls [m], infinite where it is flat; none of others.
  std::optional<double> crown_radius = std::nullopt;
  bool line = false;                           ///< a single row of nodes in plane strain: forces are per length
  int phi_nodes = 0;                           ///< rows of the window
  int theta_nodes = 0;                         ///< columns of the window
  std::vector<double> pressure;                ///< [Pa], [phi][theta]
  std::vector<double> shear_traction;          ///< on what rolls along x and z [Pa], [2][phi][theta]
  bool friction = false;                       ///< whether there are shear tractions
  Compliance compliance = Compliance::radial;  ///< along which normals the pressure acts
  Curvature curvature = Curvature::sphere;     ///< sphere or paper
  PatchLoad patch_load = PatchLoad::flat;      ///< how a patch is loaded
  bool counterpart = false;                    ///< whether it is what the other rolls on that they are to act on
  /// Of that, along the path and across, > 0 where it bulges [1/m].
  std::array<double, 2> counterpart_curvature{};
};

/// @return the tractions of a solution, on what rolls
/// @param[in] body that rolls
/// @param[in] result solution
/// @param[in] load_case,options of the solve
[[nodiscard]] Tractions tractions_of(const RollingBody& body, const Result& result, const LoadCase& load_case,
                                     const Options& options = {});

/// @brief Fields on surfaces r = const.
struct InteriorFields {
  std::vector<Place> places;  ///< surfaces, in the order asked for
  std::vector<double> phi;    ///< [rad] of the body, in a plane of what rolls
  std::vector<double> theta;  ///< likewise
  /// Displacement [m], stress [Pa] and strain [-], row-major [place][component][phi][theta].
  std::vector<double> values;
};

/// @brief Fields inside the layers, by the sum over orders of what the tractions make there. Above a quarter of a
/// spacing below the surface they are those of the patches, not of a smooth pressure. The displacement of a half-plane
/// under a line is that of waves up to 1e9 contacts long, which a constant differs from.
/// @param[in] shape with layers
/// @param[in] angular_speed Omega of what rolls [rad/s], > 0
/// @param[in] tractions on it
/// @param[in] places where along r
/// @param[in] phi,theta where along the surface [rad], within half a revolution of the lowest point, pi/2; phi in a
/// plane within a third of one; theta within a whole one where it is straight across, and pi/2 under a line
/// @param[in] max_order at which the sum ends, smoothly, > 0, where a place sees higher ones
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] observer progress and cancellation
/// @throws std::invalid_argument for bad input
/// @throws Cancelled where the observer stopped it
[[nodiscard]] InteriorFields interior_fields(const LayeredShape& shape, double angular_speed,
                                             const Tractions& tractions, std::span<const Place> places,
                                             std::span<const double> phi, std::span<const double> theta,
                                             std::optional<double> max_order = std::nullopt, int threads = 0,
                                             const Observer& observer = {});

/// @brief Energy lost inside the layers, of the orders |m|, |n| <= max_order, of what rolls. Powers are per length
/// under a line.
struct LossDensity {
  std::vector<Place> places;    ///< asked for, or those of the volume integral
  std::vector<double> weights;  ///< dr of each place in the volume integral [m]; 0 where it was asked for
  /// At equal spacings [rad], once around from -pi/2, where it is straight across maybe several times; pi/2 under a
  /// line.
  std::vector<double> theta;
  std::vector<double> density;      ///< w(r, theta), per volume and passage of the contact [J/m^3], [place][theta]
  std::vector<double> orders;       ///< m of the body, ascending: whole numbers, but in a plane
  std::vector<double> order_power;  ///< lost in each layer by each order, in a plane by those around it [W], [layer][m]
  double volume_power = 0.0;        ///< Omega of the body times the volume integral of w, without sin(theta) [W]
  double surface_power = 0.0;       ///< put in by the tractions at the surface, of the same orders [W]
};

/// @brief Energy lost per volume and passage of the contact: per revolution of what turns.
/// @param[in] shape with layers
/// @param[in] angular_speed Omega of what rolls [rad/s], > 0
/// @param[in] tractions on it
/// @param[in] places where w is wanted besides those of the volume integral, which are all where this is empty
/// @param[in] max_order orders that are summed, in [1, 20000]
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] observer progress and cancellation
/// @throws std::invalid_argument for bad input
/// @throws Cancelled where the observer stopped it
[[nodiscard]] LossDensity loss_density(const LayeredShape& shape, double angular_speed, const Tractions& tractions,
                                       std::span<const Place> places, int max_order, int threads = 0,
                                       const Observer& observer = {});

}  // namespace viscoroll

/// @file
/// @brief Displacement, strain, stress and dissipation inside the layers under given tractions.
///
/// Vectors have the components r, phi and theta; tensors have the components rr, phiphi, thetatheta, rphi, rtheta and
/// phitheta. Stress is positive in tension. On every body, r is the outward normal and phi the direction in which its
/// material crosses the contact. The lateral direction theta is that of the rolling body, on the counterbody as well.
/// See docs/theory/inside.md.
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

/// @brief A body with layers.
///
/// The fields of a wheel are those of a tread without crown and without side faces. A roller under a wheel is given as
/// a wheel, since its layers form such a tread.
using LayeredShape = std::variant<CoatedSphere, CoatedCylinder, CoatedPlane, CoatedWheel>;

/// @brief A position along the normal, in one of the layers.
///
/// Three stresses and three strains jump at the boundary of two layers. The layer selects the side of the boundary.
struct Place {
  /// r [m], or in a plane the height above its surface, <= 0 [m]; inside or at the ends of the layer.
  double position = 0.0;
  int layer = 0;  ///< index of the layer, from the center or the base outwards

  friend bool operator==(const Place&, const Place&) = default;
};

/// @brief Number of components of the fields: displacement (3), stress (6) and strain (6).
inline constexpr std::size_t kFieldComponents = 15;

/// @brief Find the layers at positions.
/// @param[in] shape body with layers
/// @param[in] positions radii or heights [m], each within the layers; radii > 0
/// @return one place for each position, or two at the boundary of two layers, the one in the outer layer first
/// @throws InvalidInput for invalid input
[[nodiscard]] std::vector<Place> places_at(const LayeredShape& shape, std::span<const double> positions);

/// @brief Fields of single orders (m, n) per unit surface stress: displacement [m/Pa], stress [-] and strain [1/Pa].
/// @param[in] shape body with layers
/// @param[in] angular_speed Omega of the rolling body [rad/s], > 0
/// @param[in] m,n orders, any sign, arrays of equal length; not both 0 in a plane; n = 0 in a cylinder; in a wheel n is
/// the wave number across times the outer radius
/// @param[in] places positions along the normal
/// @param[in] radius radius of the rolling body [m], > 0; on a plane the orders are wave numbers times this radius;
/// other shapes use their own radius
/// @param[in] curvature `sphere` or `paper`, for a sphere
/// @param[in] observer progress and cancellation
/// @return row-major [order][place][component][surface stress along r, phi, theta]
/// @throws InvalidInput for invalid input
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] std::vector<std::complex<double>> order_fields(const LayeredShape& shape, double angular_speed,
                                                             std::span<const int> m, std::span<const int> n,
                                                             std::span<const Place> places, double radius,
                                                             Curvature curvature = Curvature::sphere,
                                                             const Observer& observer = {});

/// @brief Tractions of a solved contact on the surface of one of the two bodies.
struct Tractions {
  Mesh mesh;            ///< mesh of the nodes
  double radius = 0.0;  ///< radius that converts angles of the mesh to arc lengths: that of the rolling body [m]
  /// Spacing of the columns of a wheel, which differs from that of the mesh [rad]; none for other bodies.
  std::optional<double> theta_spacing = std::nullopt;
  /// Crown radius of a rolling wheel [m], infinite for a flat one; none for other bodies.
  std::optional<double> crown_radius = std::nullopt;
  bool line = false;                           ///< line contact: one row of nodes in plane strain, forces per length
  int phi_nodes = 0;                           ///< number of rows of the window, odd
  int theta_nodes = 0;                         ///< number of columns of the window, odd
  std::vector<double> pressure;                ///< contact pressure [Pa], [phi][theta]
  std::vector<double> shear_traction;          ///< on the rolling body, along x and z [Pa], [2][phi][theta]
  bool friction = false;                       ///< whether there are shear tractions
  Compliance compliance = Compliance::radial;  ///< normals along which the pressure acts
  Curvature curvature = Curvature::sphere;     ///< `sphere` or `paper`
  PatchLoad patch_load = PatchLoad::flat;      ///< distribution of the traction on a patch
  bool counterbody = false;  ///< whether the tractions act on the counterbody, not on the rolling body
  /// Curvature of the counterbody along the path and across it, > 0 for a convex surface [1/m].
  std::array<double, 2> counterbody_curvature{};
};

/// @brief Tractions of a solution on the rolling body.
/// @param[in] body rolling body
/// @param[in] result solution
/// @param[in] load_case,options same as in `solve`
/// @return the tractions
[[nodiscard]] Tractions tractions_of(const RollingBody& body, const Result& result, const LoadCase& load_case,
                                     const Options& options = {});

/// @brief Fields on surfaces r = const.
struct InteriorFields {
  std::vector<Place> places;  ///< surfaces, in the order of the argument
  std::vector<double> phi;    ///< angle on the body, or for a plane on the rolling body [rad]
  std::vector<double> theta;  ///< angle on the body, or for a plane on the rolling body [rad]
  /// Displacement [m], stress [Pa] and strain [-], row-major [place][component][phi][theta].
  std::vector<double> values;
};

/// @brief Fields inside the layers under given tractions, by the sum over orders.
///
/// At depths below a quarter of a spacing the fields contain the pressure steps from patch to patch. In line contact
/// the displacement of a half-plane is defined up to a constant; the sum contains waves up to 1e9 times as long as the
/// contact.
/// @param[in] shape body with layers
/// @param[in] angular_speed Omega of the rolling body [rad/s], > 0
/// @param[in] tractions tractions on the body
/// @param[in] places positions along the normal
/// @param[in] phi,theta positions along the surface [rad], within half a revolution of the lowest point at pi/2; phi of
/// a plane within a third of a revolution; theta of a plane or wheel within a whole revolution; theta = pi/2 in line
/// contact
/// @param[in] max_order order at which the sum ends smoothly, > 0; none: the order that the depth requires. It has no
/// effect at depths that higher orders do not reach.
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] observer progress and cancellation
/// @return the fields on all surfaces
/// @throws InvalidInput for invalid input
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] InteriorFields interior_fields(const LayeredShape& shape, double angular_speed,
                                             const Tractions& tractions, std::span<const Place> places,
                                             std::span<const double> phi, std::span<const double> theta,
                                             std::optional<double> max_order = std::nullopt, int threads = 0,
                                             const Observer& observer = {});

/// @brief Energy and power dissipated inside the layers, from the orders |m|, |n| <= max_order of the rolling body. In
/// line contact, powers are per unit length.
struct LossDensity {
  std::vector<Place> places;    ///< the requested places; if none were requested, those of the volume integral
  std::vector<double> weights;  ///< weight dr of each place in the volume integral [m]; 0 for requested places
  /// Equally spaced angles from -pi/2 [rad], over one revolution, on planes and wheels possibly over several; pi/2 in
  /// line contact.
  std::vector<double> theta;
  std::vector<double> density;      ///< w(r, theta) per volume and pass of the contact [J/m^3], [place][theta]
  std::vector<double> orders;       ///< orders m of the body, ascending; whole numbers, except in a plane
  std::vector<double> order_power;  ///< power dissipated in each layer by each order m; in a plane, where orders are
                                    ///< continuous, by the band of orders that m represents [W], [layer][m]
  double volume_power = 0.0;        ///< Omega of the body times the volume integral of w, without sin(theta) [W]
  double surface_power = 0.0;       ///< power of the tractions at the surface, from the same orders [W]
};

/// @brief Energy dissipated per volume and pass of the contact, which is one revolution of a ball, roller or wheel.
/// @param[in] shape body with layers
/// @param[in] angular_speed Omega of the rolling body [rad/s], > 0
/// @param[in] tractions tractions on the body
/// @param[in] places places at which w is returned; empty: the places of the volume integral
/// @param[in] max_order highest order of the sum, in [1, 20000]
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] observer progress and cancellation
/// @return density and powers
/// @throws InvalidInput for invalid input
/// @throws Canceled if the observer canceled the computation
[[nodiscard]] LossDensity loss_density(const LayeredShape& shape, double angular_speed, const Tractions& tractions,
                                       std::span<const Place> places, int max_order, int threads = 0,
                                       const Observer& observer = {});

}  // namespace viscoroll

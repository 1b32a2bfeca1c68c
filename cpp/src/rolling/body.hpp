/// @file
/// @brief What rolls, and what it rolls on, as the contact between them sees it. A kind of body is a file with its
/// `make_body`, and nothing else in the steady solver asks which one it is.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "influence/mesh_on_body.hpp"
#include "modal/layered_body.hpp"
#include "rolling/contact_form.hpp"
#include "rolling/surface_tables.hpp"
#include "surface/curvatures.hpp"
#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll::detail {

/// @brief A layer that deforms, with its name in messages. A half-space is one of infinite thickness.
struct NamedLayer {
  std::string name;
  Layer layer;
};

/// @brief An undeformed surface at the nodes of what rolls on it; no numbers where it is flat.
struct Profile {
  Eigen::ArrayXd drop;   ///< below its highest point [m]; a hollow one rises
  Eigen::ArrayXd slope;  ///< downwards along x [-]
};

/// @brief Nodes on what rolls.
struct Nodes {
  SurfaceGrid grid;
  Window widest;  ///< beyond which no load can be borne
};

/// @brief How far a contact reaches from the lowest node.
struct ContactReach {
  double along;   ///< upstream or downstream, the larger one [m]
  double across;  ///< to either side [m]
};

/// @brief How the material of both surfaces crosses the contact.
struct Crossing {
  double angular_speed;      ///< Omega of what rolls [rad/s]
  double radius;             ///< of what rolls, at which the mesh's angles are arcs [m]
  Mesh mesh;                 ///< of what rolls
  double theta_spacing;      ///< of its nodes across, which the mesh alone does not say of a wheel [rad]
  double widest;             ///< largest offset across [rad]
  Curvature curvature;       ///< what is kept of it in the equations of the layers
  double inertia_tolerance;  ///< relative error of the compliance that may be left of inertia
  ContactForm form;
  Execution execution;

  /// @return Omega of a body of another radius, whose surface is as fast [rad/s]
  [[nodiscard]] double angular_speed_at(double other) const { return angular_speed * (radius / other); }
  /// @return the mesh as a body of another radius has it
  [[nodiscard]] MeshOnBody mesh_at(double other) const {
    return form.is_line() ? MeshOnBody(mesh, radius / other) : MeshOnBody(mesh, radius / other, theta_spacing, widest);
  }
};

/// @brief What the surface of a body does in a contact.
struct BodySurface {
  std::unique_ptr<const SurfaceTables> tables;  ///< none of a rigid body
  std::complex<double> normal = 0.0;            ///< compliance of the mesh's highest order along phi [m/Pa]
  std::complex<double> along = 0.0;             ///< the same along the way of the material
  double stiffest_modulus = 0.0;                ///< largest shear modulus of a layer at the highest harmonic [Pa]
  double centrifugal = 0.0;                     ///< d_R^(c) [m]
};

/// @brief All that is asked of a body.
struct Body {
  std::string_view type;           ///< name of the struct that users give
  std::vector<NamedLayer> layers;  ///< from within outwards; none of a rigid body
  Curvatures curvatures;
  /// Its tables and what else it does as material crosses the contact. Refuses meshes and curvatures that the body
  /// knows nothing of, and critical speeds.
  std::function<BodySurface(const Crossing&)> surface;
  /// Its layers as they are in the contact, as if without sides. Not of a rigid body.
  std::function<LayeredBody(const Crossing&)> layered;
  /// The tread that ends at free faces, beside which influence is no function of offsets; none of other bodies.
  std::optional<CoatedWheel> free_tread = {};
  std::function<Profile(const SurfaceWindow&)> profile;
  /// Refuses what has no room to roll on it.
  std::function<void(const Body&)> require_room_for = [](const Body&) {};
  /// Across, within which it bears pressure; infinite where it has no sides [m].
  double width = std::numeric_limits<double>::infinity();
  /// Relative error of the torque by what its equations leave out, beside strain, in a contact.
  std::function<double(const ContactReach&)> further_error = [](const ContactReach&) { return 0.0; };
  /// What a user should know of it in a contact with another body, which deforms or not.
  std::function<std::vector<Warning>(const ContactReach&, bool)> cautions = [](const ContactReach&, bool) {
    return std::vector<Warning>{};
  };

  /// Refuses what its equations lift where it is pressed.
  std::function<void()> require_stiffness = [] {};

  // The rest of what rolls alone.
  std::string_view name = {};                       ///< in messages
  std::vector<std::string_view> counterparts = {};  ///< types of what it may roll on
  double radius = 0.0;                              ///< [m]
  ContactForm form = kSpotContact;
  /// Of a mesh, given the counterpart, whose nodes they are, too, where it deforms.
  std::function<Nodes(const Mesh&, const Body&)> nodes = {};
  /// Refuses options that the body knows nothing of.
  std::function<void(const Options&)> require = [](const Options&) {};

  [[nodiscard]] bool is_rigid() const { return layers.empty(); }
};

[[nodiscard]] Body make_body(const CoatedSphere& sphere);
[[nodiscard]] Body make_body(const CoatedCylinder& cylinder);
[[nodiscard]] Body make_body(const CoatedWheel& wheel);
[[nodiscard]] Body make_body(const CoatedPlane& plane);
[[nodiscard]] Body make_body(const Groove& groove);

/// @return layers[0], layers[1], ...
[[nodiscard]] std::vector<NamedLayer> named(const std::vector<Layer>& layers);

/// @return the profile of circles; over a plane that deforms, of parabolas
[[nodiscard]] std::function<Profile(const SurfaceWindow&)> circles(const Curvatures& curvatures);

}  // namespace viscoroll::detail

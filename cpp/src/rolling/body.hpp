/// @file
/// @brief The two sides of a contact, the rolling body and the counterbody, as the steady and the transient solver see
/// them. Neither solver depends on the type of a body.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
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

class RoundBody;

/// @brief Shape of one side of a contact.
struct BodyShape {
  std::vector<NamedLayer> layers = {};  ///< from the innermost outwards; empty for a rigid body
  Curvatures curvatures = {};
  double radius = 0.0;                                     ///< of a body that turns; 0 of a plane or groove [m]
  double width = std::numeric_limits<double>::infinity();  ///< that supports the load; infinite without faces [m]
};

/// @brief One side of a contact: the rolling body or the counterbody. Each type of body is a class in a file of its
/// own.
class Body {
 public:
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
  virtual ~Body() = default;

  [[nodiscard]] const std::vector<NamedLayer>& layers() const { return shape_.layers; }
  [[nodiscard]] bool is_rigid() const { return shape_.layers.empty(); }
  [[nodiscard]] const Curvatures& curvatures() const { return shape_.curvatures; }
  [[nodiscard]] double radius() const { return shape_.radius; }
  [[nodiscard]] double width() const { return shape_.width; }

  /// @return influence tables, compliance and centrifugal displacement
  /// @throws std::invalid_argument for meshes and curvatures that the type of body does not support, and critical
  /// speeds
  [[nodiscard]] virtual BodySurface surface(const Crossing& crossing) const = 0;
  /// @return the layers in the contact, without free faces; not defined for a rigid body
  [[nodiscard]] virtual LayeredBody layered(const Crossing& crossing) const = 0;
  [[nodiscard]] virtual Profile profile(const SurfaceWindow& points) const = 0;
  /// @return the tread that ends at free faces, where influence depends on more than offsets; null for other bodies
  [[nodiscard]] virtual const CoatedWheel* free_tread() const { return nullptr; }
  /// @throws std::invalid_argument if a rolling body does not fit into the curvature of this one
  virtual void require_room_for(const RoundBody& /*rolling*/) const {}
  /// @return relative error of the torque that the layer equations leave, besides that of the strain
  [[nodiscard]] virtual double further_error(const ContactReach& /*contact*/) const { return 0.0; }
  /// @return warnings about this body in a contact with another one, which is deformable or rigid
  [[nodiscard]] virtual std::vector<Warning> warnings(const ContactReach& /*contact*/, bool /*other_deforms*/) const {
    return {};
  }
  /// @throws std::invalid_argument if the layer equations lift the surface where it is pressed
  virtual void require_stiffness() const {}

 protected:
  explicit Body(BodyShape shape) : shape_(std::move(shape)) {}

 private:
  BodyShape shape_;
};

/// @brief A body that can roll: a sphere, cylinder or wheel. It can also be the counterbody.
class RoundBody : public Body {
 public:
  /// @return noun in messages
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual const ContactForm& form() const { return kSpotContact; }
  /// @return nodes of a mesh; a counterbody that deforms shares them
  [[nodiscard]] virtual Nodes nodes(const Mesh& mesh, const Body& on) const = 0;
  /// @throws std::invalid_argument for options that the type of body does not support
  virtual void require(const Options& /*options*/) const {}

 protected:
  using Body::Body;
};

[[nodiscard]] std::unique_ptr<const RoundBody> make_body(const CoatedSphere& sphere);
[[nodiscard]] std::unique_ptr<const RoundBody> make_body(const CoatedCylinder& cylinder);
[[nodiscard]] std::unique_ptr<const RoundBody> make_body(const CoatedWheel& wheel);
[[nodiscard]] std::unique_ptr<const Body> make_body(const CoatedPlane& plane);
[[nodiscard]] std::unique_ptr<const Body> make_body(const Groove& groove);

/// @return layers[0], layers[1], ...
[[nodiscard]] std::vector<NamedLayer> named(const std::vector<Layer>& layers);

/// @return the profile of a straight or circular track: along the path, its drop is the height of the rolling body's
/// nodes above the middle row times r_o * curvature, so that its slope is x * curvature exactly; across, it is a
/// circle, over a plane that deforms a parabola
[[nodiscard]] Profile circles(const Curvatures& curvatures, const SurfaceWindow& points);

}  // namespace viscoroll::detail

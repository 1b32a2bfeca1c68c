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
#include "modal/spectrum.hpp"
#include "rolling/contact_form.hpp"
#include "rolling/surface_tables.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/options.hpp"
#include "viscoroll/result.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll::detail {

/// @brief A deformable layer and its name in messages. A half-space is a layer of infinite thickness.
struct NamedLayer {
  std::string name;
  Layer layer;
};

/// @brief Undeformed surface of the counterbody at the nodes of the rolling body. Both arrays are empty if it is flat.
struct Profile {
  Eigen::ArrayXd drop;   ///< below its highest point [m]; negative for a hollow surface
  Eigen::ArrayXd slope;  ///< slope downwards along x [-]
};

/// @brief Nodes on the rolling body.
struct Nodes {
  SurfaceGrid grid;
  Window widest;  ///< window outside of which nodes cannot support load
};

/// @brief Extent of a contact, measured from the lowest node.
struct ContactReach {
  double along;   ///< upstream or downstream, whichever is larger [m]
  double across;  ///< to either side [m]
};

/// @brief Motion of both surfaces through the contact.
struct SurfaceMotion {
  double angular_speed;  ///< Omega of the rolling body [rad/s]
  double radius;         ///< of the rolling body; angles of a mesh are arcs at this radius [m]
  Curvature curvature;   ///< curvature terms retained in the layer equations
  ContactForm form;

  /// @return angular speed of a body of another radius with the same surface speed [rad/s]
  [[nodiscard]] double angular_speed_at(double other) const { return angular_speed * (radius / other); }
};

/// @brief Results that influence tables must provide.
struct TableNeeds {
  /// Largest relative error of the compliance due to the truncated expansion in inertia.
  double inertia_tolerance = kInertiaTolerance;
  bool has_losses = true;  ///< whether the dissipation is evaluated; otherwise forces and displacements only
};

/// @brief Motion of the material of both surfaces from node to node.
struct ContactKinematics : SurfaceMotion {
  Mesh mesh;             ///< of the rolling body
  double theta_spacing;  ///< spacing of its nodes across; on a wheel it differs from that of the mesh [rad]
  double widest;         ///< largest offset across [rad]
  TableNeeds needs;
  Execution execution;

  /// @return the mesh in the angles of a body of another radius
  [[nodiscard]] MeshOnBody mesh_at(double other) const {
    return form.is_line() ? MeshOnBody(mesh, radius / other) : MeshOnBody(mesh, radius / other, theta_spacing, widest);
  }
};

/// @brief Properties of the surface of one body in a contact.
struct BodySurface {
  std::unique_ptr<const SurfaceTables> tables;  ///< null for a rigid body
  std::complex<double> normal = 0.0;            ///< normal compliance of the highest order of the mesh along phi [m/Pa]
  std::complex<double> along = 0.0;             ///< compliance of the same order in the rolling direction [m/Pa]
  double stiffest_modulus = 0.0;                ///< largest shear modulus of a layer at the highest harmonic [Pa]
};

class RoundBody;

/// @brief Shape of one side of a contact.
struct BodyShape {
  std::vector<NamedLayer> layers = {};  ///< from the innermost outwards; empty for a rigid body
  Curvatures curvatures = {};
  double radius = 0.0;                                     ///< of a body that turns; 0 for a plane or groove [m]
  double width = std::numeric_limits<double>::infinity();  ///< loaded width; infinite without side faces [m]
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

  /// @return influence tables and compliance
  /// @throws InvalidInput for meshes and curvatures that the type of body does not support, and for critical
  /// speeds
  [[nodiscard]] virtual BodySurface surface(const ContactKinematics& kinematics) const = 0;
  /// @return the layers in the contact, without free faces; not defined for a rigid body
  [[nodiscard]] virtual LayeredBody layered(const SurfaceMotion& motion) const = 0;
  [[nodiscard]] virtual Profile profile(const SurfaceWindow& points) const = 0;
  /// @return the tread if it ends at free faces, where influence depends on more than offsets; null for other bodies
  [[nodiscard]] virtual const CoatedWheel* free_tread() const { return nullptr; }
  /// @throws InvalidInput if a rolling body does not fit into the curvature of this one
  virtual void require_room_for(const RoundBody& /*rolling*/) const {}
  /// @return relative error of the torque due to the layer equations, in addition to the error due to the strain
  [[nodiscard]] virtual double further_error(const ContactReach& /*contact*/) const { return 0.0; }
  /// @return warnings about this body in a contact with another one, which is deformable or rigid
  [[nodiscard]] virtual std::vector<Warning> warnings(const ContactReach& /*contact*/, bool /*other_deforms*/) const {
    return {};
  }
  /// @throws InvalidInput if pressing would move the surface outward according to the layer equations
  virtual void require_stiffness() const {}

 protected:
  explicit Body(BodyShape shape) : shape_(std::move(shape)) {}

 private:
  BodyShape shape_;
};

/// @brief A body that can roll: a sphere, cylinder or wheel. It can also be the counterbody.
class RoundBody : public Body {
 public:
  /// @return the noun of this body in messages
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual const ContactForm& form() const { return kPointContact; }
  /// @return nodes of a mesh; a deformable counterbody has the same nodes
  [[nodiscard]] virtual Nodes nodes(const Mesh& mesh, const Body& on) const = 0;
  /// @throws InvalidInput for options that the type of body does not support
  virtual void require(const Options& /*options*/) const {}

 protected:
  using Body::Body;
};

[[nodiscard]] std::unique_ptr<const RoundBody> make_body(const CoatedSphere& sphere);
[[nodiscard]] std::unique_ptr<const RoundBody> make_body(const CoatedCylinder& cylinder);
[[nodiscard]] std::unique_ptr<const RoundBody> make_body(const CoatedWheel& wheel);
[[nodiscard]] std::unique_ptr<const Body> make_body(const CoatedPlane& plane);
[[nodiscard]] std::unique_ptr<const Body> make_body(const Groove& groove);

/// @return the layers with the names layers[0], layers[1], ...
[[nodiscard]] std::vector<NamedLayer> named(const std::vector<Layer>& layers);

/// @brief Profile of a straight or circular track. Along the path, its drop is the height of the rolling body's nodes
/// above the middle row times r_o * curvature, so that its slope is exactly x * curvature. Across the path, the drop is
/// that of a circle, or of a parabola if the counterbody is a deformable plane.
/// @param[in] curvatures of the track [1/m]
/// @param[in] points nodes of the rolling body
[[nodiscard]] Profile circles(const Curvatures& curvatures, const SurfaceWindow& points);

}  // namespace viscoroll::detail

/// @file
/// @brief What all load cases at one speed on one mesh share: the spectrum, and the influence tables made of it.
#pragma once

#include <complex>
#include <memory>

#include "modal/harmonic_body.hpp"
#include "parallel.hpp"
#include "rolling/line_surface.hpp"
#include "rolling/rolling_body.hpp"
#include "rolling/sphere_tables.hpp"
#include "rolling/table_store.hpp"
#include "surface/surface_window.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief Two bodies at a speed on a mesh. Threads may share it: tables are summed under a lock, and never change.
class MeshModel {
 public:
  /// @param[in] pair what rolls, and what it rolls on
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacing and truncation
  /// @param[in] curvature what is kept of it in the equations of the layers
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @param[in] inertia_tolerance relative error of the compliance that may be left of inertia
  /// @throws std::invalid_argument for bad input and critical speeds
  MeshModel(const RollingPair& pair, double angular_speed, const Mesh& mesh, Curvature curvature, int threads,
            Watch& watch, double inertia_tolerance = kInertiaTolerance);

  [[nodiscard]] const RollingPair& pair() const { return pair_; }
  [[nodiscard]] const RollingBody& body() const { return pair_.body; }
  [[nodiscard]] double angular_speed() const { return angular_speed_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] SurfaceGrid grid() const;
  /// @return the largest shear modulus of a layer at the highest harmonic [Pa]
  [[nodiscard]] double stiffest_modulus() const { return stiffest_modulus_; }
  /// @return tables of the exact sphere, where that is what the model is of
  [[nodiscard]] const SphereTables* sphere_tables() const { return sphere_tables_.get(); }
  /// @return what was kept of the curvature
  [[nodiscard]] Curvature curvature() const { return curvature_; }
  /// @return where displacements are taken, downstream of the nodes, see `SurfaceOperator::collocation` [spacings]
  [[nodiscard]] double collocation() const { return collocation_; }
  /// @return d_R^(c) [m]
  [[nodiscard]] double centrifugal() const { return centrifugal_; }

  /// @return tables of what rolls, none where that is rigid or the exact sphere
  [[nodiscard]] const TableStore* own() const { return own_.get(); }
  /// @return tables of what it rolls on, none where that is rigid
  [[nodiscard]] const TableStore* track() const { return track_.get(); }

 private:
  /// Compliance of the mesh's highest order along phi [m/Pa].
  struct Alternating {
    std::complex<double> normal = 0.0;
    std::complex<double> along = 0.0;
  };

  void roll_sphere(const CoatedSphere& sphere, int threads, Watch& watch, double inertia_tolerance);
  void roll_over(const CoatedPlane& plane, int threads, Watch& watch);
  void roll_cylinder(const CoatedCylinder& cylinder, int threads, Watch& watch);
  /// @param[in] body at the mesh's highest order, first of all, and at higher ones
  void count_in(const HarmonicBody& body);
  /// @return tables of one of two surfaces in line contact, whose compliance and swelling are counted in
  [[nodiscard]] std::unique_ptr<const TableStore> count_in(LineSurface surface);

  RollingPair pair_;
  double angular_speed_;
  Mesh mesh_;
  Curvature curvature_;
  std::unique_ptr<const TableStore> own_;
  std::unique_ptr<const TableStore> track_;
  std::unique_ptr<const SphereTables> sphere_tables_;
  Alternating alternating_;
  double centrifugal_ = 0.0;
  double collocation_ = 0.0;
  double stiffest_modulus_ = 0.0;
};

}  // namespace viscoroll::detail

/// @file
/// @brief What all load cases at one speed on one mesh share: the spectrum, and the influence tables made of it.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "influence/table_sum.hpp"
#include "parallel.hpp"
#include "rolling/line_surface.hpp"
#include "rolling/rolling_body.hpp"
#include "rolling/sphere_tables.hpp"
#include "surface/surface_window.hpp"
#include "surface/table_operator.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief What influence tables are for.
enum class TableKind {
  displacement,  ///< those of `displacement_tables`
  dissipation,   ///< those of `dissipation_tables`
};

/// @brief A coated body at a speed on a mesh. Threads may share it: tables are summed under a lock, and never change.
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
  /// @return sums of what the body rolls on, none where that is rigid
  [[nodiscard]] const TableSum* counterpart() const { return counterpart_.sum.get(); }
  /// @return tables of the exact sphere, where that is what the model is of
  [[nodiscard]] const SphereTables* sphere_tables() const { return sphere_tables_.get(); }
  /// @return what was kept of the curvature
  [[nodiscard]] Curvature curvature() const { return curvature_; }
  /// @return where displacements are taken, downstream of the nodes, see `SurfaceOperator::collocation` [spacings]
  [[nodiscard]] double collocation() const { return collocation_; }
  /// @return d_R^(c) [m]
  [[nodiscard]] double centrifugal() const { return centrifugal_; }

  /// @brief Tables of a formulation, as made for an earlier load case where that is enough.
  /// @param[in] formulation which tables
  /// @param[in] kind which of them
  /// @param[in] phi_reach,theta_reach offsets that they reach at least
  /// @param[in] execution of the sum
  [[nodiscard]] std::shared_ptr<const std::vector<Table>> tables(const Formulation& formulation, TableKind kind,
                                                                 int phi_reach, int theta_reach,
                                                                 const Execution& execution) const;

 private:
  struct TableSet {
    Formulation formulation;
    TableKind kind;
    int phi_reach;
    int theta_reach;
    std::shared_ptr<const std::vector<Table>> tables;
  };

  /// Sum the tables of some kinds at once, and keep them.
  void add(const Formulation& formulation, std::span<const TableKind> kinds, int phi_reach, int theta_reach,
           const Execution& execution) const;
  [[nodiscard]] const TableSet* find(const Formulation& formulation, TableKind kind) const;

  void roll_sphere(const CoatedSphere& sphere, int threads, Watch& watch, double inertia_tolerance);
  void roll_cylinder(const CoatedCylinder& cylinder, int threads, Watch& watch);

  RollingPair pair_;
  double angular_speed_;
  Mesh mesh_;
  Curvature curvature_;
  LineSurface roller_;       // in line contact
  LineSurface counterpart_;  // the same
  std::unique_ptr<const TableSum> orders_;
  std::unique_ptr<const SphereTables> sphere_tables_;
  double centrifugal_ = 0.0;
  double collocation_ = 0.0;
  double stiffest_modulus_ = 0.0;
  mutable std::timed_mutex mutex_;
  mutable std::vector<TableSet> sets_;  // the widest of each kind
};

}  // namespace viscoroll::detail

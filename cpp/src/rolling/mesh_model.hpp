/// @file
/// @brief What all load cases at one speed on one mesh share: the spectrum, and the influence tables made of it.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "contact/coating_compliance.hpp"
#include "modal/medium.hpp"
#include "modal/spectrum.hpp"
#include "parallel.hpp"
#include "viscoroll/influence.hpp"

namespace viscoroll::detail {

/// @brief A coating at a speed on a mesh. Threads may share it: tables are summed under a lock, and never change.
class MeshModel {
 public:
  /// @param[in] sphere rigid core and layers
  /// @param[in] angular_speed Omega [rad/s], > 0
  /// @param[in] mesh spacing and truncation
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @throws std::invalid_argument for bad input and critical speeds
  MeshModel(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, int threads, Watch& watch);

  [[nodiscard]] const HarmonicCoating& coating() const { return coating_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] double radius() const { return coating_.outer_radius(); }
  /// @return d_R^(c) [m]
  [[nodiscard]] double centrifugal() const { return centrifugal_; }

  /// @brief Tables for `required_tables(formulation)`, as made for an earlier load case where that is enough.
  /// @param[in] formulation which tables
  /// @param[in] reach offset that they reach at least, in phi and theta
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  [[nodiscard]] std::shared_ptr<const std::vector<Table>> tables(const Formulation& formulation, int reach, int threads,
                                                                 Watch& watch) const;

 private:
  struct TableSet {
    std::vector<TableRequest> requests;
    int reach;
    std::shared_ptr<const std::vector<Table>> tables;
  };

  HarmonicCoating coating_;
  Mesh mesh_;
  double spacing_;
  double centrifugal_;
  std::unique_ptr<Spectrum> spectrum_;
  mutable std::mutex mutex_;
  mutable std::vector<TableSet> sets_;  // the widest of each kind
};

}  // namespace viscoroll::detail

/// @file
/// @brief Data that the phase-shifted meshes of a history share: two bodies on one mesh, and the creep of each.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/parallel.hpp"
#include "creep/layer_spectrum.hpp"
#include "rolling/rolling_pair.hpp"
#include "transient/row_heights.hpp"
#include "transient/viscoelastic_body.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

/// @brief Creep of one of two bodies.
struct BodySpectrum {
  bool rolls = false;  ///< whether it is the rolling body, else the counterbody
  CreepSpectrum spectrum = {};
  std::shared_ptr<const LayerSpectrum> layers = nullptr;  ///< set if they have different relaxation functions
};

/// @brief Size of influence tables.
struct TableSize {
  Eigen::Index half_nodes;   ///< nodes of a row on one side, including the middle
  Eigen::Index track_reach;  ///< rows that tables of a track reach; on a ring they reach half of the ring
};

/// @brief Two bodies whose nodes meet in the contact: one field of forces, and one surface for each deformable body.
struct ViscoelasticPair {
  RollingPair pair;  ///< with relaxed moduli
  Nodes nodes;
  Compliance compliance;                 ///< of the contact condition
  double friction;                       ///< Coulomb's coefficient [-]
  double driving_force;                  ///< on the center, forward [N]
  std::optional<double> driving_torque;  ///< about the center; replaces the force [N m]
  double mass;                           ///< of the parts that move with the center [kg]
  std::optional<Axle> axle;
  SurfaceHeights heights;                ///< of ground and tread
  Eigen::Index track_reach;              ///< reach of the tables along a track
  std::vector<ViscoelasticBody> bodies;  ///< deformable bodies, the rolling body first

  [[nodiscard]] bool has_friction() const { return friction > 0.0; }
  /// @return tables of the first deformable body, the coating that is pressed and slides on the plane
  [[nodiscard]] const CreepTables& coating() const { return bodies.front().tables; }
  /// @return nodes of a row on one side, including the middle
  [[nodiscard]] Eigen::Index half_nodes() const { return bodies.front().tables.half_nodes(); }
  /// @return largest possible number of these nodes
  [[nodiscard]] Eigen::Index max_half_nodes() const { return nodes.widest.theta.last + 1; }
  /// @return largest number of rows that tables reach along a track; influence beyond is left out
  [[nodiscard]] Eigen::Index max_track_reach() const;
  /// @return whether a contact may end at the last node of a row
  [[nodiscard]] bool ends_at_sides() const;
};

/// @brief Creep spectra of the deformable bodies, the rolling body first.
/// @param[in] pair bodies as given
/// @param[in] options range and tolerance of discrete spectra, with a mesh
/// @param[in] watch progress and cancellation
/// @throws InvalidInput for layers that the method does not support
[[nodiscard]] std::vector<BodySpectrum> creep_spectra(const RollingPair& pair, const HistoryOptions& options,
                                                      Watch& watch);

/// @brief Largest rho r_o^2 / (instantaneous modulus) of all layers [s^2].
/// @param[in] pair bodies as given
/// @param[in] spectra creep spectra of the deformable bodies
[[nodiscard]] double inertia_of(const RollingPair& pair, const std::vector<BodySpectrum>& spectra);

/// @brief Reject options that are not available for a pair.
/// @throws InvalidInput with parameter, value and range
void require_supported_options(const RollingPair& pair, const HistoryOptions& options);

/// @brief Size of the first tables.
/// @param[in] at_rest pair with relaxed moduli
/// @param[in] mesh mesh of the rolling body
/// @param[in] contact initial extent of the contact
[[nodiscard]] TableSize first_size(const RollingPair& at_rest, const Mesh& mesh, const ContactReach& contact);

/// @brief Compute the influence tables of a pair.
/// @param[in] at_rest pair with relaxed moduli, without inertia
/// @param[in] spectra creep spectra of the deformable bodies
/// @param[in] options options with a mesh
/// @param[in] size size of the tables; the number of nodes is limited to that of a row
/// @param[in] watch progress and cancellation
[[nodiscard]] ViscoelasticPair viscoelastic_pair(const RollingPair& at_rest, const std::vector<BodySpectrum>& spectra,
                                                 const HistoryOptions& options, const TableSize& size, Watch& watch);

}  // namespace viscoroll::detail

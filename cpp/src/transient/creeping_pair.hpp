/// @file
/// @brief What the lattices of a history share: two bodies on one mesh, and how each of them creeps.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "parallel.hpp"
#include "rolling/rolling_pair.hpp"
#include "transient/creeping_body.hpp"
#include "transient/layer_spectrum.hpp"
#include "viscoroll/rolling_history.hpp"

namespace viscoroll::detail {

/// @brief How one of two bodies creeps.
struct BodySpectrum {
  bool rolls = false;  ///< it is what rolls, else what that rolls on
  CreepSpectrum spectrum = {};
  std::shared_ptr<const LayerSpectrum> layers = nullptr;  ///< where these do not creep alike
};

/// @brief How far tables go.
struct TableSize {
  Eigen::Index half_nodes;   ///< of a row on one side, that in the middle included
  Eigen::Index track_reach;  ///< rows that influence along a track may reach; around a ring it is half of that
};

/// @brief Two bodies whose nodes meet in the contact: one field of forces, and a surface for each that deforms.
struct CreepingPair {
  RollingPair pair;  ///< at rest
  Nodes nodes;
  Compliance compliance;                 ///< in the contact condition
  double friction;                       ///< Coulomb's coefficient [-]
  double driving_force;                  ///< on the center, forward [N]
  std::optional<double> driving_torque;  ///< about the center, in its place [N m]
  double mass;                           ///< of what moves with the center [kg]
  Eigen::Index track_reach;              ///< that the tables were made with
  std::vector<CreepingBody> bodies;      ///< those that deform, that which rolls first

  [[nodiscard]] bool has_friction() const { return friction > 0.0; }
  /// @return what presses between, and slides on, a rigid plane
  [[nodiscard]] const CreepingTables& coating() const { return bodies.front().tables; }
  /// @return nodes of a row on one side, that in the middle included
  [[nodiscard]] Eigen::Index half_nodes() const { return bodies.front().tables.half_nodes(); }
  /// @return the most that there may be
  [[nodiscard]] Eigen::Index most_half_nodes() const { return nodes.widest.theta.last + 1; }
  /// @return the most rows that tables reach along a track; what lies beyond is left out
  [[nodiscard]] Eigen::Index most_track_reach() const;
  /// @return whether a contact may end at the last nodes aside
  [[nodiscard]] bool ends_at_sides() const;
};

/// @brief Spectra of what deforms, that which rolls first.
/// @param[in] pair as given
/// @param[in] options range and tolerance of discrete spectra, with a mesh
/// @param[in] watch progress and cancellation
/// @throws std::invalid_argument for layers that this method is not for
[[nodiscard]] std::vector<BodySpectrum> creep_spectra(const RollingPair& pair, const HistoryOptions& options,
                                                      Watch& watch);

/// @return largest rho r_o^2 per modulus that yields at once, of all layers [s^2]
/// @param[in] pair as given
/// @param[in] spectra of it
[[nodiscard]] double inertia_of(const RollingPair& pair, const std::vector<BodySpectrum>& spectra);

/// @brief Refuse options that a pair is not followed with.
/// @throws std::invalid_argument naming parameter, value and range
void require_followed(const RollingPair& pair, const HistoryOptions& options);

/// @return to begin with
/// @param[in] at_rest the pair with every modulus as it is at rest
/// @param[in] mesh on what rolls
/// @param[in] contact how far it reaches at first
[[nodiscard]] TableSize first_size(const RollingPair& at_rest, const Mesh& mesh, const ContactReach& contact);

/// @param[in] at_rest the pair with every modulus as it is at rest, without inertia
/// @param[in] spectra of what deforms of it
/// @param[in] options with a mesh
/// @param[in] size of the tables; more nodes than a row has are as many
/// @param[in] watch progress and cancellation
[[nodiscard]] CreepingPair creeping_pair(const RollingPair& at_rest, const std::vector<BodySpectrum>& spectra,
                                         const HistoryOptions& options, const TableSize& size, Watch& watch);

}  // namespace viscoroll::detail

/// @file
/// @brief From the compliance of all orders to influence tables on the surface, theory.md section 4.
///
/// With patches alike at every node the compliance is translation invariant on the (phi, theta) torus, so one table per
/// entry serves all pairs of nodes. All orders |m|, |n| <= N_t are folded onto the orders that the mesh can tell apart;
/// a transform along theta for each folded m and one along phi for each offset in theta finish the sum.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "modal/spectrum.hpp"
#include "parallel.hpp"
#include "viscoroll/influence.hpp"

namespace viscoroll::detail {

/// @brief What a table holds.
struct TableRequest {
  Entry entry = Entry::rr;  ///< direction of displacement and load
  int source_shape = 0;     ///< Legendre degree of the loaded patch
  /// Displacement at the node where false; where true, its derivative in phi, averaged over a patch of Legendre
  /// degree `receiver_shape`: with nodal forces on both sides, the power lost per radian.
  bool power = false;
  int receiver_shape = 0;

  friend bool operator==(const TableRequest&, const TableRequest&) = default;
};

/// @brief A table over offsets j in [-phi_reach, phi_reach] and l in [-theta_reach, theta_reach].
class Table {
 public:
  Table(int phi_reach, int theta_reach)
      : phi_reach_(phi_reach),
        theta_reach_(theta_reach),
        values_(static_cast<std::size_t>(2 * phi_reach + 1) * static_cast<std::size_t>(2 * theta_reach + 1)) {}

  /// @return [m/N], by offsets of the displaced node from the loaded one
  [[nodiscard]] double operator()(int j, int l) const { return values_[index(j, l)]; }
  [[nodiscard]] double& operator()(int j, int l) { return values_[index(j, l)]; }

  /// @return the table row by row, for sums over several tables of like reach
  [[nodiscard]] std::span<const double> values() const { return values_; }
  [[nodiscard]] std::size_t index(int j, int l) const {
    const auto row = static_cast<std::size_t>(j + phi_reach_);
    return row * static_cast<std::size_t>(2 * theta_reach_ + 1) + static_cast<std::size_t>(l + theta_reach_);
  }

  [[nodiscard]] int phi_reach() const { return phi_reach_; }
  [[nodiscard]] int theta_reach() const { return theta_reach_; }

 private:
  int phi_reach_;
  int theta_reach_;
  std::vector<double> values_;
};

/// @brief Sum all orders into tables.
/// @param[in] spectrum compliance of every order
/// @param[in] outer_radius r_o [m]
/// @param[in] mesh spacing and truncation
/// @param[in] requests what to sum
/// @param[in] phi_reach,theta_reach largest offsets, in [0, nodes_per_revolution / 2]
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @return one table for each request
[[nodiscard]] std::vector<Table> synthesize(const Spectrum& spectrum, double outer_radius, const Mesh& mesh,
                                            const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                            int threads, Watch& watch);

}  // namespace viscoroll::detail

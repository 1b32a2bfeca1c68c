/// @file
/// @brief Influence table of one entry, and the interface of the sums over orders that give such tables for any body.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Table over offsets j in [-phi_reach, phi_reach] and l in [-theta_reach, theta_reach], even or odd in l. Half
/// of it is stored.
class Table {
 public:
  Table(int phi_reach, int theta_reach, bool odd)
      : phi_reach_(phi_reach),
        theta_reach_(theta_reach),
        mirror_(odd ? -1.0 : 1.0),
        values_(static_cast<std::size_t>(2 * phi_reach + 1) * static_cast<std::size_t>(theta_reach + 1)) {}

  /// @return influence [m/N] at the offsets of the displaced node from the loaded one
  [[nodiscard]] double operator()(int j, int l) const {
    return l < 0 ? mirror_ * row(j)[static_cast<std::size_t>(-l)] : row(j)[static_cast<std::size_t>(l)];
  }

  /// @return values at offsets l = 0 ... theta_reach
  [[nodiscard]] std::span<const double> row(int j) const { return {values_.data() + offset(j), row_length()}; }
  [[nodiscard]] std::span<double> row(int j) { return {values_.data() + offset(j), row_length()}; }

  /// @return factor between the values at -l and l, 1 or -1
  [[nodiscard]] double mirror() const { return mirror_; }
  [[nodiscard]] int phi_reach() const { return phi_reach_; }
  [[nodiscard]] int theta_reach() const { return theta_reach_; }

 private:
  [[nodiscard]] std::size_t row_length() const { return static_cast<std::size_t>(theta_reach_ + 1); }
  [[nodiscard]] std::size_t offset(int j) const { return static_cast<std::size_t>(j + phi_reach_) * row_length(); }

  int phi_reach_;
  int theta_reach_;
  double mirror_;
  std::vector<double> values_;
};

/// @brief Add a multiple of a table to another one of the same reach.
void add(double factor, const Table& table, Table& sum);

/// @brief Weights of the offsets -1, 0, 1 and 2 along phi in the average over a patch of two spacings.
/// @param[in] downstream weight of the displacement one offset downstream
[[nodiscard]] inline std::array<double, 4> wide_patch_shares(double downstream) {
  return {0.25 * (1.0 - downstream), 0.5 - 0.25 * downstream, 0.25 + 0.25 * downstream, 0.25 * downstream};
}

/// @brief Averages of a table over patches of two spacings, with weights 1/4, 1/2 and 1/4 in each direction, at every
/// `stride`-th offset. The table of a line contact has one direction.
/// @param[in] fine table of the fine mesh
/// @param[in] stride stride of the offsets [fine spacings]
/// @param[in] downstream weight of the displacement one offset downstream
[[nodiscard]] Table widened(const Table& fine, int stride, double downstream = 0.0);

/// @brief Contents of a table.
struct TableRequest {
  Entry entry = Entry::rr;  ///< direction of displacement and load
  int source_shape = 0;     ///< Legendre degree of the loaded patch
  /// If false, displacement at the node. If true, its derivative in phi, averaged over a patch of Legendre degree
  /// `receiver_shape`; with nodal forces on both sides this gives the dissipated power per radian.
  bool power = false;
  int receiver_shape = 0;
  /// Distance downstream of the node at which displacement is evaluated [spacings], in [0, 1/2].
  double phi_shift = 0.0;

  friend bool operator==(const TableRequest&, const TableRequest&) = default;
};

/// @brief Provides the tables of a body on a mesh.
class TableSum {
 public:
  virtual ~TableSum() = default;

  /// @brief Sum all orders to tables.
  /// @param[in] requests contents of the tables
  /// @param[in] phi_reach,theta_reach largest offsets, at most half the nodes per revolution
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  /// @return one table per request
  [[nodiscard]] virtual std::vector<Table> tables(const std::vector<TableRequest>& requests, int phi_reach,
                                                  int theta_reach, int threads, Watch& watch) const = 0;
};

}  // namespace viscoroll::detail

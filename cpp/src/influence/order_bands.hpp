/// @file
/// @brief The orders that are summed in one direction, docs/theory/influence-tables.md.
///
/// A sum cut at an order N_t, as in the paper, takes every whole order up to it. The sum over all orders needs far
/// fewer: it is split by smooth steps P_b from 1 to 0, each at twice the order of the one before or a little less, into
/// the band P_0, summed order by order, and the bands P_b - P_{b-1}, the octaves. Beyond the first, the compliance
/// varies as slowly as its order grows, so a band is smooth, its sum may be taken with a stride, and what it adds to a
/// table is confined to a neighborhood of the load that shrinks as the stride grows: some sixty orders serve every
/// octave.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modal/layered_body.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief Orders of one octave.
struct OrderBand {
  Eigen::ArrayXd orders;   ///< ascending from 0, not necessarily whole
  Eigen::ArrayXd weights;  ///< of each in the sum over orders of either sign
  int reach;               ///< offset in spacings beyond which the band adds nothing
};

/// @brief Every whole order up to `max_order`, with the same weight.
[[nodiscard]] std::vector<OrderBand> whole_orders(int max_order, int nodes_per_revolution);

/// @brief All orders that matter, to nine digits of a table's center.
/// @param[in] nodes_per_revolution of the patches
/// @param[in] finest_order order at which the compliance still has features of its own
/// @param[in] rough_orders orders up to which it may change abruptly: these are summed one by one
[[nodiscard]] std::vector<OrderBand> octaves(int nodes_per_revolution, double finest_order = 0.0,
                                             double rough_orders = 0.0);

/// @brief The same on an unbounded plane, which has no orders to be summed one by one: all orders below the first
/// octave are taken at equal ratios, down to where they displace all nodes alike. None is 0.
/// @param[in] nodes_per_revolution of the patches, along a circumference that makes wave numbers orders
/// @param[in] finest_order order at which the compliance still has features of its own
/// @param[in] refinement by how much orders lie closer than those of a smooth compliance
/// @param[in] widest offset that is asked for [rad], which on a wide wheel may be more than a circumference
[[nodiscard]] std::vector<OrderBand> unbounded_octaves(int nodes_per_revolution, double finest_order = 0.0,
                                                       double refinement = 1.0, double widest = 0.0);

/// @brief Orders for sums at offsets from a load that are no larger than a window.
/// @param[in] spacing of the patches [rad]
/// @param[in] top order at which the sum ends, smoothly
/// @param[in] largest_offset [rad], at most half a revolution
/// @param[in] rough_orders orders up to which the response may change abruptly: these are summed one by one
[[nodiscard]] std::vector<OrderBand> octaves_within(double spacing, double top, double largest_offset,
                                                    double rough_orders);

/// @brief Where the orders of a window begin that have no period.
struct LowestOrder {
  double share = 1e-9;             ///< per middle of the first octave
  bool stands_for_longer = false;  ///< whether the lowest stands for all below it, see `count_longest`
};

/// @brief The same on an unbounded plane.
/// @param[in] largest_offset [rad], of any size
/// @param[in] refinement as of `unbounded_octaves`
[[nodiscard]] std::vector<OrderBand> unbounded_octaves_within(double spacing, double top, double largest_offset,
                                                              const LowestOrder& lowest, double refinement = 1.0);

/// @brief On a hub the lowest order of an unbounded plane stands for all below it, whose weights fall in its ratio to
/// the next one: by loads on all of a wide wheel they displace nodes as others do.
void count_longest(OrderBand& lowest);

/// @return by how much orders of measured moduli, which have kinks, lie closer than those of smooth ones
[[nodiscard]] double refinement_of(const std::vector<Layer>& layers);

/// @return orders along phi up to which a measured modulus is taken point by point
[[nodiscard]] double material_rough_orders(const LayeredBody& body, double angular_speed, const Mesh& mesh);

/// @brief Smooth step between the degrees of a sphere that are summed one by one and those of the local metric.
/// @param[in] wave_number k, or l + 1/2
/// @param[in] middle of the step, maybe infinite
/// @return the share of the former, from 1 to 0
[[nodiscard]] double exact_share(double wave_number, double middle);

/// @return the degree from which on nothing that matters is left of the former: 2e-7
[[nodiscard]] double exact_end(double middle);

/// @param[in] body layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] mesh spacings, and the truncation, which a plane cannot have
/// @param[in] rough_orders at least these are summed one by one
/// @return bands along phi
/// @throws std::invalid_argument for a truncation on a plane
[[nodiscard]] std::vector<OrderBand> phi_bands(const LayeredBody& body, double angular_speed, const Mesh& mesh,
                                               double rough_orders = 0.0);
/// @return bands along theta
/// @throws std::invalid_argument for a truncation on a plane, or straight across a wheel
[[nodiscard]] std::vector<OrderBand> theta_bands(const LayeredBody& body, double angular_speed, const Mesh& mesh,
                                                 double rough_orders = 0.0, double widest = 0.0);

/// @return the order whose frequency a measured modulus is not asked to exceed, see `HarmonicBody`
[[nodiscard]] double measured_order(const Mesh& mesh);

/// @return the orders of all bands, one band after the other
[[nodiscard]] std::vector<double> all_orders(const std::vector<OrderBand>& bands);

}  // namespace viscoroll::detail

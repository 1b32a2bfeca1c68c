/// @file
/// @brief Orders that are summed in one direction (docs/theory/influence-tables.md).
///
/// A sum truncated at an order N_t, as in the paper, contains every integer order up to it. The sum over all orders
/// needs far fewer. Smooth steps P_b from 1 to 0, each at up to twice the order of the previous one, split it into the
/// band P_0, which is summed order by order, and the bands P_b - P_{b-1}, the octaves. Beyond the first band the
/// compliance varies on the scale of the order itself. An octave is therefore smooth, its sum may have a stride, and
/// its contribution to a table is confined to a neighborhood of the load that shrinks as the stride grows. About sixty
/// orders suffice for every octave.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modal/layered_body.hpp"
#include "viscoroll/mesh.hpp"

namespace viscoroll::detail {

/// @brief Orders of one band.
struct OrderBand {
  Eigen::ArrayXd orders;   ///< ascending from 0, not necessarily integers
  Eigen::ArrayXd weights;  ///< weight of each order in the sum over orders of both signs
  int reach;               ///< offset in spacings beyond which the band contributes nothing
};

/// @brief Every integer order up to `max_order`, with equal weights.
[[nodiscard]] std::vector<OrderBand> whole_orders(int max_order, int nodes_per_revolution);

/// @brief All orders that matter, to nine digits of a table's center.
/// @param[in] nodes_per_revolution number of patches per revolution
/// @param[in] finest_order highest order at which the compliance has features
/// @param[in] rough_orders orders up to which the compliance may change abruptly; these are summed one by one
[[nodiscard]] std::vector<OrderBand> octaves(int nodes_per_revolution, double finest_order = 0.0,
                                             double rough_orders = 0.0);

/// @brief All orders that matter on an unbounded plane.
/// No order is summed one by one. Below the first octave, orders have equal ratios, down to an order that displaces all
/// nodes equally; all of them are positive.
/// @param[in] nodes_per_revolution number of patches along the circumference that converts wave numbers to orders
/// @param[in] finest_order highest order at which the compliance has features
/// @param[in] refinement factor on the density of orders, relative to that for a smooth compliance
/// @param[in] widest largest offset [rad], which may exceed a circumference on a wide wheel
[[nodiscard]] std::vector<OrderBand> unbounded_octaves(int nodes_per_revolution, double finest_order = 0.0,
                                                       double refinement = 1.0, double widest = 0.0);

/// @brief Orders for sums at offsets from a load within a window.
/// @param[in] spacing width of the patches [rad]
/// @param[in] top order at which the sum ends smoothly
/// @param[in] largest_offset largest offset [rad], at most half a revolution
/// @param[in] rough_orders orders up to which the response may change abruptly; these are summed one by one
[[nodiscard]] std::vector<OrderBand> octaves_within(double spacing, double top, double largest_offset,
                                                    double rough_orders);

/// @brief Lowest order of a window without a period.
struct LowestOrder {
  double share = 1e-9;  ///< relative to the middle of the first step
  /// Whether the lowest order represents all longer waves, see `include_longer_waves`.
  bool represents_longer_waves = false;
};

/// @brief Orders for sums within a window on an unbounded plane.
/// @param[in] spacing width of the patches [rad]
/// @param[in] top order at which the sum ends smoothly
/// @param[in] largest_offset largest offset [rad], of any size
/// @param[in] lowest lowest order
/// @param[in] refinement same as in `unbounded_octaves`
[[nodiscard]] std::vector<OrderBand> unbounded_octaves_within(double spacing, double top, double largest_offset,
                                                              const LowestOrder& lowest, double refinement = 1.0);

/// @brief Increase the weight of the lowest order of an unbounded plane on a hub, so that it represents all longer
/// waves.
/// The weights of successive longer waves would form a geometric series, whose sum is included. The displacements of
/// these waves are as large as those of other orders if the load covers the whole width of a wheel.
void include_longer_waves(OrderBand& lowest);

/// @return factor on the density of orders for measured moduli, which have kinks, relative to smooth ones
[[nodiscard]] double refinement_of(const std::vector<Layer>& layers);

/// @return order along phi up to which orders are summed one by one because of a measured modulus
[[nodiscard]] double material_rough_orders(const LayeredBody& body, double angular_speed, const Mesh& mesh);

/// @brief Smooth step between the degrees of a sphere that are summed one by one and those that use the local metric.
/// @param[in] wave_number k, or l + 1/2
/// @param[in] middle middle of the step, may be infinite
/// @return weight of the sum over single degrees, from 1 to 0
[[nodiscard]] double exact_share(double wave_number, double middle);

/// @return degree from which that weight is negligible: 2e-7
[[nodiscard]] double exact_end(double middle);

/// @brief Bands of orders along phi.
/// @param[in] body layers
/// @param[in] angular_speed Omega [rad/s], > 0
/// @param[in] mesh spacings and truncation (not on a plane)
/// @param[in] rough_orders orders up to which at least all are summed one by one
/// @return bands along phi
/// @throws InvalidInput if the sum on a plane is truncated
[[nodiscard]] std::vector<OrderBand> phi_bands(const LayeredBody& body, double angular_speed, const Mesh& mesh,
                                               double rough_orders = 0.0);
/// @brief Bands of orders along theta; parameters same as in `phi_bands`.
/// @param[in] body,angular_speed,mesh,rough_orders same as in `phi_bands`
/// @param[in] widest largest offset [rad], see `unbounded_octaves`
/// @return bands along theta
/// @throws InvalidInput if the sum on a plane, or across a wheel, is truncated
[[nodiscard]] std::vector<OrderBand> theta_bands(const LayeredBody& body, double angular_speed, const Mesh& mesh,
                                                 double rough_orders = 0.0, double widest = 0.0);

/// @return order whose frequency is the highest at which a measured modulus is evaluated, see `HarmonicBody`
[[nodiscard]] double measured_order(const Mesh& mesh);

/// @return orders of all bands, one band after the other
[[nodiscard]] std::vector<double> all_orders(const std::vector<OrderBand>& bands);

}  // namespace viscoroll::detail

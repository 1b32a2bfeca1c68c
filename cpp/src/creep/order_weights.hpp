/// @file
/// @brief Compliance of layers with different relaxation functions at all orders: one weight for the instantaneous
/// compliance and one for each common retardation time, and the sums that give the influence tables of each weight.
#pragma once

#include <memory>
#include <vector>

#include "base/parallel.hpp"
#include "creep/layer_spectrum.hpp"
#include "influence/mesh_on_body.hpp"
#include "influence/table.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Weights C_0, C_1, ... of all orders. Immutable: threads may share it.
class OrderWeights {
 public:
  virtual ~OrderWeights() = default;

  /// @brief Series of one weight at an order, same as in `Spectrum::series`.
  /// @param[in] weight number of the weight
  /// @param[in] m order along
  /// @param[in] highest_n largest order n that is evaluated
  /// @param[out] series panels that cover n in [0, highest_n]
  virtual void series(std::size_t weight, double m, double highest_n, OrderSeries& series) const = 0;
};

/// @brief Weights of layers without inertia.
/// @param[in] layers layers of a sphere, a plane or a wheel, or of a cylinder under a wheel
/// @param[in] m orders along; under a wheel, 0 or at least 1
/// @param[in] highest_n largest order n that is evaluated
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
[[nodiscard]] std::shared_ptr<const OrderWeights> order_weights(const LayerSpectrum& layers,
                                                                const std::vector<double>& m, double highest_n,
                                                                int threads, Watch& watch);

/// @brief Sums for the tables of every weight, as for an elastic body with this weight as its compliance.
/// @param[in] layers same as in `order_weights`
/// @param[in] mesh spacings of the nodes
/// @param[in] threads number of threads, 0 for all cores
/// @param[in] watch progress and cancellation
/// @return sums for the instantaneous compliance and for each retardation time
[[nodiscard]] std::vector<std::unique_ptr<const TableSum>> weights_under_spot(const LayerSpectrum& layers,
                                                                              const MeshOnBody& mesh, int threads,
                                                                              Watch& watch);

/// @return the same sums in line contact, for a cylinder or a plane
[[nodiscard]] std::vector<std::unique_ptr<const TableSum>> weights_under_line(const LayerSpectrum& layers,
                                                                              const MeshOnBody& mesh, int threads,
                                                                              Watch& watch);

}  // namespace viscoroll::detail

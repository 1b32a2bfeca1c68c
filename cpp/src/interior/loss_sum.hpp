/// @file
/// @brief Dissipation inside the layers, by sums over given orders: docs/theory/dissipation.md.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "influence/fft.hpp"
#include "interior/depth_transfer.hpp"
#include "interior/inside.hpp"
#include "interior/load_spectrum.hpp"
#include "modal/depth_cut.hpp"
#include "modal/harmonic_body.hpp"
#include "viscoroll/interior.hpp"

namespace viscoroll::detail {

/// Highest order up to which the loss is summed.
inline constexpr int kHighestLossOrder = 20000;

/// @brief Places with their weights in the volume integral.
struct WeightedPlaces {
  std::vector<Place> places;
  std::vector<double> weights;  // dr [m]
};

/// @brief Places of the volume integral over the layers.
/// @param[in] body layers
/// @param[in] lowest,max_order range of the orders
[[nodiscard]] WeightedPlaces volume_nodes(const LayeredBody& body, double lowest, double max_order);

/// @brief Orders of the sum over both directions.
struct LossOrders {
  std::vector<double> m;        ///< orders along the path, ascending
  std::vector<double> weights;  ///< weight of each m; an order of weight 0 is left out
  Eigen::ArrayXd n;             ///< orders across, multiples of a spacing, ascending from 0
  double spacing = 1.0;         ///< distance of the orders n
  /// Weight of an order n: its spacing in an integral over orders, 1 in the sum over a period.
  double share = 1.0;
  int theta_nodes = 1;    ///< equally spaced places theta around the period 2 pi / spacing; 1 in line contact
  double highest;         ///< highest sqrt(m^2 + n^2)
  double measured_order;  ///< see `HarmonicBody`
};

/// @brief Dissipation inside the layers, summed over the orders m in parallel blocks.
class LossSum {
 public:
  /// @param[in] inside body and its angular speed
  /// @param[in] orders orders of the sum
  /// @param[in] nodes places at which the density is computed
  /// @param[in] loads surface stresses at the orders
  LossSum(const Inside& inside, LossOrders orders, WeightedPlaces nodes, LoadSpectrum loads);

  /// @param[in] threads,watch threads, progress and cancellation
  /// @return density at all places, and powers
  [[nodiscard]] LossDensity sum(int threads, Watch& watch) const;

 private:
  /// Dissipation of a block of orders m.
  struct BlockLosses {
    Eigen::ArrayXXd density;   // theta by place
    Eigen::ArrayXXd by_order;  // layer by order of the block
    double surface = 0.0;
  };

  /// Loads of one order m.
  struct OrderLoads {
    LoadRows same;
    LoadRows opposite;
  };

  void add_order(std::size_t order, Eigen::Index in_block, const DepthTransfer& transfer, BlockLosses& losses) const;
  [[nodiscard]] Eigen::ArrayXd density_of(const DepthTransfer& transfer, std::size_t p,
                                          const LayerStack<std::complex<double>>& layers, double m, Eigen::Index count,
                                          const OrderLoads& loads, ComplexBuffer& line) const;
  void to_theta(const std::array<ComponentRows, 2>& fields, std::size_t component, ComplexBuffer& line) const;
  [[nodiscard]] double surface_loss(const DepthTransfer& transfer, std::size_t boundary, double m,
                                    const OrderLoads& loads) const;
  [[nodiscard]] LossDensity collect(const std::vector<BlockLosses>& blocks, std::size_t count) const;

  std::vector<Place> places_;
  std::vector<double> weights_;
  LayerCuts cuts_;
  DepthLimit limit_;
  LossOrders orders_;
  HarmonicBody body_;
  LoadSpectrum loads_;
  DepthTransfers transfers_;
  ComplexFft transform_;
};

/// @brief Dissipation at given places, and its volume integral.
/// @param[in] inside,orders,loads same as in `LossSum`
/// @param[in] nodes places of the volume integral
/// @param[in] places places at which the density is returned; empty: those of the volume integral
/// @param[in] threads,watch threads, progress and cancellation
[[nodiscard]] LossDensity density_at(const Inside& inside, LossOrders orders, WeightedPlaces nodes,
                                     std::span<const Place> places, LoadSpectrum loads, int threads, Watch& watch);

}  // namespace viscoroll::detail

#include "transient/weight_sums.hpp"

#include <algorithm>
#include <utility>

#include "influence/line_sum.hpp"
#include "influence/synthesis.hpp"
#include "transient/weight_panels.hpp"
#include "transient/wheel_weights.hpp"

namespace viscoroll::detail {
namespace {

/// Without inertia the speed affects only the frequencies of moduli, which are relaxed ones.
constexpr double kAnySpeed = 1.0;

std::shared_ptr<const OrderWeights> weights_of(const LayerSpectrum& layers, const std::vector<double>& m,
                                               double highest_n, int threads, Watch& watch) {
  const auto [lowest_m, highest_m] = std::ranges::minmax(m);
  if (layers.metric().is_wheel()) {
    return std::make_shared<const WheelWeights>(layers, highest_m, highest_n, threads, watch);
  }
  return std::make_shared<const WeightPanels>(layers, lowest_m, highest_m, highest_n, threads, watch);
}

}  // namespace

std::vector<std::unique_ptr<const TableSum>> weights_under_spot(const LayerSpectrum& layers, const MeshOnBody& mesh,
                                                                int threads, Watch& watch) {
  const LayeredBody& body = layers.body_at_rest();
  const std::vector<OrderBand> along = phi_bands(body, kAnySpeed, mesh.rounded());
  const std::vector<OrderBand> across = theta_bands(body, kAnySpeed, mesh.rounded(), 0.0, mesh.widest());
  const std::vector<double> m = all_orders(along);
  const double highest_n = std::ranges::max(all_orders(across));
  const std::shared_ptr<const OrderWeights> weights = weights_of(layers, m, highest_n, threads, watch);
  std::vector<std::unique_ptr<const TableSum>> sums;
  sums.reserve(layers.weights());
  for (std::size_t w = 0; w < layers.weights(); ++w) {
    sums.push_back(std::make_unique<const OrderSum>(mesh, layers.metric().radius, along, across,
                                                    std::make_unique<WeightSpectrum>(weights, w, m, highest_n)));
  }
  return sums;
}

std::vector<std::unique_ptr<const TableSum>> weights_under_line(const LayerSpectrum& layers, const MeshOnBody& mesh,
                                                                int threads, Watch& watch) {
  constexpr std::size_t kBlock = 16;  // orders that are solved together
  // Each order is solved separately, because there are few.
  const std::vector<OrderBand> bands = phi_bands(layers.body_at_rest(), kAnySpeed, mesh.rounded());
  const std::vector<double> m = all_orders(bands);
  std::vector<std::vector<Eigen::Matrix3cd>> spectra(layers.weights(), std::vector<Eigen::Matrix3cd>(m.size()));
  parallel_for((m.size() + kBlock - 1) / kBlock, threads, watch, "solving layers",
               [&](std::size_t block, const Worker&) {
                 const std::size_t first = block * kBlock;
                 std::vector<SurfaceOrder> orders;
                 for (std::size_t i = first; i < std::min(first + kBlock, m.size()); ++i) {
                   orders.push_back({.m = m[i], .n = 0.0});
                 }
                 const auto weights = layers.weights_of(orders);
                 for (std::size_t i = 0; i < orders.size(); ++i) {
                   for (std::size_t w = 0; w < layers.weights(); ++w) {
                     spectra[w][first + i] = weights[i][w].cast<std::complex<double>>();
                   }
                 }
               });
  std::vector<std::unique_ptr<const TableSum>> sums;
  sums.reserve(layers.weights());
  for (auto& spectrum : spectra) {
    sums.push_back(std::make_unique<const LineSum>(bands, std::move(spectrum), layers.metric().radius, mesh));
  }
  return sums;
}

}  // namespace viscoroll::detail

#include "influence/order_bands.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace viscoroll::detail {
namespace {

constexpr double kSharpness = 4.8;     // M / sigma of chi: what is left of it at order 0 is erfc(4.8) / 2 = 6e-12
constexpr double kNegligible = 1e-13;  // weight of orders left out
constexpr double kFirstOctave = 32.0;  // M of the first band, to twice as much

/// The last octave, in nodes per revolution: so many oscillations of a patch's transform fit into its end that they
/// cancel.
constexpr double kLastOctave = 16.0;

/// Smooth step from 1 to 0 around the order `middle`.
double chi(double order, double middle) { return 0.5 * std::erfc((order - middle) * kSharpness / middle); }

/// Orders 0, stride, 2 stride, ... with the weights of the trapezoidal rule, those of either sign taken together.
template <class Weight>
OrderBand make_band(double stride, double highest, int reach, const Weight& weight) {
  std::vector<double> orders;
  std::vector<double> weights;
  for (int i = 0; i * stride <= highest; ++i) {
    const double share = weight(i * stride);
    if (share < kNegligible) continue;
    orders.push_back(i * stride);
    weights.push_back((i == 0 ? 1.0 : 2.0) * stride * share);
  }
  const auto count = static_cast<Eigen::Index>(orders.size());
  return {.orders = Eigen::Map<const Eigen::ArrayXd>(orders.data(), count),
          .weights = Eigen::Map<const Eigen::ArrayXd>(weights.data(), count),
          .reach = reach};
}

}  // namespace

std::vector<OrderBand> whole_orders(int max_order, int nodes_per_revolution) {
  return {make_band(1.0, max_order, nodes_per_revolution / 2, [](double) { return 1.0; })};
}

std::vector<OrderBand> octaves(int nodes_per_revolution) {
  using std::numbers::pi;
  const double spacing = 2.0 * pi / nodes_per_revolution;
  double top = kLastOctave * nodes_per_revolution;
  int count = 0;
  for (; top >= 2.0 * kFirstOctave; top /= 2.0) ++count;

  double middle = top;
  std::vector<OrderBand> bands{
      make_band(1.0, 3.0 * middle, nodes_per_revolution / 2, [&](double order) { return chi(order, middle); })};
  for (int octave = 1; octave <= count; ++octave, middle *= 2.0) {
    // Transform of the lower, narrower step: exp(-(sigma x / 2)^2), sigma = middle / sharpness; then two patches.
    const double confined = 2.0 * kSharpness * kSharpness / middle + spacing;
    const double stride = pi / confined;  // images of the load stay apart
    const int reach = std::min(nodes_per_revolution / 2, static_cast<int>(confined / spacing));
    bands.push_back(make_band(stride, 6.0 * middle, reach,
                              [&](double order) { return chi(order, 2.0 * middle) - chi(order, middle); }));
  }
  return bands;
}

std::vector<OrderBand> phi_bands(const Mesh& mesh) {
  return mesh.max_order ? whole_orders(*mesh.max_order, mesh.nodes_per_revolution) : octaves(mesh.nodes_per_revolution);
}

std::vector<OrderBand> theta_bands(const Mesh& mesh) {
  const int nodes = theta_nodes_per_revolution(mesh);
  return mesh.max_order ? whole_orders(*mesh.max_order, nodes) : octaves(nodes);
}

std::vector<double> all_orders(const std::vector<OrderBand>& bands) {
  std::vector<double> orders;
  for (const OrderBand& band : bands) orders.insert(orders.end(), band.orders.begin(), band.orders.end());
  return orders;
}

}  // namespace viscoroll::detail

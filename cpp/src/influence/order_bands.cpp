#include "influence/order_bands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <variant>

#include "base/validate.hpp"
#include "modal/harmonic_moduli.hpp"
#include "viscoroll/slow_terms.hpp"

namespace viscoroll::detail {
namespace {

constexpr double kSharpness = 4.8;     // middle / width of chi, whose complement at order 0 is erfc(4.8) / 2 = 6e-12
constexpr double kNegligible = 1e-13;  // weight of omitted orders
constexpr double kFirstOctave = 32.0;  // middle of the step of the first band
constexpr double kFirstUnboundedOctave = 16.0;

/// Order at the end of the last octave, in nodes per revolution. The transform of a patch oscillates so often over its
/// step that the oscillations cancel.
constexpr double kLastOctave = 16.0;

/// Sharpness of the first step for a measured modulus: the step must fall within less than its own order.
constexpr double kSharpnessOfMeasured = 13.0;

/// Highest order up to which a measured modulus is summed order by order; beyond, it is treated as smooth.
constexpr double kMaxRoughOrders = 2000.0;

/// Smooth step from 1 to 0.
struct Step {
  double middle;  ///< order at which the step is 1/2
  double sharpness = kSharpness;

  [[nodiscard]] double operator()(double order) const { return 0.5 * std::erfc((order / middle - 1.0) * sharpness); }
  /// Order at which the step is negligible.
  [[nodiscard]] double end() const { return middle * (1.0 + 6.0 / sharpness); }
};

/// Orders 0, stride, 2 stride, ... with the weights of the trapezoidal rule, orders of both signs taken together.
template <class Weight>
OrderBand make_band(double stride, double highest, int reach, const Weight& weight) {
  std::vector<double> orders;
  std::vector<double> weights;
  for (int i = 0; i * stride <= highest; ++i) {
    const double share = weight(i * stride);
    if (std::abs(share) < kNegligible) continue;
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

namespace {

/// Append octaves from the middle of one step up to `top`. The argument of `stride_of` is the distance from the load to
/// which a band is confined [rad].
template <class Stride>
void append_octaves(Step below, double top, double spacing, const Stride& stride_of, std::vector<OrderBand>& bands) {
  const int half = static_cast<int>(std::lround(std::numbers::pi / spacing));
  const double first = below.middle;
  const auto count = static_cast<int>(std::ceil(std::log2(top / first)));
  for (int octave = 1; octave <= count; ++octave) {
    const Step step{.middle = first * std::pow(top / first, static_cast<double>(octave) / count)};
    // Transform of the lower, narrower step: exp(-(sigma x / 2)^2), sigma = middle / sharpness; then two patches.
    const double confined = 2.0 * kSharpness * below.sharpness / below.middle + spacing;
    const int reach = std::min(half, static_cast<int>(confined / spacing));
    bands.push_back(
        make_band(stride_of(confined), step.end(), reach, [&](double order) { return step(order) - below(order); }));
    below = step;
  }
}

/// Bands up to `top`; the first one consists of integer orders.
template <class Stride>
std::vector<OrderBand> split(double spacing, double top, double rough_orders, const Stride& stride_of) {
  const int half = static_cast<int>(std::lround(std::numbers::pi / spacing));
  const double first = std::min(std::max(kFirstOctave, 1.5 * rough_orders), top);
  const bool sharp = rough_orders > 0.0 && first < top;
  const Step lowest{.middle = first, .sharpness = sharp ? kSharpnessOfMeasured : kSharpness};
  std::vector<OrderBand> bands{make_band(1.0, lowest.end(), half, lowest)};
  append_octaves(lowest, top, spacing, stride_of, bands);
  return bands;
}

double spacing_of(int nodes_per_revolution) { return 2.0 * std::numbers::pi / nodes_per_revolution; }

double highest_order(int nodes_per_revolution, double finest_order) {
  // The number of orders, and with it the work, is proportional to this ratio. A mesh of fewer nodes does not resolve a
  // contact on the layer.
  constexpr double kMaxPerNode = 5000.0;
  if (finest_order > kMaxPerNode * nodes_per_revolution) {
    reject("mesh.nodes_per_revolution",
           "at least " + rounded(std::ceil(finest_order / kMaxPerNode)) +
               ", because the thinnest layer of one material is 1/" + rounded(finest_order) + " of the radius",
           std::to_string(nodes_per_revolution));
  }
  return kLastOctave * std::max(static_cast<double>(nodes_per_revolution), finest_order);
}

/// Lowest order relative to the middle of the first step; the omitted orders displace all nodes equally.
constexpr double kLowestOfTables = 1e-9;

/// Stride of the logarithms for tables. With x the largest angle of a table, a stride h leaves the error exp(-(2 pi / h
/// - middle x)^2 / (4 sharpness^2)): 1e-10 at x = 120 degrees, for tables that reach 60 degrees on either side.
double stride_of_tables(double refinement, double widest) {
  constexpr double kLogarithmicStride = 0.07;
  constexpr double kUsualWidest = 2.1;  // these 120 degrees [rad]
  return kLogarithmicStride / (refinement * std::max(1.0, widest / kUsualWidest));
}

/// Stride of the logarithms for fields within a window, whose error may be 1e-6.
double stride_of_fields(const Step& step, double refinement, double widest) {
  constexpr double kRootOfDigits = 3.72;  // square root of ln(1e6)
  return 2.0 * std::numbers::pi / (step.middle * widest + 2.0 * kRootOfDigits * step.sharpness) / refinement;
}

/// Orders below a step, at equal ratios: their functions are as smooth in the logarithm.
/// @param[in] step first step
/// @param[in] stride stride of the logarithms
/// @param[in] lowest lowest order, relative to the middle of the step
/// @param[in] reach offset in spacings beyond which the band contributes nothing
OrderBand low_orders(const Step& step, double stride, double lowest, int reach) {
  const auto count = static_cast<Eigen::Index>(std::log(step.end() / (lowest * step.middle)) / stride);
  const Eigen::ArrayXd orders =
      step.end() * (stride * Eigen::ArrayXd::LinSpaced(count, 1.0 - static_cast<double>(count), 0.0)).exp();
  return {.orders = orders, .weights = 2.0 * stride * orders * orders.unaryExpr(step), .reach = reach};
}

}  // namespace

void include_longer_waves(OrderBand& lowest) {
  const double ratio = lowest.orders[1] / lowest.orders[0];
  lowest.weights[0] *= ratio / (ratio - 1.0);
}

std::vector<OrderBand> unbounded_octaves(int nodes_per_revolution, double finest_order, double refinement,
                                         double widest) {
  const Step first{.middle = kFirstUnboundedOctave};
  const double spacing = spacing_of(nodes_per_revolution);
  const int reach = std::max(nodes_per_revolution / 2, static_cast<int>(std::ceil(widest / spacing)));
  std::vector<OrderBand> bands{low_orders(first, stride_of_tables(refinement, widest), kLowestOfTables, reach)};
  append_octaves(
      first, highest_order(nodes_per_revolution, finest_order), spacing,
      [refinement](double confined) { return std::numbers::pi / confined / refinement; }, bands);
  return bands;
}

std::vector<OrderBand> octaves(int nodes_per_revolution, double finest_order, double rough_orders) {
  // With these strides, the periodic images of the load do not overlap.
  return split(spacing_of(nodes_per_revolution), highest_order(nodes_per_revolution, finest_order), rough_orders,
               [](double confined) { return std::numbers::pi / confined; });
}

std::vector<OrderBand> octaves_within(double spacing, double top, double largest_offset, double rough_orders) {
  using std::numbers::pi;
  const double highest = std::min(top, kLastOctave * 2.0 * pi / spacing);
  // With these strides, the periodic images of the load lie outside the window.
  return split(spacing, highest, rough_orders,
               [&](double confined) { return std::max(1.0, 2.0 * pi / (largest_offset + confined)); });
}

std::vector<OrderBand> unbounded_octaves_within(double spacing, double top, double largest_offset,
                                                const LowestOrder& lowest, double refinement) {
  using std::numbers::pi;
  const double highest = std::min(top, kLastOctave * 2.0 * pi / spacing);
  const Step first{.middle = std::min(kFirstUnboundedOctave, highest)};
  // Orders that begin as low as those of tables are as dense as those of tables.
  const double stride = lowest.share > kLowestOfTables ? stride_of_fields(first, refinement, largest_offset)
                                                       : stride_of_tables(refinement, largest_offset);
  std::vector<OrderBand> bands{low_orders(first, stride, lowest.share, static_cast<int>(std::lround(pi / spacing)))};
  if (lowest.represents_longer_waves) include_longer_waves(bands.front());
  append_octaves(
      first, highest, spacing, [&](double confined) { return 2.0 * pi / (largest_offset + confined) / refinement; },
      bands);
  return bands;
}

double refinement_of(const std::vector<Layer>& layers) {
  constexpr double kRefinementOfMeasured = 4.0;  // kinks leave an error of second order in the stride
  return measured_layers(layers).empty() ? 1.0 : kRefinementOfMeasured;
}

namespace {

/// Whether two layers have the same material at the relevant frequencies.
bool have_same_material(const Layer& a, const Layer& b, double angular_speed) {
  const std::array frequencies{0.0, angular_speed, 8.0 * angular_speed};  // every mesh evaluates these
  return a.poisson_ratio == b.poisson_ratio && a.bulk_modulus == b.bulk_modulus &&
         modulus_in_rolling(a.shear_modulus, angular_speed, frequencies) ==
             modulus_in_rolling(b.shear_modulus, angular_speed, frequencies);
}

/// Order of the thinnest layer, at which an incompressible layer is most compliant. Neighbors of one material count as
/// one layer.
double finest_order(const LayeredBody& body, double angular_speed) {
  const std::vector<Layer>& layers = body.layers;
  double thinnest = std::numeric_limits<double>::infinity();
  double thickness = 0.0;
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const bool joined = l > 0 && have_same_material(layers[l - 1], layers[l], angular_speed);
    if (l > 0 && !joined) thinnest = std::min(thinnest, thickness);
    thickness = layers[l].thickness + (joined ? thickness : 0.0);
  }
  return body.metric.radius / std::min(thinnest, thickness);
}

/// Straight directions are not periodic, so their orders are not integers and cannot be truncated.
void require_all_orders(const Metric& metric, const Mesh& mesh) {
  if (!mesh.max_order) return;
  const std::string what = metric.is_wheel() ? "wheel tread" : "plane";
  reject("mesh.max_order", "left out with a deformable " + what + ", whose wavenumbers are continuous",
         std::to_string(*mesh.max_order));
}

}  // namespace

// Interpolated master curves have kinks, and users' functions may have kinks.
double material_rough_orders(const LayeredBody& body, double angular_speed, const Mesh& mesh) {
  const double highest_evaluated = std::min(kMaxRoughOrders, measured_order(mesh));
  double highest = 0.0;
  for (const Layer& layer : body.layers) {
    if (const auto* curve = std::get_if<MasterCurve>(&layer.shear_modulus)) {
      if (!curve->frequency.empty()) highest = std::max(highest, curve->frequency.back() / angular_speed);
    } else if (std::holds_alternative<CustomModulus>(layer.shear_modulus)) {
      highest = std::max(
          highest, highest_kink(layer.shear_modulus, angular_speed, highest_evaluated * angular_speed) / angular_speed);
    }
  }
  return std::min({highest, kMaxRoughOrders, 2.0 * measured_order(mesh)});  // `measured_order` is approached slowly
}

double exact_share(double wave_number, double middle) {
  return std::isinf(middle) ? 1.0 : Step{.middle = middle}(wave_number);
}

double exact_end(double middle) { return middle * (1.0 + 3.6 / kSharpness); }

std::vector<OrderBand> phi_bands(const LayeredBody& body, double angular_speed, const Mesh& mesh, double rough_orders) {
  const int nodes = mesh.nodes_per_revolution;
  if (!body.metric.is_curved()) {
    require_all_orders(body.metric, mesh);
    return unbounded_octaves(nodes, finest_order(body, angular_speed), refinement_of(body.layers));
  }
  if (mesh.max_order) return whole_orders(*mesh.max_order, nodes);
  return octaves(nodes, finest_order(body, angular_speed),
                 std::max(rough_orders, material_rough_orders(body, angular_speed, mesh)));
}

std::vector<OrderBand> theta_bands(const LayeredBody& body, double angular_speed, const Mesh& mesh, double rough_orders,
                                   double widest) {
  const int nodes = theta_nodes_per_revolution(mesh);
  if (body.metric.across == AxisKind::line) {
    require_all_orders(body.metric, mesh);
    std::vector<OrderBand> bands = unbounded_octaves(nodes, finest_order(body, angular_speed), 1.0, widest);
    if (body.metric.is_wheel()) include_longer_waves(bands.front());
    return bands;
  }
  return mesh.max_order ? whole_orders(*mesh.max_order, nodes)
                        : octaves(nodes, finest_order(body, angular_speed), rough_orders);
}

double measured_order(const Mesh& mesh) {
  return mesh.max_order ? std::numeric_limits<double>::infinity() : 2.0 * mesh.nodes_per_revolution;
}

std::vector<double> all_orders(const std::vector<OrderBand>& bands) {
  std::vector<double> orders;
  for (const OrderBand& band : bands) orders.insert(orders.end(), band.orders.begin(), band.orders.end());
  return orders;
}

}  // namespace viscoroll::detail

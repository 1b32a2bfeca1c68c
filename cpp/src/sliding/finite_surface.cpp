#include "sliding/finite_surface.hpp"

#include <numbers>
#include <utility>

#include "base/invalid_speed.hpp"
#include "influence/mesh_on_body.hpp"
#include "influence/order_bands.hpp"
#include "influence/table_product.hpp"
#include "influence/table_sums.hpp"
#include "modal/harmonic_body.hpp"
#include "modal/layered_body.hpp"
#include "sliding/sliding_symbol.hpp"
#include "surface/table_operator.hpp"

namespace viscoroll::detail {
namespace {

using Tables = std::shared_ptr<const std::vector<Table>>;

constexpr Formulation kPressed{
    .compliance = Compliance::radial, .patch_load = PatchLoad::flat, .tangential = false, .is_counterbody = true};

/// Rows of the map per revolution of the circumference that converts wave numbers to orders. On a plane, it only has to
/// be so long that the map is shorter than half of it.
constexpr int kRowsPerRevolution = 4;

NodeRange centered(int count) { return {-(count / 2), count - 1 - count / 2}; }

std::unique_ptr<const TableSum> sum_of_waves(const LayeredBody& layers, double angular_speed, const MeshOnBody& mesh,
                                             bool is_line, const Execution& execution) {
  const auto& [threads, watch] = execution;
  if (!is_line) return std::make_unique<const CoatingSum>(layers, angular_speed, mesh, threads, watch);
  std::vector<OrderBand> bands = phi_bands(layers, angular_speed, mesh.rounded());
  const HarmonicBody harmonics(layers, angular_speed, all_orders(bands), measured_order(mesh.rounded()));
  return std::make_unique<const LineSum>(std::move(bands), harmonics, mesh, threads, watch);
}

Tables shared(Table table) {
  auto tables = std::make_shared<std::vector<Table>>();
  tables->push_back(std::move(table));
  return tables;
}

}  // namespace

FiniteSurface::FiniteSurface(const HeightMap& map, const CoatedPlane& on, double speed, double friction,
                             const Execution& execution)
    : radius_(kRowsPerRevolution * map.rows * map.spacing_x / (2.0 * std::numbers::pi)) {
  const bool is_line = map.columns == 1;
  const double phi_spacing = map.spacing_x / radius_;
  const double theta_spacing = is_line ? phi_spacing : map.spacing_z / radius_;
  const MeshOnBody mesh(Mesh{.nodes_per_revolution = kRowsPerRevolution * map.rows}, 1.0, theta_spacing,
                        map.columns * theta_spacing);
  const LayeredBody layers = layered_body(on, radius_);
  const auto sum = with_given_speed({.parameter = "speed", .value = speed, .unit = "m/s"}, [&] {
    return speed == 0.0 ? sum_of_waves(relaxed_layers(layers), kAnySpeed, mesh, is_line, execution)
                        : sum_of_waves(layers, speed / radius_, mesh, is_line, execution);
  });
  std::vector<TableRequest> requests;
  std::vector<Entry> entries{Entry::rr};
  if (friction > 0.0) entries.insert(entries.end(), {Entry::rphi, Entry::phiphi});
  for (const Entry entry : entries) {
    for (const bool power : {false, true}) requests.push_back({.entry = entry, .power = power});
  }
  std::vector<Table> tables = sum->tables(requests, map.rows - 1, map.columns - 1, execution.threads, execution.watch);
  // [rr, its power, rphi, its power, phiphi, its power]
  Table displaced = tables[0];
  Table pressed = tables[1];
  Table lost = std::move(tables[1]);
  if (friction > 0.0) {
    // The friction on the layers points along x, against xi, and the pressure inwards: the signs cancel. Reciprocity,
    // C_phir = -C_rphi, cancels the work of either at the displacement due to the other.
    add(friction, tables[2], displaced);
    add(friction, tables[3], pressed);
    add(friction * friction, tables[5], lost);
  }
  pressed_ = shared(std::move(pressed));
  lost_ = shared(std::move(lost));
  const SurfaceGrid grid{
      .radius = radius_, .phi_spacing = phi_spacing, .theta_spacing = theta_spacing, .is_paraboloid = true};
  const Window window{centered(map.rows), is_line ? NodeRange{0, 0} : centered(map.columns)};
  displacement_ = std::make_shared<TableOperator>(kPressed, grid, window, shared(std::move(displaced)),
                                                  TableOperator::DissipationSource{}, execution);
}

double FiniteSurface::work(const Eigen::ArrayXd& pressing, const Tables& tables) const {
  const WindowShape shape = displacement_->shape();
  const Execution& execution = displacement_->execution();
  const Convolution product(shape, *tables, {{.result = 0, .table = 0, .operand = 0, .sign = 1.0}}, execution.threads,
                            execution.watch);
  return (pressing * product.apply(pressing, execution.threads, execution.watch).col(0)).sum() / radius_;
}

Eigen::ArrayXd FiniteSurface::slope_along(const Eigen::ArrayXd& values) const {
  return patch_slope(values, displacement_->shape().theta_nodes, displacement_->row_distance());
}

}  // namespace viscoroll::detail

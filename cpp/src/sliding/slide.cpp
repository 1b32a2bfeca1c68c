// Contact of a sliding rough surface, and its friction: docs/theory/sliding.md.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "contact/multilevel.hpp"
#include "sliding/finite_surface.hpp"
#include "sliding/map_spectrum.hpp"
#include "sliding/sliding_input.hpp"
#include "sliding/sliding_symbol.hpp"
#include "surface/table_operator.hpp"
#include "viscoroll/sliding.hpp"

namespace viscoroll {
namespace {

using detail::SlidingPeriod;
using detail::SlidingSymbol;
using Eigen::Index;

/// Share of the nodes that are assumed to be in contact at first.
constexpr double kFirstShare = 0.1;

std::shared_ptr<const detail::SurfaceOperator> periodic_surface(const SlidingSymbol& symbol,
                                                                const detail::Execution& execution) {
  const auto& [shape, length_x, length_z] = symbol.period();
  // With a radius of 1 m, the spacings of the plane's nodes are angles.
  const detail::SurfaceGrid grid{.radius = 1.0,
                                 .phi_spacing = length_x / shape.phi_nodes,
                                 .theta_spacing = length_z / shape.theta_nodes,
                                 .is_paraboloid = true};
  const detail::Window window{{0, shape.phi_nodes - 1}, {0, shape.theta_nodes - 1}};
  auto tables = std::make_shared<std::vector<detail::Table>>();
  tables->push_back(symbol.table());
  const detail::Formulation formulation{
      .compliance = Compliance::radial, .patch_load = PatchLoad::flat, .tangential = false, .is_counterbody = true};
  // The spectrum of the pressure gives the dissipated work, so that no tables of it are needed.
  return std::make_shared<detail::TableOperator>(formulation, grid, window, std::move(tables),
                                                 detail::TableOperator::DissipationSource{}, execution, shape);
}

/// Gap below which the given share of the nodes lies.
double gap_of_share(const Eigen::ArrayXd& gap, double share) {
  std::vector<double> sorted(gap.begin(), gap.end());
  const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size()));
  std::ranges::nth_element(sorted, place);
  return *place;
}

/// Means over the surface of products of pressure with slopes [Pa].
struct Means {
  double loss;            ///< work dissipated in the layers per area and distance
  double displacement;    ///< pressure times slope of the displacement along xi
  double heights_along;   ///< pressure times slope of the heights along xi
  double heights_across;  ///< same along z
};

Means spectral_means(const SlidingSymbol& symbol, const std::vector<double>& heights,
                     const std::vector<double>& pressure) {
  const SlidingPeriod& period = symbol.period();
  const detail::MapSpectrum height(heights, period.nodes);
  Means means{};
  detail::MapSpectrum(pressure, period.nodes).for_waves([&](int i, int j, std::complex<double> p, double weight) {
    const double power = (height(i, j) * std::conj(p)).imag();
    means.loss -= weight * period.k_x(i) * symbol.of_losses(i, j).imag() * std::norm(p);
    means.displacement -= weight * period.k_x(i) * symbol(i, j).imag() * std::norm(p);
    means.heights_along -= weight * period.k_x(i) * power;
    // The highest wave across has no direction, and a profile has no waves across.
    if (2 * j != period.nodes.theta_nodes) means.heights_across -= weight * period.k_z(j) * power;
  });
  return means;
}

/// Sum of forces times the slope of the heights along z.
double work_across(const HeightMap& map, const Eigen::ArrayXd& height, const Eigen::ArrayXd& force) {
  if (map.columns == 1) return 0.0;
  using Rows = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto transposed = [&](const Eigen::ArrayXd& values) {
    const Rows columns = Eigen::Map<const Rows>(values.data(), map.rows, map.columns).transpose();
    return Eigen::ArrayXd(Eigen::Map<const Eigen::ArrayXd>(columns.data(), columns.size()));
  };
  return (transposed(force) * detail::patch_slope(transposed(height), map.rows, map.spacing_z)).sum();
}

Means nodal_means(const detail::FiniteSurface& surface, const HeightMap& map, double speed,
                  const Eigen::ArrayXd& height, const Eigen::ArrayXd& force) {
  const double area = detail::period_of(map).patch_area() * static_cast<double>(height.size());
  // At rest there is no friction, and the sums over waves would leave their rounding errors.
  return {.loss = speed > 0.0 ? surface.loss(force) / area : 0.0,
          .displacement = speed > 0.0 ? surface.work_of_pressure(force) / area : 0.0,
          .heights_along = (force * surface.slope_along(height)).sum() / area,
          .heights_across = work_across(map, height, force) / area};
}

/// Share of the patches in contact.
struct ContactShare {
  double of_nodes;
  double corrected;
};

/// Contacts end within the rim of a map that is not periodic, so that its nodes may be counted like those of a period.
ContactShare contact_share(const std::vector<double>& pressure, const detail::WindowShape& shape) {
  const auto [rows, columns] = shape;
  const auto touches = [&](int row, int column) {
    const Index node = static_cast<Index>(row % rows) * columns + column % columns;
    return pressure[static_cast<std::size_t>(node)] > 0.0;
  };
  double contacts = 0.0;
  double edges = 0.0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const bool here = touches(row, column);
      contacts += here ? 1.0 : 0.0;
      edges += (here != touches(row + 1, column) ? 1.0 : 0.0) + (here != touches(row, column + 1) ? 1.0 : 0.0);
    }
  }
  // V. A. Yastrebov, G. Anciaux and J.-F. Molinari, Tribol. Int. 114 (2017) 161-171
  constexpr double kAreaPerEdge = (std::numbers::pi - 1.0 + std::numbers::ln2) / 24.0;
  const auto nodes = static_cast<double>(shape.size());
  return {.of_nodes = contacts / nodes,
          .corrected = columns == 1 ? contacts / nodes : (contacts - kAreaPerEdge * edges) / nodes};
}

}  // namespace

SlidingResult slide(const HeightMap& map, const CoatedPlane& on, double pressure, double speed,
                    const SlidingOptions& options) {
  detail::validate_sliding(map, on, pressure, speed, options);
  detail::Watch watch(options.observer);
  const detail::Execution execution{options.threads, watch};
  const SlidingPeriod period = detail::period_of(map);
  const std::vector<double> heights = detail::heights_against_path(map);
  const Eigen::Map<const Eigen::ArrayXd> height(heights.data(), static_cast<Index>(heights.size()));
  const auto nodes = static_cast<double>(height.size());
  std::optional<SlidingSymbol> symbol;
  std::optional<detail::FiniteSurface> finite;
  if (map.periodic) {
    symbol.emplace(on, period, speed, options.friction, options.threads, watch);
  } else {
    finite.emplace(map, on, speed, options.friction, execution);
  }

  const detail::ContactProblem problem{
      .surface = finite ? finite->displacement() : periodic_surface(*symbol, execution),
      .initial_gap = height.maxCoeff() - height,
      .normal_force = pressure * nodes * period.patch_area(),
      .friction = {}};
  const detail::LocatedContact located =
      solve_multilevel(problem, gap_of_share(problem.initial_gap, kFirstShare),
                       {.max_iterations = options.max_iterations, .tolerance = options.tolerance});
  const bool is_whole = located.window() == problem.surface->window();
  const detail::ContactSolution contact = is_whole ? located.contact : extended(located, problem);

  const Eigen::ArrayXd force = pressing_force(contact);
  const Eigen::ArrayXd nodal = force / period.patch_area();
  const std::vector<double> nodal_pressure(nodal.begin(), nodal.end());
  const Means means =
      finite ? nodal_means(*finite, map, speed, height, force) : spectral_means(*symbol, heights, nodal_pressure);
  const ContactShare share = contact_share(nodal_pressure, period.nodes);
  // Work of the friction at the strain of the surface that pressure and friction cause.
  const double strain_work = means.loss - means.displacement;
  SlidingResult result;
  result.friction_coefficient = means.loss / pressure;
  result.traction_friction = (means.heights_along + strain_work) / pressure;
  result.friction_error = std::abs(result.traction_friction - result.friction_coefficient);
  result.total_friction_coefficient = options.friction + means.displacement / pressure;
  result.side_force_coefficient = means.heights_across / pressure;
  result.power_density = speed * means.loss;
  result.interface_power_density = speed * (options.friction * pressure - strain_work);
  result.contact_share = share.of_nodes;
  result.corrected_contact_share = share.corrected;
  result.mean_gap = contact.gap.mean();
  result.max_pressure = nodal.maxCoeff();
  result.memory_length = detail::memory_length(on, speed, period.length_x, speed * period.k_x(map.rows / 2));
  result.residual = contact.residual;
  result.iterations = contact.iterations;
  result.operator_applications = contact.operator_applications;
  result.converged = contact.converged;
  result.pressure = detail::with_reversed_rows(nodal_pressure, map.columns);
  result.gap = detail::with_reversed_rows({contact.gap.begin(), contact.gap.end()}, map.columns);
  return result;
}

}  // namespace viscoroll

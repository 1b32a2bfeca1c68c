#include "surface/table_operator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "influence/waves.hpp"

namespace viscoroll::detail {
namespace {

/// Number of components (r, phi, theta) that are displaced and loaded.
std::size_t components(const Formulation& formulation) {
  return formulation.compliance == Compliance::radial && !formulation.tangential ? 1 : 3;
}

std::size_t shapes(const Formulation& formulation) {
  return formulation.patch_load == PatchLoad::flat ? 1 : std::size_t{kPatchShapes};
}

TableRequest displacement_request(const Formulation& formulation, Entry entry, std::size_t source) {
  return {.entry = entry, .source_shape = static_cast<int>(source), .phi_shift = formulation.collocation};
}

/// Pairs of patch shapes whose degrees add up to at most 2, which makes the work as accurate as the displacements.
std::vector<std::pair<std::size_t, std::size_t>> shape_pairs(const Formulation& formulation) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t receiver = 0; receiver < shapes(formulation); ++receiver) {
    for (std::size_t source = 0; source + receiver < shapes(formulation); ++source) {
      pairs.emplace_back(receiver, source);
    }
  }
  return pairs;
}

/// Exchanging the two degrees conjugates i^(receiver - source), so one table serves both orders.
TableRequest dissipation_request(Entry entry, std::size_t receiver, std::size_t source) {
  return {.entry = entry,
          .source_shape = static_cast<int>(std::max(receiver, source)),
          .power = true,
          .receiver_shape = static_cast<int>(std::min(receiver, source))};
}

double dissipation_sign(std::size_t receiver, std::size_t source) {
  return receiver > source && (receiver - source) % 2 == 1 ? -1.0 : 1.0;
}

/// Finds the tables of a formulation. Its loaded fields have the numbers component * shapes + shape.
class Terms {
 public:
  explicit Terms(const Formulation& formulation) : formulation_(formulation), shapes_(shapes(formulation)) {}

  [[nodiscard]] std::vector<ConvolutionTerm> displacement() const {
    const auto requests = displacement_tables(formulation_);
    std::vector<ConvolutionTerm> terms;
    for_component_pairs([&](std::size_t p, std::size_t q, SignedEntry c) {
      for (std::size_t source = 0; source < shapes_; ++source) {
        terms.push_back(
            {p, index_of(displacement_request(formulation_, c.entry, source), requests), q * shapes_ + source, c.sign});
      }
    });
    return terms;
  }

  [[nodiscard]] std::vector<ConvolutionTerm> dissipation() const {
    const auto requests = dissipation_tables(formulation_);
    std::vector<ConvolutionTerm> terms;
    for_component_pairs([&](std::size_t p, std::size_t q, SignedEntry c) {
      for (const auto& [receiver, source] : shape_pairs(formulation_)) {
        terms.push_back({p * shapes_ + receiver, index_of(dissipation_request(c.entry, receiver, source), requests),
                         q * shapes_ + source, c.sign * dissipation_sign(receiver, source)});
      }
    });
    return terms;
  }

 private:
  template <class Function>
  void for_component_pairs(const Function& function) const {
    for (std::size_t p = 0; p < components(formulation_); ++p) {
      for (std::size_t q = 0; q < components(formulation_); ++q) function(p, q, entry_of(p, q));
    }
  }

  [[nodiscard]] static std::size_t index_of(const TableRequest& request, const std::vector<TableRequest>& requests) {
    return static_cast<std::size_t>(std::ranges::find(requests, request) - requests.begin());
  }

  Formulation formulation_;
  std::size_t shapes_;
};

/// If the loaded part of a window has a period below this fraction of the whole window's period, a separate product
/// for this part takes less time.
constexpr double kSeparateProductPeriod = 0.8;

/// Rows, and columns around the middle, that contain all forces.
LoadedNodes loaded_nodes(const VectorField& force, const Window& window) {
  const auto [rows, columns] = window.shape();
  if (window.theta.first != -window.theta.last) return {.first_row = 0, .rows = rows, .columns = columns};
  int first = rows;
  int last = -1;
  int aside = 0;
  for (int row = 0; row < rows; ++row) {
    const auto line = force.middleRows(static_cast<Eigen::Index>(row) * columns, columns);
    for (int column = 0; column < columns; ++column) {
      if ((line.row(column) == 0.0).all()) continue;
      first = std::min(first, row);
      last = row;
      aside = std::max(aside, std::abs(column - columns / 2));
    }
  }
  if (last < 0) return {.first_row = 0, .rows = 1, .columns = 1};
  return {.first_row = first, .rows = last - first + 1, .columns = 2 * aside + 1};
}

/// Call function(node, image) for the nodes of one side, including those in the middle.
template <class Function>
void for_images(const Window& window, const Function& function) {
  const Eigen::Index columns = window.theta.count();
  for (Eigen::Index row = 0; row < window.phi.count(); ++row) {
    const Eigen::Index middle = row * columns + columns / 2;
    for (Eigen::Index k = 0; k <= columns / 2; ++k) function(middle + k, middle - k);
  }
}

/// Whether forces are mirror-symmetric: equal at mirror images, but opposite along z.
bool is_mirrored(const VectorField& force, const Window& window) {
  bool same = true;
  for_images(window, [&](Eigen::Index node, Eigen::Index image) {
    same = same && force(node, kForward) == force(image, kForward) && force(node, kDown) == force(image, kDown) &&
           force(node, kSideways) == -force(image, kSideways);
  });
  return same;
}

/// Period of every other node; none if it contains an odd number of nodes, unless it is a single column.
std::optional<WindowShape> halved(const WindowShape& period) {
  const auto [rows, columns] = period;
  if (rows % 2 != 0 || (columns != 1 && columns % 2 != 0)) return std::nullopt;
  return WindowShape{rows / 2, columns == 1 ? 1 : columns / 2};
}

/// Copy the displacements of one side to the mirror images.
void mirror(VectorField& displacement, const Window& window) {
  for_images(window, [&](Eigen::Index node, Eigen::Index image) {
    displacement(image, kForward) = displacement(node, kForward);
    displacement(image, kDown) = displacement(node, kDown);
    displacement(image, kSideways) = -displacement(node, kSideways);
  });
}

}  // namespace

std::vector<std::array<WindowField, 3>> load_directions(const Formulation& formulation, const SurfacePoints& points) {
  using Eigen::ArrayXd;
  std::vector<std::array<WindowField, 3>> directions(components(formulation));
  if (formulation.compliance == Compliance::radial) {
    const auto constant = [&](double value) {
      return WindowField{
          ArrayXd::Constant(points.window.phi.count(), value), ArrayXd::Ones(points.window.theta.count()), {}};
    };
    const std::array<std::size_t, 3> axis_of{kDown, kForward, kSideways};
    for (std::size_t p = 0; p < directions.size(); ++p) {
      directions[p].fill(constant(0.0));
      directions[p][axis_of[p]] = constant(p == 0 || formulation.is_counterbody ? 1.0 : -1.0);
    }
    if (formulation.tangential) {
      const Curvatures& curvatures = formulation.counterbody_curvatures;
      const bool of_counterbody = formulation.is_counterbody;
      // The inclination is the angle rather than x/r_o. It then turns as fast as the body, as the moment arms y + u_r
      // of the driving torque assume.
      directions[0][kForward] = points.angle_ahead();
      if (of_counterbody) directions[0][kForward].rows *= -curvatures.along * points.grid.radius;
      directions[0][kSideways] = points.z();
      directions[0][kSideways].rows *= of_counterbody ? -curvatures.across : 1.0 / points.grid.radius_across();
    }
    return directions;
  }
  const auto axes = points.axes();
  for (std::size_t p = 0; p < 3; ++p) directions[p] = {axes[0][p], axes[1][p], axes[2][p]};
  return directions;
}

std::vector<Eigen::ArrayXd> patch_weights(const Formulation& formulation, const SurfacePoints& points) {
  const NodeRange& range = points.window.theta;
  if (formulation.patch_load == PatchLoad::flat) return {Eigen::ArrayXd::Ones(range.count())};
  const double spacing = points.grid.theta_spacing;
  std::vector<Eigen::ArrayXd> weights;
  weights.reserve(shapes(formulation));
  for (std::size_t shape = 0; shape < shapes(formulation); ++shape) {
    weights.emplace_back(Eigen::ArrayXd::NullaryExpr(range.count(), [&](Eigen::Index column) {
      const double theta = std::numbers::pi / 2.0 + static_cast<double>(range.first + column) * spacing;
      return spherical_patch_weights(theta, spacing)[shape];
    }));
  }
  return weights;
}

namespace {

template <class Function>
void for_entries(const Formulation& formulation, const Function& function) {
  for (std::size_t p = 0; p < components(formulation); ++p) {
    for (std::size_t q = p; q < components(formulation); ++q) function(entry_of(p, q).entry);
  }
}

}  // namespace

std::vector<TableRequest> displacement_tables(const Formulation& formulation) {
  std::vector<TableRequest> requests;
  for_entries(formulation, [&](Entry entry) {
    for (std::size_t source = 0; source < shapes(formulation); ++source) {
      requests.push_back(displacement_request(formulation, entry, source));
    }
  });
  return requests;
}

std::vector<TableRequest> dissipation_tables(const Formulation& formulation) {
  std::vector<TableRequest> requests;
  for_entries(formulation, [&](Entry entry) {
    for (const auto& [receiver, source] : shape_pairs(formulation)) {
      if (receiver <= source) requests.push_back(dissipation_request(entry, receiver, source));
    }
  });
  return requests;
}

TableOperator::TableOperator(const Formulation& formulation, const SurfaceGrid& grid, const Window& window,
                             Tables tables, DissipationSource dissipation_source, const Execution& execution,
                             std::optional<WindowShape> period)
    : formulation_(formulation),
      grid_(grid),
      window_(window),
      tables_(std::move(tables)),
      dissipation_source_(std::move(dissipation_source)),
      local_{.tables = {},
             .directions = load_directions(formulation, {grid, window}),
             .displaced_directions = load_directions(formulation, {grid, window, formulation.collocation})},
      weights_(patch_weights(formulation, {grid, window})),
      by_nodes_(window.shape(), tables_, Terms(formulation).displacement()),
      execution_(execution),
      period_(period) {
  const auto requests = displacement_tables(formulation);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (requests[i].source_shape != 0) continue;
    local_.tables[static_cast<std::size_t>(requests[i].entry)] = {tables_, &(*tables_)[i]};
  }
}

double TableOperator::load(const VectorField& force, Eigen::Index row, Eigen::Index column, std::size_t field) const {
  const auto& [forward, down, sideways] = local_.directions[field / weights_.size()];
  const Eigen::Index node = row * window_.theta.count() + column;
  return weights_[field % weights_.size()][column] *
         (forward(row, column) * force(node, kForward) + down(row, column) * force(node, kDown) +
          sideways(row, column) * force(node, kSideways));
}

const Convolution& TableOperator::spectral_displacements() const {
  if (displacements_) return *displacements_;
  const std::vector<ConvolutionTerm> terms = Terms(formulation_).displacement();
  const auto& [threads, watch] = execution_;
  if (period_) return displacements_.emplace(window_.shape(), *period_, *tables_, terms, threads, watch);
  return displacements_.emplace(window_.shape(), *tables_, terms, threads, watch);
}

double TableOperator::operations() const {
  return SpectralProduct::operations(period_.value_or(doubled(window_.shape())), fields(),
                                     Terms(formulation_).displacement().size(), local_.directions.size());
}

bool TableOperator::takes_mirrored() const {
  return weights_.size() == 1 && window_.theta.first == -window_.theta.last;
}

std::vector<bool> TableOperator::odd_components() const {
  std::vector<bool> odd(local_.directions.size());
  if (odd.size() == 3) odd[2] = true;
  return odd;
}

VectorField TableOperator::displacement(const VectorField& force) const {
  if (std::optional<VectorField> found = displacement_by_nodes(force)) return *std::move(found);
  if (displacements_ || period_) return displacement(force, spectral_displacements());
  const LoadedNodes loaded = loaded_nodes(force, window_);
  const WindowShape shape = window_.shape();
  const WindowShape period = doubled(shape, {.phi_nodes = loaded.rows, .theta_nodes = loaded.columns});
  if (static_cast<double>(period.size()) > kSeparateProductPeriod * static_cast<double>(doubled(shape).size())) {
    return displacement(force, spectral_displacements());
  }
  return displacement(force, Convolution(shape, loaded, *tables_, Terms(formulation_).displacement(),
                                         execution_.threads, execution_.watch));
}

SpectralProduct::Fill TableOperator::loads(const VectorField& force, Eigen::Index middle) const {
  return [this, &force, middle](int row, std::size_t field, double* line) {
    for (Eigen::Index k = middle; k < window_.theta.count(); ++k) line[k - middle] = load(force, row, k, field);
  };
}

SpectralProduct::Take TableOperator::moves(VectorField& result, Eigen::Index middle) const {
  return [this, &result, middle](int row, std::size_t component, const double* line) {
    const Eigen::Index columns = window_.theta.count();
    for (const Axis axis : {kForward, kDown, kSideways}) {
      const WindowField& direction = local_.displaced_directions[component][static_cast<std::size_t>(axis)];
      for (Eigen::Index k = middle; k < columns; ++k) {
        result(row * columns + k, axis) += direction(row, k) * line[k - middle];
      }
    }
  };
}

std::optional<VectorField> TableOperator::displacement_by_nodes(const VectorField& force) const {
  VectorField result = VectorField::Zero(force.rows(), 3);
  if (!by_nodes_.apply(fields(), loads(force, 0), moves(result, 0))) return std::nullopt;
  return result;
}

VectorField TableOperator::displacement(const VectorField& force, const Convolution& product) const {
  const bool mirrored = takes_mirrored() && is_mirrored(force, window_);
  const Eigen::Index middle = mirrored ? window_.theta.count() / 2 : 0;
  VectorField result = VectorField::Zero(force.rows(), 3);
  const auto& [threads, watch] = execution_;
  if (mirrored) {
    product.apply_mirrored(odd_components(), loads(force, middle), moves(result, middle), threads, watch);
    mirror(result, window_);
  } else {
    product.apply(fields(), loads(force, middle), moves(result, middle), threads, watch);
  }
  return result;
}

Eigen::VectorXd TableOperator::normal_displacement(const NodeRows& nodes, const Eigen::VectorXd& pressing) const {
  const auto& directions = local_.directions;
  Eigen::VectorXd result(pressing.size());
  const auto fill = [&](int row, std::size_t field, double* line) {
    const WindowField& direction = directions[field / weights_.size()][kDown];
    const Eigen::ArrayXd& weight = weights_[field % weights_.size()];
    nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) {
      const Eigen::Index column = nodes.first_column() + k;
      line[k] = weight[column] * direction(row, column) * pressing[i];
    });
  };
  const auto take = [&](int row, std::size_t component, const double* line) {
    const WindowField& direction = local_.displaced_directions[component][kDown];
    nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) {
      const double share = direction(row, nodes.first_column() + k) * line[k];
      result[i] = component == 0 ? share : result[i] + share;
    });
  };
  if (!nodes.mirrored() && by_nodes_.apply(fields(), fill, take)) return result;
  const auto& [threads, watch] = execution_;
  if (nodes.mirrored()) {
    spectral_displacements().apply_mirrored(odd_components(), fill, take, threads, watch);
  } else {
    spectral_displacements().apply(fields(), fill, take, threads, watch);
  }
  return result;
}

std::optional<Eigen::MatrixXd> TableOperator::normal_compliance(const std::vector<Eigen::Index>& displaced,
                                                                const std::vector<Eigen::Index>& loaded) const {
  const Eigen::Index columns = window_.theta.count();
  const auto values = [columns](const std::vector<Eigen::Index>& nodes, const auto& value) {
    Eigen::ArrayXd at(static_cast<Eigen::Index>(nodes.size()));
    std::ranges::transform(nodes, at.begin(), [&](Eigen::Index node) { return value(node / columns, node % columns); });
    return at;
  };
  Eigen::MatrixXd compliance;
  for (const ConvolutionTerm& term : by_nodes_.terms()) {
    const Eigen::ArrayXd& weight = weights_[term.operand % weights_.size()];
    const WindowField& pressed = local_.directions[term.operand / weights_.size()][kDown];
    const auto share_of_load = [&](Eigen::Index row, Eigen::Index column) {
      return weight[column] * pressed(row, column);
    };
    const auto& direction = local_.displaced_directions[term.result][kDown];
    Eigen::MatrixXd share = by_nodes_.between(term.table, {displaced, term.sign * values(displaced, direction)},
                                              {loaded, values(loaded, share_of_load)});
    if (compliance.size() == 0) {
      compliance = std::move(share);
    } else {
      compliance += share;
    }
  }
  return compliance;
}

std::shared_ptr<const SurfaceOperator> TableOperator::coarsened() const {
  Formulation flat = formulation_;
  flat.patch_load = PatchLoad::flat;
  const auto flat_tables = [formulation = formulation_, flat](const std::vector<Table>& fine, auto requests_of,
                                                              auto widen) {
    const auto requests = requests_of(formulation);
    std::vector<Table> coarse;
    for (const TableRequest& request : requests_of(flat)) {
      const auto place = std::ranges::find(requests, request) - requests.begin();
      coarse.push_back(widen(fine[static_cast<std::size_t>(place)]));
    }
    return std::make_shared<const std::vector<Table>>(std::move(coarse));
  };
  SurfaceGrid grid = grid_;
  grid.phi_spacing *= 2.0;
  grid.theta_spacing *= 2.0;
  // In the dissipated work, both the loads and the displacements are averages over wider patches.
  return std::make_shared<TableOperator>(
      flat, grid, window_.coarsened(),
      flat_tables(*tables_, displacement_tables,
                  [this](const Table& table) { return widened(table, 2, formulation_.collocation); }),
      [source = dissipation_source_, flat_tables](int phi_reach, int theta_reach) {
        return flat_tables(*source(2 * phi_reach + 2, 2 * theta_reach + 2), dissipation_tables,
                           [](const Table& table) { return widened(widened(table, 1), 2); });
      },
      execution_, period_ == window_.shape() ? halved(*period_) : std::nullopt);
}

std::shared_ptr<const SurfaceOperator> TableOperator::within(const Window& window) const {
  return std::make_shared<TableOperator>(formulation_, grid_, window, tables_, dissipation_source_, execution_,
                                         period_);
}

Losses TableOperator::dissipation(const VectorField& force) const {
  const auto [rows, columns] = window_.shape();
  const Tables tables = dissipation_source_(rows - 1, columns - 1);
  const std::vector<ConvolutionTerm> terms = Terms(formulation_).dissipation();
  Eigen::ArrayXd lost = Eigen::ArrayXd::Zero(rows);  // summed in an order that does not depend on the threads
  const auto accumulate = [&, width = columns](bool mirrored) -> SpectralProduct::Take {
    const Eigen::Index middle = mirrored ? width / 2 : 0;
    return [&, mirrored, middle, width](int row, std::size_t field, const double* line) {
      for (Eigen::Index k = middle; k < width; ++k) {
        const double images = mirrored && k > middle ? 2.0 : 1.0;
        lost[row] += images * load(force, row, k, field) * line[k - middle];
      }
    };
  };
  if (TableProduct({rows, columns}, tables, terms).apply(fields(), loads(force, 0), accumulate(false))) {
    return losses(lost.sum());
  }
  const auto& [threads, watch] = execution_;
  const Convolution product =
      period_ ? Convolution({rows, columns}, *period_, *tables, terms, threads, watch)
              : Convolution({rows, columns}, loaded_nodes(force, window_), *tables, terms, threads, watch);
  if (takes_mirrored() && is_mirrored(force, window_)) {
    product.apply_mirrored(odd_components(), loads(force, columns / 2), accumulate(true), threads, watch);
  } else {
    product.apply(fields(), loads(force, 0), accumulate(false), threads, watch);
  }
  return losses(lost.sum());
}

}  // namespace viscoroll::detail

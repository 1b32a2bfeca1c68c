#include "surface/table_operator.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "influence/patch.hpp"

namespace viscoroll::detail {
namespace {

/// Components (r, phi, theta) that are displaced and loaded.
std::size_t components(const Formulation& formulation) {
  return formulation.compliance == Compliance::radial && !formulation.tangential ? 1 : 3;
}

std::size_t shapes(const Formulation& formulation) {
  return formulation.patch_load == PatchLoad::flat ? 1 : std::size_t{kPatchShapes};
}

TableRequest displacement_request(const Formulation& formulation, Entry entry, std::size_t source) {
  return {.entry = entry, .source_shape = static_cast<int>(source), .phi_shift = formulation.collocation};
}

/// Work between patch shapes whose degrees add up to 2 at most, as exact as the displacements.
std::vector<std::pair<std::size_t, std::size_t>> shape_pairs(const Formulation& formulation) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t receiver = 0; receiver < shapes(formulation); ++receiver) {
    for (std::size_t source = 0; source + receiver < shapes(formulation); ++source) {
      pairs.emplace_back(receiver, source);
    }
  }
  return pairs;
}

/// Exchanging the degrees conjugates i^(receiver - source): one table serves both.
TableRequest dissipation_request(Entry entry, std::size_t receiver, std::size_t source) {
  return {.entry = entry,
          .source_shape = static_cast<int>(std::max(receiver, source)),
          .power = true,
          .receiver_shape = static_cast<int>(std::min(receiver, source))};
}

double dissipation_sign(std::size_t receiver, std::size_t source) {
  return receiver > source && (receiver - source) % 2 == 1 ? -1.0 : 1.0;
}

/// Finds the tables of a formulation, whose loaded fields are numbered component * shapes + shape.
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

}  // namespace

std::vector<std::array<Eigen::ArrayXd, 3>> load_directions(const Formulation& formulation,
                                                           const SurfaceWindow& window) {
  using Eigen::ArrayXd;
  std::vector<std::array<ArrayXd, 3>> directions(components(formulation));
  if (formulation.compliance == Compliance::radial) {
    const Eigen::Index count = window.shape().size();
    const std::array<std::size_t, 3> axis_of{kDown, kForward, kSideways};
    for (std::size_t p = 0; p < directions.size(); ++p) {
      directions[p].fill(ArrayXd::Zero(count));
      directions[p][axis_of[p]].setConstant(p == 0 || formulation.is_counterpart ? 1.0 : -1.0);
    }
    if (formulation.tangential && formulation.is_counterpart) {
      directions[0][kForward] = -formulation.counterpart_curvature * window.x();
    } else if (formulation.tangential) {
      directions[0][kForward] = window.x() / window.grid().radius;
      directions[0][kSideways] = window.z() / window.grid().radius_across();
    }
    return directions;
  }
  const auto axes = window.axes();
  for (std::size_t p = 0; p < 3; ++p) directions[p] = {axes[0][p], axes[1][p], axes[2][p]};
  return directions;
}

std::vector<Eigen::ArrayXd> patch_weights(const Formulation& formulation, const SurfaceWindow& window) {
  if (formulation.patch_load == PatchLoad::flat) return {Eigen::ArrayXd::Ones(window.shape().size())};
  std::vector<Eigen::ArrayXd> weights;
  weights.reserve(shapes(formulation));
  for (std::size_t shape = 0; shape < shapes(formulation); ++shape) {
    weights.emplace_back(window.theta().unaryExpr(
        [&](double theta) { return spherical_patch_weights(theta, window.grid().theta_spacing)[shape]; }));
  }
  return weights;
}

namespace {

/// Mean slope from row to row over the patches of nodes, which are as long as their distance: of the differences over
/// two rows and over four what leaves no error of second order, but for the last two rows, where hardly anything
/// presses.
Eigen::ArrayXd patch_slope(const Eigen::ArrayXd& values, Eigen::Index row, double distance) {
  const auto difference = [&](Eigen::Index rows) {
    const Eigen::Index count = values.size() - 2 * rows * row;
    return Eigen::ArrayXd((values.tail(count) - values.head(count)) / (2.0 * static_cast<double>(rows) * distance));
  };
  Eigen::ArrayXd slope = Eigen::ArrayXd::Zero(values.size());
  slope.segment(row, values.size() - 2 * row) = difference(1);
  const Eigen::Index inner = values.size() - 4 * row;
  if (inner <= 0) return slope;
  slope.segment(2 * row, inner) = 1.25 * slope.segment(2 * row, inner) - 0.25 * difference(2);
  return slope;
}

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

TableOperator::TableOperator(const Formulation& formulation, const SurfaceWindow& nodes, Tables tables,
                             DissipationSource dissipation_source, const Execution& execution)
    : formulation_(formulation),
      grid_(nodes.grid()),
      window_(nodes.window()),
      tables_(std::move(tables)),
      dissipation_source_(std::move(dissipation_source)),
      local_{
          .tables = {},
          .directions = load_directions(formulation, nodes),
          .displaced_directions = load_directions(formulation, SurfaceWindow(grid_, window_, formulation.collocation))},
      weights_(patch_weights(formulation, nodes)),
      displacements_(window_.shape(), *tables_, Terms(formulation).displacement(), execution.threads, execution.watch),
      execution_(execution) {
  const auto requests = displacement_tables(formulation);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (requests[i].source_shape != 0) continue;
    local_.tables[static_cast<std::size_t>(requests[i].entry)] = {tables_, &(*tables_)[i]};
  }
}

Eigen::ArrayXXd TableOperator::loads(const VectorField& force) const {
  Eigen::ArrayXXd loads(force.rows(), static_cast<Eigen::Index>(local_.directions.size() * weights_.size()));
  Eigen::Index field = 0;
  for (const auto& direction : local_.directions) {
    const Eigen::ArrayXd component =
        direction[0] * force.col(0) + direction[1] * force.col(1) + direction[2] * force.col(2);
    for (const Eigen::ArrayXd& weight : weights_) loads.col(field++) = weight * component;
  }
  return loads;
}

VectorField TableOperator::displacement(const VectorField& force) const {
  const Eigen::ArrayXXd components = displacements_.apply(loads(force), execution_.threads, execution_.watch);
  VectorField result = VectorField::Zero(force.rows(), 3);
  const auto& directions = local_.displaced_directions;
  for (std::size_t p = 0; p < directions.size(); ++p) {
    for (const Axis axis : {kForward, kDown, kSideways}) {
      result.col(axis) += directions[p][static_cast<std::size_t>(axis)] * components.col(static_cast<Eigen::Index>(p));
    }
  }
  return result;
}

VectorField TableOperator::rolling_displacement(const VectorField& force) const {
  return formulation_.is_counterpart ? VectorField(VectorField::Zero(force.rows(), 3)) : displacement(force);
}

double TableOperator::pushback(const VectorField& force) const {
  if (!formulation_.is_counterpart) return 0.0;
  const Eigen::ArrayXd depth = -displacement(force).col(kDown);
  return -(force.col(kDown) * patch_slope(depth, shape().theta_nodes, grid_.radius * grid_.phi_spacing)).sum();
}

Eigen::VectorXd TableOperator::normal_displacement(const NodeRows& nodes, const Eigen::VectorXd& pressing) const {
  const auto& directions = local_.directions;
  Eigen::VectorXd result(pressing.size());
  displacements_.apply(
      directions.size() * weights_.size(),
      [&](int row, std::size_t field, double* line) {
        const Eigen::ArrayXd& direction = directions[field / weights_.size()][kDown];
        const Eigen::ArrayXd& weight = weights_[field % weights_.size()];
        nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) {
          line[k] = weight[nodes.node(i)] * direction[nodes.node(i)] * pressing[i];
        });
      },
      [&](int row, std::size_t component, const double* line) {
        const Eigen::ArrayXd& direction = local_.displaced_directions[component][kDown];
        nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) {
          const double share = direction[nodes.node(i)] * line[k];
          result[i] = component == 0 ? share : result[i] + share;
        });
      },
      execution_.threads, execution_.watch);
  return result;
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
  // What is loaded and what is displaced are both averages over wider patches where work is lost.
  return std::make_shared<TableOperator>(
      flat, SurfaceWindow(grid, window_.coarsened()),
      flat_tables(*tables_, displacement_tables,
                  [this](const Table& table) { return widened(table, 2, formulation_.collocation); }),
      [source = dissipation_source_, flat_tables](int phi_reach, int theta_reach) {
        return flat_tables(*source(2 * phi_reach + 2, 2 * theta_reach + 2), dissipation_tables,
                           [](const Table& table) { return widened(widened(table, 1), 2); });
      },
      execution_);
}

std::shared_ptr<const SurfaceOperator> TableOperator::within(const Window& window) const {
  return std::make_shared<TableOperator>(formulation_, SurfaceWindow(grid_, window), tables_, dissipation_source_,
                                         execution_);
}

Losses TableOperator::dissipation(const VectorField& force) const {
  const WindowShape shape = window_.shape();
  const Tables tables = dissipation_source_(shape.phi_nodes - 1, shape.theta_nodes - 1);
  const Convolution product(shape, *tables, Terms(formulation_).dissipation(), execution_.threads, execution_.watch);
  const Eigen::ArrayXXd loads = this->loads(force);
  const double lost = (loads * product.apply(loads, execution_.threads, execution_.watch)).sum();
  return formulation_.is_counterpart ? Losses{.counterpart = lost} : Losses{.rolling = lost};
}

}  // namespace viscoroll::detail

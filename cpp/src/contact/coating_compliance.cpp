#include "contact/coating_compliance.hpp"

#include <algorithm>
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

TableRequest displacement_request(Entry entry, std::size_t source) {
  return {.entry = entry, .source_shape = static_cast<int>(source)};
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
TableRequest lost_work_request(Entry entry, std::size_t receiver, std::size_t source) {
  return {.entry = entry,
          .source_shape = static_cast<int>(std::max(receiver, source)),
          .power = true,
          .receiver_shape = static_cast<int>(std::min(receiver, source))};
}

double lost_work_sign(std::size_t receiver, std::size_t source) {
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
        terms.push_back({p, index_of(displacement_request(c.entry, source), requests), q * shapes_ + source, c.sign});
      }
    });
    return terms;
  }

  [[nodiscard]] std::vector<ConvolutionTerm> lost_work() const {
    const auto requests = lost_work_tables(formulation_);
    std::vector<ConvolutionTerm> terms;
    for_component_pairs([&](std::size_t p, std::size_t q, SignedEntry c) {
      for (const auto& [receiver, source] : shape_pairs(formulation_)) {
        terms.push_back({p * shapes_ + receiver, index_of(lost_work_request(c.entry, receiver, source), requests),
                         q * shapes_ + source, c.sign * lost_work_sign(receiver, source)});
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
    return static_cast<std::size_t>(std::find(requests.begin(), requests.end(), request) - requests.begin());
  }

  Formulation formulation_;
  std::size_t shapes_;
};

std::vector<std::array<Eigen::ArrayXd, 3>> load_directions(const Formulation& formulation,
                                                           const SurfaceWindow& window) {
  using Eigen::ArrayXd;
  std::vector<std::array<ArrayXd, 3>> directions(components(formulation));
  if (formulation.compliance == Compliance::radial) {
    const Eigen::Index count = window.shape().size();
    const std::array<Axis, 3> axis_of{kDown, kForward, kSideways};
    for (std::size_t p = 0; p < directions.size(); ++p) {
      directions[p].fill(ArrayXd::Zero(count));
      directions[p][axis_of[p]].setConstant(p == 0 ? 1.0 : -1.0);
    }
    if (formulation.tangential) {
      directions[0][kForward] = window.x() / window.grid().radius;
      directions[0][kSideways] = window.z() / window.grid().radius;
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
  for (std::size_t shape = 0; shape < shapes(formulation); ++shape) {
    weights.emplace_back(window.theta().unaryExpr(
        [&](double theta) { return spherical_patch_weights(theta, window.grid().theta_spacing)[shape]; }));
  }
  return weights;
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
      requests.push_back(displacement_request(entry, source));
    }
  });
  return requests;
}

std::vector<TableRequest> lost_work_tables(const Formulation& formulation) {
  std::vector<TableRequest> requests;
  for_entries(formulation, [&](Entry entry) {
    for (const auto& [receiver, source] : shape_pairs(formulation)) {
      if (receiver <= source) requests.push_back(lost_work_request(entry, receiver, source));
    }
  });
  return requests;
}

LoadComponents::LoadComponents(const Formulation& formulation, const SurfaceWindow& window)
    : directions(load_directions(formulation, window)), weights(patch_weights(formulation, window)) {}

Eigen::ArrayXXd LoadComponents::of(const VectorField& force) const {
  Eigen::ArrayXXd loads(force.rows(), static_cast<Eigen::Index>(directions.size() * weights.size()));
  Eigen::Index field = 0;
  for (const auto& direction : directions) {
    const Eigen::ArrayXd component =
        direction[0] * force.col(0) + direction[1] * force.col(1) + direction[2] * force.col(2);
    for (const Eigen::ArrayXd& weight : weights) loads.col(field++) = weight * component;
  }
  return loads;
}

CoatingCompliance::CoatingCompliance(const Formulation& formulation, const SurfaceWindow& window,
                                     std::shared_ptr<const std::vector<Table>> tables, const Execution& execution)
    : formulation_(formulation),
      shape_(window.shape()),
      tables_(std::move(tables)),
      displacement_terms_(Terms(formulation).displacement()),
      components_(formulation, window),
      displacements_(shape_, *tables_, displacement_terms_, execution.threads, execution.watch),
      execution_(execution) {}

VectorField CoatingCompliance::displacement(const VectorField& force) const {
  const Eigen::ArrayXXd components = displacements_.apply(components_.of(force), execution_.threads, execution_.watch);
  VectorField result = VectorField::Zero(shape_.size(), 3);
  for (std::size_t p = 0; p < components_.directions.size(); ++p) {
    for (const Axis axis : {kForward, kDown, kSideways}) {
      result.col(axis) += components_.directions[p][axis] * components.col(static_cast<Eigen::Index>(p));
    }
  }
  return result;
}

InverseConvolution CoatingCompliance::make_inverse(WindowShape period) const {
  std::vector<ConvolutionTerm> flat;
  for (ConvolutionTerm term : displacement_terms_) {
    if (term.operand % components_.weights.size() != 0) continue;
    term.operand /= components_.weights.size();
    flat.push_back(term);
  }
  return {shape_, period, *tables_, flat, execution_.threads, execution_.watch};
}

InverseConvolution CoatingCompliance::make_inverse_of(Entry entry, WindowShape period) const {
  const auto place = static_cast<std::size_t>(&table(entry) - tables_->data());
  return {
      shape_,          period, *tables_, {{.result = 0, .table = place, .operand = 0, .sign = 1.0}}, execution_.threads,
      execution_.watch};
}

VectorField CoatingCompliance::approximate_force(const InverseConvolution& inverse,
                                                 const VectorField& displacement) const {
  const auto& directions = components_.directions;
  Eigen::ArrayXXd moved(displacement.rows(), static_cast<Eigen::Index>(directions.size()));
  for (std::size_t p = 0; p < directions.size(); ++p) {
    moved.col(static_cast<Eigen::Index>(p)) = directions[p][0] * displacement.col(0) +
                                              directions[p][1] * displacement.col(1) +
                                              directions[p][2] * displacement.col(2);
  }
  const Eigen::ArrayXXd loads = inverse.apply(moved, execution_.threads, execution_.watch);
  VectorField force = VectorField::Zero(displacement.rows(), 3);
  for (std::size_t p = 0; p < directions.size(); ++p) {
    for (const Axis axis : {kForward, kDown, kSideways}) {
      force.col(axis) += directions[p][axis] * loads.col(static_cast<Eigen::Index>(p));
    }
  }
  return force;
}

const Table& CoatingCompliance::table(Entry entry) const {
  const auto requests = displacement_tables(formulation_);
  const auto place = std::find(requests.begin(), requests.end(), displacement_request(entry, 0)) - requests.begin();
  return (*tables_)[static_cast<std::size_t>(place)];
}

Eigen::ArrayXd CoatingCompliance::vertical_displacement(const Eigen::ArrayXd& pressing) const {
  const auto& directions = components_.directions;
  const auto& weights = components_.weights;
  Eigen::ArrayXXd loads(pressing.size(), static_cast<Eigen::Index>(directions.size() * weights.size()));
  Eigen::Index field = 0;
  for (const auto& direction : directions) {
    for (const Eigen::ArrayXd& weight : weights) loads.col(field++) = weight * direction[kDown] * pressing;
  }
  const Eigen::ArrayXXd moved = displacements_.apply(loads, execution_.threads, execution_.watch);
  Eigen::ArrayXd result = directions[0][kDown] * moved.col(0);
  for (std::size_t p = 1; p < directions.size(); ++p) {
    result += directions[p][kDown] * moved.col(static_cast<Eigen::Index>(p));
  }
  return result;
}

Eigen::VectorXd CoatingCompliance::vertical_displacement(const NodeRows& nodes, const Eigen::VectorXd& pressing) const {
  const auto& directions = components_.directions;
  const auto& weights = components_.weights;
  Eigen::VectorXd result(pressing.size());
  displacements_.apply(
      directions.size() * weights.size(),
      [&](int row, std::size_t field, double* line) {
        const Eigen::ArrayXd& direction = directions[field / weights.size()][kDown];
        const Eigen::ArrayXd& weight = weights[field % weights.size()];
        nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) {
          line[k] = weight[nodes.node(i)] * direction[nodes.node(i)] * pressing[i];
        });
      },
      [&](int row, std::size_t component, const double* line) {
        const Eigen::ArrayXd& direction = directions[component][kDown];
        nodes.for_row(row, [&](Eigen::Index i, Eigen::Index k) {
          const double share = direction[nodes.node(i)] * line[k];
          result[i] = component == 0 ? share : result[i] + share;
        });
      },
      execution_.threads, execution_.watch);
  return result;
}

double lost_work(const Formulation& formulation, const SurfaceWindow& window, const std::vector<Table>& tables,
                 const VectorField& force, const Execution& execution) {
  const Convolution product(window.shape(), tables, Terms(formulation).lost_work(), execution.threads, execution.watch);
  const Eigen::ArrayXXd loads = LoadComponents(formulation, window).of(force);
  return (loads * product.apply(loads, execution.threads, execution.watch)).sum();
}

Eigen::ArrayXXd CoatingCompliance::moved_components(std::span<const Eigen::Index> targets, Eigen::Index source,
                                                    std::span<const Axis> axes) const {
  const auto axis_count = static_cast<Eigen::Index>(axes.size());
  const auto source_phi = static_cast<int>(source / shape_.theta_nodes);
  const auto source_theta = static_cast<int>(source % shape_.theta_nodes);
  Eigen::ArrayXXd moved = Eigen::ArrayXXd::Zero(static_cast<Eigen::Index>(targets.size()),
                                                static_cast<Eigen::Index>(components_.directions.size()) * axis_count);
  for (const ConvolutionTerm& term : displacement_terms_) {
    const auto& direction = components_.directions[term.operand / components_.weights.size()];
    const double weight = term.sign * components_.weights[term.operand % components_.weights.size()][source];
    Eigen::Array3d loads = Eigen::Array3d::Zero();
    for (Eigen::Index b = 0; b < axis_count; ++b) loads[b] = weight * direction[axes[b]][source];
    if ((loads == 0.0).all()) continue;
    const Table& table = (*tables_)[term.table];
    auto result = moved.middleCols(static_cast<Eigen::Index>(term.result) * axis_count, axis_count);
    for (std::size_t row = 0; row < targets.size(); ++row) {
      const double influence = table(static_cast<int>(targets[row] / shape_.theta_nodes) - source_phi,
                                     static_cast<int>(targets[row] % shape_.theta_nodes) - source_theta);
      for (Eigen::Index b = 0; b < axis_count; ++b) result(static_cast<Eigen::Index>(row), b) += loads[b] * influence;
    }
  }
  return moved;
}

Eigen::MatrixXd CoatingCompliance::block(std::span<const Eigen::Index> targets, std::span<const Eigen::Index> sources,
                                         std::span<const Axis> axes) const {
  const auto rows = static_cast<Eigen::Index>(targets.size());
  const auto columns = static_cast<Eigen::Index>(sources.size());
  const auto axis_count = static_cast<Eigen::Index>(axes.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows * axis_count, columns * axis_count);
  parallel_for(sources.size(), execution_.threads, execution_.watch, "assembling the compliance",
               [&](std::size_t source, const Worker&) {
                 const Eigen::ArrayXXd moved = moved_components(targets, sources[source], axes);
                 for (Eigen::Index b = 0; b < axis_count; ++b) {
                   auto column = matrix.col(b * columns + static_cast<Eigen::Index>(source));
                   for (std::size_t p = 0; p < components_.directions.size(); ++p) {
                     const auto component = moved.col(static_cast<Eigen::Index>(p) * axis_count + b);
                     for (Eigen::Index a = 0; a < axis_count; ++a) {
                       column.segment(a * rows, rows).array() +=
                           components_.directions[p][axes[a]](targets) * component;
                     }
                   }
                 }
               });
  return matrix;
}

}  // namespace viscoroll::detail

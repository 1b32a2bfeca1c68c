#include "rolling/table_store.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "base/parallel.hpp"
#include "influence/table_product.hpp"

namespace viscoroll::detail {
namespace {

/// Up to this reach, computing the compliances of the orders costs more than summing them, so that tables of all kinds
/// are made together.
constexpr int kShortReach = 128;

std::vector<TableRequest> requests(const Formulation& formulation, TableKind kind) {
  switch (kind) {
    case TableKind::displacement:
      return displacement_tables(formulation);
    case TableKind::forward:
      return {{.entry = Entry::rphi}};
    case TableKind::dissipation:
      return dissipation_tables(formulation);
  }
  return {};
}

/// Smallest part of a window that contains two lists of nodes.
class Box {
 public:
  Box(const WindowShape& window, const std::vector<Eigen::Index>& first, const std::vector<Eigen::Index>& second)
      : columns_(window.theta_nodes) {
    Eigen::Index last_row = -1;
    Eigen::Index last_column = -1;
    first_row_ = window.phi_nodes;
    first_column_ = columns_;
    for (const auto* nodes : {&first, &second}) {
      for (const Eigen::Index node : *nodes) {
        first_row_ = std::min(first_row_, node / columns_);
        last_row = std::max(last_row, node / columns_);
        first_column_ = std::min(first_column_, node % columns_);
        last_column = std::max(last_column, node % columns_);
      }
    }
    shape_.phi_nodes = static_cast<int>(last_row - first_row_ + 1);
    shape_.theta_nodes = static_cast<int>(last_column - first_column_ + 1);
  }

  [[nodiscard]] const WindowShape& shape() const { return shape_; }

  /// @return numbers in this part of nodes of the window
  [[nodiscard]] std::vector<Eigen::Index> numbers(const std::vector<Eigen::Index>& nodes) const {
    std::vector<Eigen::Index> own(nodes.size());
    std::ranges::transform(nodes, own.begin(), [&](Eigen::Index node) {
      return (node / columns_ - first_row_) * shape_.theta_nodes + node % columns_ - first_column_;
    });
    return own;
  }

 private:
  Eigen::Index columns_;  // of the window
  Eigen::Index first_row_ = 0;
  Eigen::Index first_column_ = 0;
  WindowShape shape_{};
};

/// Whether the tables of forward displacements are not among those of the contact.
bool has_forward_tables(const Formulation& formulation) {
  return formulation.compliance == Compliance::radial && formulation.patch_load == PatchLoad::flat &&
         !formulation.tangential && !formulation.is_counterbody;
}

}  // namespace

std::shared_ptr<const SurfaceOperator> TableStore::operator_on(const SurfaceWindow& nodes,
                                                               const Formulation& formulation,
                                                               const Execution& execution) const {
  const auto [phi_nodes, theta_nodes] = nodes.shape();
  return std::make_shared<TableOperator>(
      formulation, nodes.grid(), nodes.window(),
      tables(formulation, TableKind::displacement, phi_nodes - 1, theta_nodes - 1, execution),
      [this, formulation, execution](int phi_reach, int theta_reach) {
        return tables(formulation, TableKind::dissipation, phi_reach, theta_reach, execution);
      },
      execution);
}

Eigen::ArrayXd TableStore::forward_displacement(const SurfaceWindow& nodes, const Formulation& formulation,
                                                const std::vector<Eigen::Index>& displaced, const VectorField& force,
                                                const Execution& execution) const {
  if (!has_forward_tables(formulation)) {
    return SurfaceTables::forward_displacement(nodes, formulation, displaced, force, execution);
  }
  std::vector<Eigen::Index> loaded;
  for (Eigen::Index node = 0; node < force.rows(); ++node) {
    if (force(node, kDown) != 0.0) loaded.push_back(node);
  }
  // The window is larger than the contact, and tables of its size take longer.
  const Box box(nodes.shape(), loaded, displaced);
  const auto product = [&](TableKind kind) {
    return TableProduct(
        box.shape(), tables(formulation, kind, box.shape().phi_nodes - 1, box.shape().theta_nodes - 1, execution), {});
  };
  const TableProduct normal = product(TableKind::displacement);
  const TableProduct mixed = product(TableKind::forward);
  const std::vector<Eigen::Index> sources = box.numbers(loaded);
  const WeightedNodes loads{sources, force.col(kDown)(loaded)};
  const std::vector<Eigen::Index> targets = box.numbers(displaced);
  const double sign = entry_of(1, 0).sign;
  Eigen::ArrayXd forward(static_cast<Eigen::Index>(displaced.size()));
  for (std::size_t i = 0; i < displaced.size(); ++i) {
    const std::vector<Eigen::Index> target{targets[i]};
    const WeightedNodes node{target, Eigen::ArrayXd::Ones(1)};
    const double radial = normal.between(0, node, loads).sum();
    const double along = sign * mixed.between(0, node, loads).sum();
    // A radial displacement moves the surface forward, since x is -phi.
    forward[static_cast<Eigen::Index>(i)] = nodes.x()[displaced[i]] / nodes.grid().radius * radial - along;
  }
  return forward;
}

TableOperator::Tables TableStore::tables(const Formulation& formulation, TableKind kind, int phi_reach, int theta_reach,
                                         const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  if (const TableSet* set = find(formulation, kind)) {
    if (set->phi_reach >= phi_reach && set->theta_reach >= theta_reach) return set->tables;
    // Extend the reach by half, so that increasing loads need few new sets.
    phi_reach = std::max(phi_reach, std::min(3 * set->phi_reach / 2, mesh_.nodes_per_revolution / 2));
    theta_reach = std::max(theta_reach, std::min(3 * set->theta_reach / 2, theta_nodes_per_revolution(mesh_) / 2));
  }
  constexpr std::array kAll{TableKind::displacement, TableKind::dissipation, TableKind::forward};
  const std::span<const TableKind> all(kAll.begin(), has_forward_tables(formulation) ? 3 : 2);
  const bool together = has_losses_ && std::max(phi_reach, theta_reach) <= kShortReach;
  add(formulation, together ? all : std::span(&kind, 1), phi_reach, theta_reach, execution);
  return find(formulation, kind)->tables;
}

void TableStore::add(const Formulation& formulation, std::span<const TableKind> kinds, int phi_reach, int theta_reach,
                     const Execution& execution) const {
  std::vector<TableRequest> all;
  for (const TableKind kind : kinds) {
    const auto wanted = requests(formulation, kind);
    all.insert(all.end(), wanted.begin(), wanted.end());
  }
  std::vector<Table> tables = sum_->tables(all, phi_reach, theta_reach, execution.threads, execution.watch);
  auto next = std::make_move_iterator(tables.begin());
  for (const TableKind kind : kinds) {
    const auto end = next + static_cast<std::ptrdiff_t>(requests(formulation, kind).size());
    std::erase_if(sets_, [&](const TableSet& set) { return set.formulation == formulation && set.kind == kind; });
    sets_.push_back({.formulation = formulation,
                     .kind = kind,
                     .phi_reach = phi_reach,
                     .theta_reach = theta_reach,
                     .tables = std::make_shared<const std::vector<Table>>(next, end)});
    next = end;
  }
}

const TableStore::TableSet* TableStore::find(const Formulation& formulation, TableKind kind) const {
  const auto set =
      std::ranges::find_if(sets_, [&](const TableSet& s) { return s.formulation == formulation && s.kind == kind; });
  return set == sets_.end() ? nullptr : &*set;
}

}  // namespace viscoroll::detail

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
  const auto [phi_nodes, theta_nodes] = nodes.shape();
  std::vector<Eigen::Index> loaded;
  for (Eigen::Index node = 0; node < force.rows(); ++node) {
    if (force(node, kDown) != 0.0) loaded.push_back(node);
  }
  const auto product = [&](TableKind kind) {
    return TableProduct(nodes.shape(), tables(formulation, kind, phi_nodes - 1, theta_nodes - 1, execution), {});
  };
  const TableProduct normal = product(TableKind::displacement);
  const TableProduct mixed = product(TableKind::forward);
  const Eigen::VectorXd load = force.col(kDown)(loaded);
  const double sign = entry_of(1, 0).sign;
  Eigen::ArrayXd forward(static_cast<Eigen::Index>(displaced.size()));
  for (Eigen::Index i = 0; i < forward.size(); ++i) {
    const std::vector<Eigen::Index> node{displaced[static_cast<std::size_t>(i)]};
    const double radial = (normal.between(0, node, loaded) * load).value();
    const double along = sign * (mixed.between(0, node, loaded) * load).value();
    // A radial displacement moves the surface forward, since x is -phi; see `load_directions`.
    forward[i] = nodes.x()[node.front()] / nodes.grid().radius * radial - along;
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

#include "rolling/table_store.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "base/parallel.hpp"

namespace viscoroll::detail {
namespace {

/// Up to this reach, computing the compliances of the orders costs more than summing them, so that tables of all kinds
/// are made together.
constexpr int kShortReach = 128;

std::vector<TableRequest> requests(const Formulation& formulation, TableKind kind) {
  return kind == TableKind::displacement ? displacement_tables(formulation) : dissipation_tables(formulation);
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

TableOperator::Tables TableStore::tables(const Formulation& formulation, TableKind kind, int phi_reach, int theta_reach,
                                         const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  if (const TableSet* set = find(formulation, kind)) {
    if (set->phi_reach >= phi_reach && set->theta_reach >= theta_reach) return set->tables;
    // Extend the reach by half, so that increasing loads need few new sets.
    phi_reach = std::max(phi_reach, std::min(3 * set->phi_reach / 2, mesh_.nodes_per_revolution / 2));
    theta_reach = std::max(theta_reach, std::min(3 * set->theta_reach / 2, theta_nodes_per_revolution(mesh_) / 2));
  }
  constexpr std::array kAll{TableKind::displacement, TableKind::dissipation};
  const bool together = std::max(phi_reach, theta_reach) <= kShortReach;
  add(formulation, together ? std::span<const TableKind>(kAll) : std::span(&kind, 1), phi_reach, theta_reach,
      execution);
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

#include "contact/candidate_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

NodeRange coarse_range(const NodeRange& range) {
  // A table of the doubled mesh reaches one spacing less far than half of the fine one.
  return {-((-range.first - 1) / 2), (range.last - 1) / 2};
}

/// Sum of a table over a patch of two spacings, seen from node (j, l): a quarter, a half and a quarter each way.
double widened(const Table& table, int j, int l) {
  constexpr std::array<double, 3> kShare{0.25, 0.5, 0.25};
  double sum = 0.0;
  for (int dj = -1; dj <= 1; ++dj) {
    for (int dl = -1; dl <= 1; ++dl) {
      sum +=
          kShare[static_cast<std::size_t>(dj + 1)] * kShare[static_cast<std::size_t>(dl + 1)] * table(j + dj, l + dl);
    }
  }
  return sum;
}

Table coarsened(const Table& fine) {
  Table coarse((fine.phi_reach() - 1) / 2, (fine.theta_reach() - 1) / 2, fine.mirror() < 0.0);
  for (int j = -coarse.phi_reach(); j <= coarse.phi_reach(); ++j) {
    const auto row = coarse.row(j);
    for (int l = 0; l <= coarse.theta_reach(); ++l) row[static_cast<std::size_t>(l)] = widened(fine, 2 * j, 2 * l);
  }
  return coarse;
}

/// Nodes, along both directions, between which the contact lies.
std::pair<NodeRange, NodeRange> extent(const LocatedContact& located) {
  const SurfaceWindow& window = located.window;
  NodeRange phi{window.phi_range().last, window.phi_range().first};
  NodeRange theta{window.theta_range().last, window.theta_range().first};
  for (const Index node : located.contact.contact) {
    const int i = window.phi_range().first + static_cast<int>(node / window.shape().theta_nodes);
    const int k = window.theta_range().first + static_cast<int>(node % window.shape().theta_nodes);
    phi = {std::min(phi.first, i), std::max(phi.last, i)};
    theta = {std::min(theta.first, k), std::max(theta.last, k)};
  }
  return {phi, theta};
}

/// A margin for nodes to join, of which the upstream neighbors of a contact with friction are some.
NodeRange padded(const NodeRange& range, int scale, const NodeRange& limits) {
  const int margin = 3 * scale + scale * range.count() / 50;
  return {std::max(scale * range.first - margin, limits.first), std::min(scale * range.last + margin, limits.last)};
}

/// Coarse nodes around a place of the fine mesh, along one direction: itself, or its two neighbors.
struct Neighbors {
  explicit Neighbors(int place) : low(static_cast<int>(std::floor(0.5 * place))), count(place % 2 == 0 ? 1 : 2) {}
  int low;
  int count;
};

/// Call function(node, coarse nodes) for every node of the fine window with the numbers of its nearest coarse nodes, of
/// which those outside the coarse window are left out, and how many there are with them.
template <class Function>
void for_nearest(const SurfaceWindow& coarse, const SurfaceWindow& fine, const Function& function) {
  const NodeRange phi = coarse.phi_range();
  const NodeRange theta = coarse.theta_range();
  std::vector<Index> nearest;
  Index node = 0;
  for (int i = fine.phi_range().first; i <= fine.phi_range().last; ++i) {
    const Neighbors rows(i);
    for (int k = fine.theta_range().first; k <= fine.theta_range().last; ++k, ++node) {
      const Neighbors columns(k);
      nearest.clear();
      for (int row = rows.low; row < rows.low + rows.count; ++row) {
        for (int column = columns.low; column < columns.low + columns.count; ++column) {
          if (row < phi.first || row > phi.last || column < theta.first || column > theta.last) continue;
          nearest.push_back(static_cast<Index>(row - phi.first) * theta.count() + column - theta.first);
        }
      }
      function(node, nearest, rows.count * columns.count);
    }
  }
}

}  // namespace

ArrayXd drop(const CandidateSurface& surface, const SurfaceWindow& window) {
  return surface.swelling * window.height();
}

CandidateSurface coarsened(const CandidateSurface& surface) {
  Formulation flat = surface.formulation;
  flat.patch_load = PatchLoad::flat;
  const auto requests = displacement_tables(surface.formulation);
  std::vector<Table> tables;
  for (const TableRequest& request : displacement_tables(flat)) {
    const auto place = std::find(requests.begin(), requests.end(), request) - requests.begin();
    tables.push_back(coarsened((*surface.tables)[static_cast<std::size_t>(place)]));
  }
  SurfaceGrid grid = surface.window.grid();
  grid.phi_spacing *= 2.0;
  grid.theta_spacing *= 2.0;
  return {.formulation = flat,
          .window = {grid, coarse_range(surface.window.phi_range()), coarse_range(surface.window.theta_range())},
          .tables = std::make_shared<const std::vector<Table>>(std::move(tables)),
          .swelling = surface.swelling};
}

SurfaceWindow box_around(const LocatedContact& located, int scale, const SurfaceWindow& limits) {
  const auto [phi, theta] = extent(located);
  const int half = std::max(-theta.first, theta.last);
  return {limits.grid(), padded(phi, scale, limits.phi_range()), padded({-half, half}, scale, limits.theta_range())};
}

VectorField prolonged_force(const LocatedContact& coarse, const SurfaceWindow& fine) {
  VectorField force = VectorField::Zero(fine.shape().size(), 3);
  for_nearest(coarse.window, fine, [&](Index node, const std::vector<Index>& nearest, int count) {
    for (const Index coarse_node : nearest) force.row(node) += coarse.contact.force.row(coarse_node);
    force.row(node) /= 4.0 * count;  // a quarter of the patch
  });
  return force;
}

std::vector<Index> prolonged_contact(const LocatedContact& coarse, const SurfaceWindow& fine) {
  std::vector<Index> contact;
  for_nearest(coarse.window, fine, [&](Index node, const std::vector<Index>& nearest, int count) {
    const auto touching = std::count_if(nearest.begin(), nearest.end(), [&](Index coarse_node) {
      return coarse.contact.force(coarse_node, kDown) < 0.0;
    });
    if (touching > 0 && 2 * touching >= count) contact.push_back(node);
  });
  return contact;
}

bool touches_edge(const ContactSolution& contact, const WindowShape& shape) {
  return std::any_of(contact.contact.begin(), contact.contact.end(), [&](Index node) {
    const Index i = node / shape.theta_nodes;
    const Index k = node % shape.theta_nodes;
    return i <= 1 || i == shape.phi_nodes - 1 || k == 0 || k == shape.theta_nodes - 1;
  });
}

ContactSolution extended(LocatedContact located, const CandidateSurface& surface, const Execution& execution) {
  ContactSolution contact = std::move(located.contact);
  if (located.window.covers_same(surface.window)) {
    contact.displacement = located.coating.displacement(contact.force);
  } else {
    const auto moved = [&](const auto& values) {
      using Values = std::decay_t<decltype(values)>;
      Values result = Values::Zero(surface.window.shape().size(), values.cols());
      for (Index node = 0; node < values.rows(); ++node) {
        result.row(surface.window.number_of(located.window, node)) = values.row(node);
      }
      return result;
    };
    contact.force = moved(contact.force);
    if (contact.slip.rows() > 0) contact.slip = moved(contact.slip);
    for (auto* nodes : {&contact.contact, &contact.stick}) {
      for (Index& node : *nodes) node = surface.window.number_of(located.window, node);
    }
    contact.displacement =
        CoatingCompliance(surface.formulation, surface.window, surface.tables, execution).displacement(contact.force);
  }
  contact.gap = drop(surface, surface.window) - contact.displacement.col(kDown) - contact.penetration;
  return contact;
}

}  // namespace viscoroll::detail

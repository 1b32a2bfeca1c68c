#include "contact/multilevel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr Index kSmallWindow = 4096;       // nodes
constexpr double kCoarseTolerance = 1e-4;  // of a contact that is to be interpolated

NodeRange coarse_range(const NodeRange& range) {
  // A table of the doubled mesh reaches one spacing less far than half of the fine one.
  return {-((-range.first - 1) / 2), (range.last - 1) / 2};
}

/// Sum of a table over a patch of two spacings, a quarter, a half and a quarter in each direction, seen from node (j, l).
double widened(const Table& table, int j, int l) {
  constexpr std::array<double, 3> kShare{0.25, 0.5, 0.25};
  double sum = 0.0;
  for (int dj = -1; dj <= 1; ++dj) {
    for (int dl = -1; dl <= 1; ++dl) {
      sum += kShare[static_cast<std::size_t>(dj + 1)] * kShare[static_cast<std::size_t>(dl + 1)] * table(j + dj, l + dl);
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

ArrayXd drop(const CandidateSurface& surface, const SurfaceWindow& window) {
  return surface.swelling * window.height();
}

/// Nodes within a distance of the lowest point, itself included, and no forces.
NormalContactGuess guess_within(const SurfaceWindow& window, double distance) {
  NormalContactGuess guess{.contact = {}, .pressing = ArrayXd::Zero(window.shape().size()), .penetration = 0.0};
  for (Index node = 0; node < window.shape().size(); ++node) {
    const bool lowest = window.height()[node] == 0.0;
    if (lowest || std::hypot(window.x()[node], window.z()[node]) <= distance) guess.contact.push_back(node);
  }
  return guess;
}

/// Coarse nodes around a place of the fine mesh, along one direction: itself, or its two neighbors.
struct Neighbors {
  explicit Neighbors(int place) : low(static_cast<int>(std::floor(0.5 * place))), count(place % 2 == 0 ? 1 : 2) {}
  int low;
  int count;
};

/// Coarse forces, interpolated, on the nodes of a finer window; in contact are those most of whose neighbors are.
NormalContactGuess prolonged(const LocatedContact& coarse, const SurfaceWindow& fine) {
  NormalContactGuess guess{
      .contact = {}, .pressing = ArrayXd::Zero(fine.shape().size()), .penetration = coarse.contact.penetration};
  const ArrayXd pressing = pressing_force(coarse.contact);
  const NodeRange phi = coarse.window.phi_range();
  const NodeRange theta = coarse.window.theta_range();
  Index node = 0;
  for (int i = fine.phi_range().first; i <= fine.phi_range().last; ++i) {
    const Neighbors rows(i);
    for (int k = fine.theta_range().first; k <= fine.theta_range().last; ++k, ++node) {
      const Neighbors columns(k);
      int touching = 0;
      double sum = 0.0;
      for (int row = rows.low; row < rows.low + rows.count; ++row) {
        for (int column = columns.low; column < columns.low + columns.count; ++column) {
          if (row < phi.first || row > phi.last || column < theta.first || column > theta.last) continue;
          const double force = pressing[(row - phi.first) * theta.count() + column - theta.first];
          sum += force;
          touching += force > 0.0 ? 1 : 0;
        }
      }
      const int neighbors = rows.count * columns.count;
      if (2 * touching < neighbors || touching == 0) continue;
      guess.contact.push_back(node);
      guess.pressing[node] = sum / (4.0 * neighbors);  // a quarter of the patch
    }
  }
  return guess;
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

/// Box around a contact that was solved with `scale` times the spacing, symmetric in theta.
SurfaceWindow box_around(const LocatedContact& located, int scale, const SurfaceWindow& limits) {
  auto [phi, theta] = extent(located);
  const int half = std::max(-theta.first, theta.last);
  return {limits.grid(), padded(phi, scale, limits.phi_range()), padded({-half, half}, scale, limits.theta_range())};
}

bool is_same(const SurfaceWindow& a, const SurfaceWindow& b) {
  return a.phi_range() == b.phi_range() && a.theta_range() == b.theta_range();
}

/// The state of a contact as a guess on a window that encloses its own.
NormalContactGuess guess_from(const LocatedContact& located, const SurfaceWindow& window) {
  NormalContactGuess guess{.contact = {},
                           .pressing = ArrayXd::Zero(window.shape().size()),
                           .penetration = located.contact.penetration};
  const ArrayXd pressing = pressing_force(located.contact);
  for (const Index node : located.contact.contact) {
    guess.contact.push_back(window.number_of(located.window, node));
    guess.pressing[guess.contact.back()] = pressing[node];
  }
  return guess;
}

LocatedContact solve_on(const SurfaceWindow& window, const CandidateSurface& surface, double load,
                        const NormalContactGuess& guess, const ContactOptions& options, const Execution& execution) {
  CoatingCompliance coating(surface.formulation, window, surface.tables, execution);
  const NormalContactProblem problem{.coating = coating, .drop = drop(surface, window), .load = load};
  ContactSolution contact = solve_normal_contact(problem, guess, options);
  return {.window = window, .coating = std::move(coating), .contact = std::move(contact)};
}

}  // namespace

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

LocatedContact solve_multilevel(const CandidateSurface& surface, double load, double estimate,
                                const ContactOptions& options, const Execution& execution) {
  if (surface.window.shape().size() <= kSmallWindow) {
    return solve_on(surface.window, surface, load, guess_within(surface.window, 0.8 * estimate), options, execution);
  }
  ContactOptions rough = options;
  rough.tolerance = kCoarseTolerance;
  const LocatedContact coarse = solve_multilevel(coarsened(surface), load, estimate, rough, execution);
  SurfaceWindow box = box_around(coarse, 2, surface.window);
  NormalContactGuess guess = prolonged(coarse, box);
  for (;;) {
    LocatedContact located = solve_on(box, surface, load, guess, options, execution);
    if (!touches_edge(located.contact, box.shape()) || is_same(box, surface.window)) return located;
    box = box_around(located, 1, surface.window);
    guess = guess_from(located, box);
  }
}

LocatedContact solve_on_window(const LocatedContact& start, const CandidateSurface& surface, double load,
                               const ContactOptions& options) {
  return solve_on(surface.window, surface, load, guess_from(start, surface.window), options, start.coating.execution());
}

bool touches_edge(const ContactSolution& contact, const WindowShape& shape) {
  return std::any_of(contact.contact.begin(), contact.contact.end(), [&](Index node) {
    const Index i = node / shape.theta_nodes;
    const Index k = node % shape.theta_nodes;
    return i <= 1 || i == shape.phi_nodes - 1 || k == 0 || k == shape.theta_nodes - 1;
  });
}

LocatedContact extended(LocatedContact located, const CandidateSurface& surface, const Execution& execution) {
  if (!is_same(located.window, surface.window)) {
    ContactSolution& contact = located.contact;
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
    located.window = surface.window;
    located.coating = CoatingCompliance(surface.formulation, surface.window, surface.tables, execution);
  }
  located.contact.displacement = located.coating.displacement(located.contact.force);
  located.contact.gap = drop(surface, surface.window) - located.contact.displacement.col(kDown) - located.contact.penetration;
  return located;
}

}  // namespace viscoroll::detail

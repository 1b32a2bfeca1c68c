#include "transient/touch.hpp"

#include <utility>

namespace viscoroll::detail {

using Eigen::Index;

HalfField against(Axis axis, const std::vector<Axes>& axes, const std::vector<HalfField>& fields) {
  HalfField sum = along(axes.front()[static_cast<std::size_t>(axis)], fields.front());
  for (std::size_t b = 1; b < fields.size(); ++b) sum += along(axes[b][static_cast<std::size_t>(axis)], fields[b]);
  return sum;
}

HalfField known_gap(const CreepingPair& pair, const Touch& touch) {
  if (pair.coating().components() > 1) return against(kDown, touch.place.axes, touch.known);
  HalfField known = touch.known.front();
  for (std::size_t b = 1; b < touch.known.size(); ++b) known += touch.known[b];
  return known;
}

HalfField by_components(const CreepingPair& pair, const Touch& touch, std::size_t body) {
  const VectorField& force = touch.contact.force;
  return pair.coating().components() == 1 ? as_field(-force.col(kDown), pair.half_nodes())
                                          : on_plane(touch.place.axes[body], force);
}

void find_displacements(const CreepingPair& pair, Touch& touch) {
  const Index half_nodes = pair.half_nodes();
  const auto& nodes = touch.contact.nodes;
  for (std::size_t b = 0; b < pair.bodies.size(); ++b) {
    const CreepingTables& body = pair.bodies[b].tables;
    touch.moved.emplace_back();
    const HalfField pressing = by_components(pair, touch, b);
    for (const MirroredTables& tables : body.all()) {
      touch.moved.back().push_back(nodes.empty()
                                       ? HalfField::Zero(pressing.rows(), touch.place.count + 2 * tables.reach())
                                       : tables.displacement_in_reach(pressing, nodes.front() / half_nodes,
                                                                      nodes.back() / half_nodes, touch.checkpoint));
    }
  }
}

std::vector<HalfField> deformed(const CreepingPair& pair, const Touch& touch) {
  std::vector<HalfField> deformed = touch.known;
  for (std::size_t b = 0; b < deformed.size(); ++b) {
    const std::vector<double>& parts = touch.yielding.of_bodies[b].parts;
    const Index reach = pair.bodies[b].tables.reach();
    for (std::size_t t = 0; t < parts.size(); ++t) {
      const double share = parts[t] / touch.yielding.sum;
      deformed[b] += share * touch.moved[b][t].middleCols(reach, touch.place.count);
    }
  }
  return deformed;
}

RowMemory::Load load_of(const CreepingPair& pair, const Touch& touch, std::size_t body) {
  const ContactPlace& place = touch.place;
  const CreepingTables& tables = pair.bodies[body].tables;
  const Index reach = tables.reach();
  RowMemory::Load load{.first = place.first - reach,
                       .force = HalfField::Zero(tables.height(), place.count + 2 * reach),
                       .displacements = {}};
  for (const HalfField& moved : touch.moved[body]) load.displacements.emplace_back(moved / touch.yielding.sum);
  load.force.middleCols(reach, place.count) = by_components(pair, touch, body) / touch.yielding.sum;
  return load;
}

}  // namespace viscoroll::detail

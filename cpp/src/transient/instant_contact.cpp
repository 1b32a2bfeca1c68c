#include "transient/instant_contact.hpp"

#include <utility>

namespace viscoroll::detail {

using Eigen::Index;

HalfField against(Axis axis, const std::vector<Axes>& axes, const std::vector<HalfField>& fields) {
  HalfField sum = along(axes.front()[static_cast<std::size_t>(axis)], fields.front());
  for (std::size_t b = 1; b < fields.size(); ++b) sum += along(axes[b][static_cast<std::size_t>(axis)], fields[b]);
  return sum;
}

HalfField known_gap(const ViscoelasticPair& pair, const InstantContact& instant) {
  if (pair.coating().components() > 1) return against(kDown, instant.place.axes, instant.known);
  HalfField known = instant.known.front();
  for (std::size_t b = 1; b < instant.known.size(); ++b) known += instant.known[b];
  return known;
}

HalfField by_components(const ViscoelasticPair& pair, const InstantContact& instant, std::size_t body) {
  const VectorField& force = instant.contact.force;
  return pair.coating().components() == 1 ? as_field(-force.col(kDown), pair.half_nodes())
                                          : on_plane(instant.place.axes[body], force);
}

void find_displacements(const ViscoelasticPair& pair, InstantContact& instant) {
  const Index half_nodes = pair.half_nodes();
  const auto& nodes = instant.contact.nodes;
  for (std::size_t b = 0; b < pair.bodies.size(); ++b) {
    const CreepTables& body = pair.bodies[b].tables;
    instant.moved.emplace_back();
    const HalfField pressing = by_components(pair, instant, b);
    for (const MirroredTables& tables : body.all()) {
      instant.moved.back().push_back(nodes.empty()
                                         ? HalfField::Zero(pressing.rows(), instant.place.count + 2 * tables.reach())
                                         : tables.displacement_in_reach(pressing, nodes.front() / half_nodes,
                                                                        nodes.back() / half_nodes, instant.checkpoint));
    }
  }
}

std::vector<HalfField> deformed(const ViscoelasticPair& pair, const InstantContact& instant) {
  std::vector<HalfField> deformed = instant.known;
  for (std::size_t b = 0; b < deformed.size(); ++b) {
    const std::vector<double>& parts = instant.instantaneous.of_bodies[b].parts;
    const Index reach = pair.bodies[b].tables.reach();
    for (std::size_t t = 0; t < parts.size(); ++t) {
      const double share = parts[t] / instant.instantaneous.sum;
      deformed[b] += share * instant.moved[b][t].middleCols(reach, instant.place.count);
    }
  }
  return deformed;
}

RowMemory::Load load_of(const ViscoelasticPair& pair, const InstantContact& instant, std::size_t body) {
  const ContactPlace& place = instant.place;
  const CreepTables& tables = pair.bodies[body].tables;
  const Index reach = tables.reach();
  RowMemory::Load load{.first = place.first - reach,
                       .force = HalfField::Zero(tables.height(), place.count + 2 * reach),
                       .displacements = {}};
  for (const HalfField& moved : instant.moved[body]) load.displacements.emplace_back(moved / instant.instantaneous.sum);
  load.force.middleCols(reach, place.count) = by_components(pair, instant, body) / instant.instantaneous.sum;
  return load;
}

}  // namespace viscoroll::detail

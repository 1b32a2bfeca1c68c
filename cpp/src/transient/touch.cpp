#include "transient/touch.hpp"

#include <utility>

namespace viscoroll::detail {

using Eigen::Index;

HalfField known_gap(const CreepingPair& pair, const Touch& touch) {
  HalfField known = touch.known.front();
  for (std::size_t b = 1; b < touch.known.size(); ++b) known += touch.known[b];
  return pair.coating().components() == 1 ? known : along(touch.place.axes[kDown], known);
}

HalfField by_components(const CreepingPair& pair, const VectorField& force, const ContactPlace& place) {
  return pair.coating().components() == 1 ? as_field(-force.col(kDown), pair.half_nodes())
                                          : on_plane(place.axes, force);
}

void find_displacements(const CreepingPair& pair, Touch& touch) {
  if (pair.has_friction() && !touch.contact.nodes.empty() && pair.coating().count() == 1) {
    touch.moved.push_back({std::move(touch.contact.displacement)});
    return;
  }
  const Index half_nodes = pair.half_nodes();
  const HalfField pressing = by_components(pair, touch.contact.force, touch.place);
  const auto& nodes = touch.contact.nodes;
  for (const CreepingBody& body : pair.bodies) {
    touch.moved.emplace_back();
    for (const MirroredTables& tables : body.tables.all()) {
      touch.moved.back().push_back(
          nodes.empty()
              ? HalfField::Zero(pressing.rows(), touch.place.count + 2 * tables.reach())
              : tables.displacement_in_reach(pressing, nodes.front() / half_nodes, nodes.back() / half_nodes));
    }
  }
}

HalfField deformed(const CreepingPair& pair, const Touch& touch, std::size_t body) {
  HalfField deformed = touch.known[body];
  const std::vector<double>& parts = touch.yielding.of_bodies[body].parts;
  const Index reach = pair.bodies[body].tables.reach();
  for (std::size_t t = 0; t < parts.size(); ++t) {
    const double share = parts[t] / touch.yielding.sum;
    deformed += share * touch.moved[body][t].middleCols(reach, touch.place.count);
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
  load.force.middleCols(reach, place.count) = by_components(pair, touch.contact.force, place) / touch.yielding.sum;
  return load;
}

}  // namespace viscoroll::detail

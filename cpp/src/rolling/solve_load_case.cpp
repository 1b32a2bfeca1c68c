#include "rolling/solve_load_case.hpp"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/validate.hpp"
#include "contact/frozen_contact.hpp"
#include "contact/multilevel.hpp"
#include "rolling/finite_strain.hpp"
#include "rolling/input_checks.hpp"
#include "rolling/result.hpp"

namespace viscoroll::detail {
namespace {

/// Window around the lowest node with as many rows and columns as the state.
Window window_of(const FrozenContact& state, const Window& widest) {
  const auto range = [](const std::string& name, int nodes, const NodeRange& most) {
    const int to_edge = nodes / 2;
    if (nodes % 2 == 1 && nodes > 0 && to_edge <= most.last) return NodeRange{-to_edge, to_edge};
    reject("state." + name, "odd and in [1, " + std::to_string(2 * most.last + 1) + "]", std::to_string(nodes),
           Range{.minimum = 1.0, .maximum = 2.0 * most.last + 1.0});
  };
  return {range("phi_nodes", state.phi_nodes, widest.phi), range("theta_nodes", state.theta_nodes, widest.theta)};
}

std::vector<Eigen::Index> marked(const std::vector<unsigned char>& mask) {
  std::vector<Eigen::Index> nodes;
  for (std::size_t node = 0; node < mask.size(); ++node) {
    if (mask[node] != 0) nodes.push_back(static_cast<Eigen::Index>(node));
  }
  return nodes;
}

ContactSolution start_of(const FrozenContact& state, const SurfaceWindow& nodes, double centrifugal) {
  const Eigen::Index size = nodes.shape().size();
  const auto count = static_cast<std::size_t>(size);
  if (state.contact.size() != count || state.stick.size() != count || state.pressure.size() != count ||
      state.shear_traction.size() != 2 * count) {
    reject("state", "fields of " + std::to_string(count) + " nodes", "fields of another size");
  }
  ContactSolution start;
  start.contact = marked(state.contact);
  if (start.contact.empty()) reject("state.contact", "a mask with at least one node", "none");
  start.stick = marked(state.stick);
  const Eigen::ArrayXd area = nodes.patch_area(start.contact);
  const Eigen::Map<const Eigen::ArrayXd> pressure(state.pressure.data(), size);
  const Eigen::Map<const Eigen::ArrayX2d> shear(state.shear_traction.data(), size, 2);
  start.force = VectorField::Zero(size, 3);
  start.force.col(kDown)(start.contact) = -pressure(start.contact) * area;
  start.force.col(kForward)(start.contact) = shear.col(0)(start.contact) * area;
  start.force.col(kSideways)(start.contact) = shear.col(1)(start.contact) * area;
  start.penetration = state.penetration + centrifugal;
  start.creepage = state.creepage;
  return start;
}

}  // namespace

Result solve_load_case(const MeshModel& model, const RollingCase& given,
                       const std::optional<ContactReach>& coarse_contact) {
  require_supported(model, given);
  const ContactSetup setup = assemble(model, given);
  const WindowContact solved = find_contact_in_window(setup, coarse_contact);
  Result result = make_result(setup, solved);
  result.overspeed = overspeed(setup, solved);
  return result;
}

Result solve_frozen_case(const MeshModel& model, const RollingCase& given, const FrozenContact& state) {
  require_supported(model, given);
  const ContactSetup setup = assemble(model, given);
  const SurfaceWindow nodes(setup.nodes.grid, window_of(state, setup.nodes.widest));
  const ContactProblem problem = setup.problem(nodes);
  ContactSolution contact = solve_frozen_contact(problem, start_of(state, nodes, given.pair.centrifugal), setup.limits);
  find_displacements(*problem.surface, contact);
  const Losses losses = problem.surface->dissipation(contact.force);
  return make_result(setup, {.nodes = nodes, .problem = problem, .contact = std::move(contact), .losses = losses});
}

Result solve_near(const MeshModel& model, const RollingCase& given, const FrozenContact& state) {
  require_supported(model, given);
  const ContactSetup setup = assemble(model, given);
  const SurfaceWindow nodes(setup.nodes.grid, window_of(state, setup.nodes.widest));
  const ContactProblem problem = setup.problem(nodes);
  const ContactSolution start = start_of(state, nodes, given.pair.centrifugal);
  const LocatedContact located = solve_on_window(problem, start, setup.limits);
  if (touches_edge(located, nodes.window())) return solve_load_case(model, given);
  ContactSolution contact = extended(located, problem);
  require_contact(setup, given.load_case.friction, contact.penetration);
  return make_result(setup, {.nodes = nodes, .problem = problem, .contact = std::move(contact), .losses = {}});
}

}  // namespace viscoroll::detail

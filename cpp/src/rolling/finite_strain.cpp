#include "rolling/finite_strain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rolling/mesh_model.hpp"
#include "rolling/result.hpp"
#include "rolling/solve_load_case.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Sufficient number of nodes along the contact on the mesh of the correction. The correction is a ratio of two torques
/// on the same mesh, whose noise is that of nodes that join the contact one by one: 0.1 % with 75 nodes. In line
/// contact there are no rows side by side over which the noise is averaged: the ratio of a roller changed by 1.5 % from
/// 75 to 600 nodes.
double nodes_along(const RollingPair& pair) { return pair.body->form().is_line() ? 600.0 : 75.0; }

/// Error of the compliance due to the inertia that the correction, a ratio of torques, tolerates.
constexpr double kInertiaError = 1e-4;

/// Whether the torque is round-off.
bool is_lossless(const Result& result) {
  constexpr double kRoundOff = 1e-9;
  return std::abs(result.resisting_torque) < kRoundOff * result.load * result.contact_length;
}

/// Mesh with as many nodes along the contact of a result as the correction needs.
Mesh coarsened(const Result& result, const RollingPair& pair) {
  const double spacing = pair.body->radius() * phi_spacing(result.mesh);
  const double coarsening = std::max(1.0, result.contact_length / spacing / nodes_along(pair));
  Mesh mesh = result.mesh;
  mesh.nodes_per_revolution = static_cast<int>(mesh.nodes_per_revolution / coarsening);
  if (mesh.theta_nodes_per_revolution) {
    mesh.theta_nodes_per_revolution = static_cast<int>(*mesh.theta_nodes_per_revolution / coarsening);
  }
  return mesh;
}

/// Whether the correction applies: it was compared with finite strain without friction and on rigid counterbodies.
bool is_known(const RollingCase& given) {
  return given.options.finite_strain && given.load_case.friction == 0.0 && !given.load_case.adhesion &&
         given.options.compliance == Compliance::radial && !given.pair.body->is_rigid() && given.pair.on->is_rigid();
}

/// First and last node in contact of a row along the path, and its load.
struct Row {
  Index first = -1;
  Index last = -1;
  double load = 0.0;
};

std::vector<Row> rows_of(const ContactSolution& contact, Index columns) {
  std::vector<Row> rows(static_cast<std::size_t>(columns));
  for (const Index node : contact.contact) {
    Row& row = rows[static_cast<std::size_t>(node % columns)];
    if (row.first < 0) row.first = node;
    row.last = node;
    row.load -= contact.force(node, kDown);
  }
  return rows;
}

}  // namespace

std::optional<double> overspeed(const ContactSetup& setup, const WindowContact& solved) {
  if (!is_known(setup)) return std::nullopt;
  const auto [phi_nodes, columns] = solved.nodes.shape();
  const std::vector<Row> rows = rows_of(solved.contact, columns);
  Index longest = 0;
  for (const Row& row : rows) longest = std::max(longest, (row.last - row.first) / columns + 1);
  if (static_cast<double>(longest) > 2.0 * nodes_along(setup.pair)) return std::nullopt;

  // The sides of the outermost patches lie halfway between these pairs of nodes.
  std::vector<Index> ends;
  std::vector<double> loads;
  for (const Row& row : rows) {
    if (row.first < columns || row.last + columns >= solved.nodes.shape().size()) continue;
    ends.insert(ends.end(), {row.first - columns, row.first, row.last, row.last + columns});
    loads.push_back(row.load);
  }
  if (ends.empty()) return std::nullopt;
  const ArrayXd forward = setup.model.own->forward_displacement(solved.nodes, setup.formulation, ends,
                                                                solved.contact.force, setup.execution);
  const ArrayXd x = solved.nodes.x()(ends);
  const auto differences = [](const ArrayXd& values) -> ArrayXd {
    const auto at = values.reshaped(4, values.size() / 4);
    return at.row(0) + at.row(1) - at.row(2) - at.row(3);
  };
  const Eigen::Map<const ArrayXd> load(loads.data(), static_cast<Index>(loads.size()));
  return (load * differences(forward) / differences(x)).sum() / load.sum();
}

std::shared_ptr<const MeshModel> FasterModel::on(const Mesh& mesh, const RollingCase& given) {
  const auto lock = lock_watched(mutex_, given.execution.watch, "waiting for another thread's tables");
  if (!model_ || model_->mesh != mesh) {
    const PairAtSpeed faster = at_speed(given.pair, kRatio * given.pair.angular_speed);
    model_ = std::make_shared<const MeshModel>(make_model(faster, mesh, given.options.curvature, given.execution,
                                                          {.inertia_tolerance = kInertiaError, .has_losses = false}));
  }
  return model_;
}

namespace {

void set_finite_strain(Result& result, std::optional<Result> rough, const RollingCase& given, FasterModel& faster) {
  LoadCase same_load = given.load_case;
  same_load.load = result.load;
  same_load.penetration.reset();
  Options options = given.options;
  const auto case_on = [&](const MeshModel& model, bool with_overspeed) {
    same_load.angular_speed = model.pair.angular_speed;
    options.finite_strain = with_overspeed;
    return with_same_estimate(given, model.pair, same_load, options);
  };
  try {
    if (!rough && result.overspeed) rough = result;
    if (!rough) {
      const Mesh mesh = coarsened(result, given.pair);
      const MeshModel model =
          make_model(given.pair, mesh, given.options.curvature, given.execution, {.inertia_tolerance = kInertiaError});
      rough = solve_load_case(model, case_on(model, true), contact_reach(result));
    }
    if (!rough->overspeed) return;
    const double speed_ratio = 1.0 + *rough->overspeed;
    double torque_ratio = speed_ratio;
    if (!given.load_case.speed && !is_lossless(*rough)) {
      const std::shared_ptr<const MeshModel> model = faster.on(rough->mesh, given);
      const double at_faster =
          solve_near(*model, case_on(*model, false), frozen_contact(*rough)).resisting_torque / rough->resisting_torque;
      if (!(at_faster > 0.0)) return;
      torque_ratio *= std::pow(at_faster, std::log(speed_ratio) / std::log(FasterModel::kRatio));
    }
    result.overspeed = rough->overspeed;
    result.finite_strain_torque = torque_ratio * result.resisting_torque;
    result.finite_strain_angular_speed = given.pair.angular_speed / (given.load_case.speed ? speed_ratio : 1.0);
  } catch (const InvalidInput&) {
    result.finite_strain_torque.reset();  // not known: the higher speed is at or above a critical speed
  } catch (const ConvergenceError&) {
    result.finite_strain_torque.reset();  // not known: the contact at the higher speed has no solution
  }
}

}  // namespace

void add_finite_strain(Result& result, std::optional<Result> rough, const RollingCase& given, FasterModel& faster) {
  if (result.strain && is_known(given)) set_finite_strain(result, std::move(rough), given, faster);
  if (!result.finite_strain_torque) {
    result.overspeed.reset();
    result.finite_strain_torque_error.reset();
  } else {
    *result.finite_strain_torque_error += result.error_estimate;
  }
}

}  // namespace viscoroll::detail

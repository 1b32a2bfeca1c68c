#include "rolling/rolling_contact.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contact/coating_operators.hpp"
#include "contact/normal_contact.hpp"
#include "modal/spectrum.hpp"
#include "rolling/contact_estimate.hpp"
#include "validate.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/modal.hpp"

namespace viscoroll::detail {
namespace {

/// A solved contact and what it was solved on.
struct SolvedContact {
  SurfaceWindow window;
  CoatingOperators operators;
  NormalContactSolution contact;
};

bool touches_edge(const NormalContactSolution& contact, const WindowShape& shape) {
  return std::any_of(contact.contact.begin(), contact.contact.end(), [&](Eigen::Index node) {
    const Eigen::Index i = node / shape.theta_nodes;
    const Eigen::Index k = node % shape.theta_nodes;
    return i == 0 || i == shape.phi_nodes - 1 || k == 0 || k == shape.theta_nodes - 1;
  });
}

/// Nodes within a distance of the lowest point, itself included.
std::vector<Eigen::Index> nodes_within(const SurfaceWindow& window, double distance) {
  std::vector<Eigen::Index> nodes;
  const double limit = std::max(distance, 0.5 * window.spacing() * window.radius());
  for (Eigen::Index node = 0; node < window.shape().size(); ++node) {
    if (std::hypot(window.x()[node], window.z()[node]) <= limit) nodes.push_back(node);
  }
  return nodes;
}

class MeshSolver {
 public:
  MeshSolver(const HarmonicCoating& coating, const LoadCase& load_case, const Mesh& mesh, const Options& options,
             Watch& watch)
      : coating_(coating),
        load_case_(load_case),
        mesh_(mesh),
        options_(options),
        watch_(watch),
        formulation_{.compliance = options.compliance, .patch_load = options.patch_load},
        spacing_(2.0 * std::numbers::pi / mesh.nodes_per_revolution),
        radius_(coating.outer_radius()),
        centrifugal_(centrifugal_displacement(coating.sphere(), coating.angular_speed())),
        spectrum_(make_spectrum(coating, options.threads, watch)) {}

  [[nodiscard]] SolvedContact solve() const {
    if (load_case_.load > unbearable_load(coating_)) reject_load("would be pressed through any such coating");
    const double estimate = estimate_contact_radius(coating_, load_case_.load) / radius_;
    // Beyond 60 degrees the plane runs along the surface rather than against it, and no load can be borne.
    const int largest = mesh_.nodes_per_revolution / 6;
    int half = std::min(static_cast<int>(std::ceil(1.1 * estimate / spacing_)) + 2, largest);
    for (;;) {
      SolvedContact solved = solve_in_window(half, estimate * radius_);
      if (!touches_edge(solved.contact, solved.window.shape())) return solved;
      if (half == largest) reject_load("is in contact over 60 degrees to a side");
      half = std::min(half + half / 2 + 1, largest);
    }
  }

  [[nodiscard]] Result result(const SolvedContact& solved) const;

 private:
  [[nodiscard]] SolvedContact solve_in_window(int half, double estimate) const {
    const SurfaceWindow window(radius_, spacing_, half, half);
    const auto tables = std::make_shared<const std::vector<Table>>(synthesize(
        *spectrum_, radius_, mesh_, required_tables(formulation_), 2 * half, 2 * half, options_.threads, watch_));
    CoatingOperators operators = make_operators(formulation_, window, tables);
    const double scale = 1.0 + centrifugal_ / radius_;  // the free surface, swollen by the turning
    const NormalContactProblem problem{
        .compliance = operators.vertical, .drop = scale * (radius_ - window.y()), .load = load_case_.load};
    try {
      NormalContactSolution contact = solve_normal_contact(
          problem, nodes_within(window, 0.8 * std::min(estimate, half * spacing_ * radius_)),
          {.max_iterations = options_.max_iterations, .max_nodes = kMaxContactNodes, .threads = options_.threads},
          watch_);
      return {.window = window, .operators = std::move(operators), .contact = std::move(contact)};
    } catch (const std::length_error& error) {
      reject("mesh.nodes_per_revolution", "coarse enough for " + std::to_string(kMaxContactNodes) + " nodes in contact",
             std::to_string(mesh_.nodes_per_revolution) + " (" + error.what() + ")");
    }
  }

  [[noreturn]] void reject_load(const std::string& reason) const {
    reject("load", "small enough for the coating", text(load_case_.load) + " N (the sphere " + reason + ")");
  }

  void require_clear_of_core(double penetration) const {
    const double thickness = coating_thickness(coating_.sphere());
    if (!std::isfinite(penetration)) throw ConvergenceError("the contact equations have no finite solution", 0, 1.0);
    if (penetration >= thickness) {
      reject_load("is pressed " + text(penetration) + " m into a coating of " + text(thickness) + " m");
    }
  }

  const HarmonicCoating& coating_;
  LoadCase load_case_;
  Mesh mesh_;
  const Options& options_;
  Watch& watch_;
  Formulation formulation_;
  double spacing_;
  double radius_;
  double centrifugal_;
  std::unique_ptr<Spectrum> spectrum_;
};

std::vector<double> to_vector(const Eigen::ArrayXd& array) { return {array.begin(), array.end()}; }

/// Half length of the ellipse with the second moment of `weights` along `coordinate`.
double semi_axis(const Eigen::ArrayXd& coordinate, const Eigen::ArrayXd& weights) {
  const double center = (coordinate * weights).sum() / weights.sum();
  return 2.0 * std::sqrt(((coordinate - center).square() * weights).sum() / weights.sum());
}

Result MeshSolver::result(const SolvedContact& solved) const {
  const SurfaceWindow& window = solved.window;
  const NormalContactSolution& contact = solved.contact;
  const Eigen::ArrayXd& force = contact.force;
  require_clear_of_core(contact.penetration - centrifugal_);

  const Eigen::ArrayXd sine = window.theta().sin();
  const Eigen::ArrayXd flat_area = Eigen::ArrayXd::Constant(force.size(), std::pow(radius_ * spacing_, 2));
  const Eigen::ArrayXd area = flat_area * sine;
  const Eigen::ArrayXd pressure = force / (options_.patch_load == PatchLoad::flat ? flat_area : area);
  Eigen::ArrayXd touching = Eigen::ArrayXd::Zero(force.size());
  touching(contact.contact) = 1.0;

  Result r;
  r.status = contact.converged ? Status::converged : Status::max_iterations;
  r.iterations = contact.iterations;
  r.residual = contact.residual;

  r.resisting_torque = (window.x() * force).sum();
  r.rolling_resistance_coefficient = r.resisting_torque / (load_case_.load * radius_);
  r.penetration = contact.penetration - centrifugal_;
  r.center_height = radius_ - r.penetration;
  r.semi_axis_x = semi_axis(window.x(), touching * area);
  r.semi_axis_z = semi_axis(window.z(), touching * area);
  r.contact_area = (touching * area).sum();
  r.max_pressure = pressure.maxCoeff();

  // Forward displacement u_x = -D_U, and D_U = -C_UW p + d_c Q_RU with Q_RU = -x / r_o.
  const Eigen::ArrayXd forward = solved.operators.backward.apply(force) + centrifugal_ / radius_ * window.x();
  r.work_torque = ((window.x() + forward) * force).sum();
  r.dissipated_power = load_case_.angular_speed * (force * solved.operators.power.apply(force)).sum();
  const double work = r.work_torque * load_case_.angular_speed;
  // Below this share of the largest torque that the load could exert, both are round-off of a lossless coating.
  const double negligible = 1e-10 * load_case_.load * load_case_.angular_speed * r.semi_axis_x;
  r.power_balance_error =
      std::abs(work - r.dissipated_power) / std::max({std::abs(work), std::abs(r.dissipated_power), negligible});
  r.centrifugal_displacement = centrifugal_;

  r.mesh = mesh_;
  r.spacing = spacing_;
  r.phi_nodes = window.shape().phi_nodes;
  r.theta_nodes = window.shape().theta_nodes;
  r.x = to_vector(window.x());
  r.z = to_vector(window.z());
  r.pressure = to_vector(pressure);
  r.gap = to_vector(contact.gap);
  // The gap is H - y - D_W, so the upward displacement -D_W is gap + y - H.
  r.displacement = to_vector(contact.gap + window.y() - r.center_height);
  r.contact.assign(static_cast<std::size_t>(force.size()), 0);
  for (const Eigen::Index node : contact.contact) r.contact[static_cast<std::size_t>(node)] = 1;

  r.error_estimate = r.power_balance_error;
  r.refinements = {{.mesh = mesh_,
                    .contact_nodes = static_cast<int>(contact.contact.size()),
                    .resisting_torque = r.resisting_torque,
                    .penetration = r.penetration,
                    .power_balance_error = r.power_balance_error,
                    .error_estimate = r.error_estimate}};
  return r;
}

}  // namespace

Result solve_on_mesh(const HarmonicCoating& coating, const LoadCase& load_case, const Mesh& mesh,
                     const Options& options, Watch& watch) {
  const MeshSolver solver(coating, load_case, mesh, options, watch);
  return solver.result(solver.solve());
}

}  // namespace viscoroll::detail

#include "rolling/rolling_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "contact/coating_compliance.hpp"
#include "contact/frictional_contact.hpp"
#include "contact/normal_contact.hpp"
#include "rolling/contact_estimate.hpp"
#include "rolling/result.hpp"
#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// Whether the contact reaches the rim of the window, or its upstream nodes do.
bool touches_edge(const ContactSolution& contact, const WindowShape& shape) {
  return std::any_of(contact.contact.begin(), contact.contact.end(), [&](Eigen::Index node) {
    const Eigen::Index i = node / shape.theta_nodes;
    const Eigen::Index k = node % shape.theta_nodes;
    return i <= 1 || i == shape.phi_nodes - 1 || k == 0 || k == shape.theta_nodes - 1;
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

class LoadCaseSolver {
 public:
  LoadCaseSolver(const MeshModel& model, const LoadCase& load_case, const Options& options, Watch& watch)
      : model_(model),
        load_case_(load_case),
        options_(options),
        watch_(watch),
        formulation_{
            .compliance = options.compliance, .patch_load = options.patch_load, .tangential = load_case.friction > 0.0},
        limits_{.max_iterations = options.max_iterations, .max_unknowns = kMaxUnknowns, .threads = options.threads},
        spacing_(model.spacing()),
        radius_(model.radius()),
        swelling_(1.0 + model.centrifugal() / radius_) {}

  [[nodiscard]] SolvedContact solve() const {
    if (load_case_.load > unbearable_load(model_.coating())) reject_load("would be pressed through any such coating");
    const double estimate = estimate_contact_radius(model_.coating(), load_case_.load) / radius_;
    // Beyond 60 degrees the plane runs along the surface rather than against it, and no load can be borne.
    const int largest = model_.mesh().nodes_per_revolution / 6;
    int half = std::min(static_cast<int>(std::ceil(1.1 * estimate / spacing_)) + 2, largest);
    for (;;) {
      SolvedContact solved = solve_in_window(half, estimate * radius_);
      if (!touches_edge(solved.contact, solved.window.shape())) return solved;
      if (half == largest) reject_load("is in contact over 60 degrees to a side");
      half = std::min(half + half / 2 + 1, largest);
    }
  }

  [[nodiscard]] Result result(const SolvedContact& solved) const {
    if (!(solved.contact.penetration > 0.0)) {
      throw ConvergenceError("the load was found to lift the sphere", solved.contact.iterations,
                             solved.contact.residual);
    }
    require_clear_of_core(solved.contact.penetration - model_.centrifugal());
    return make_result(solved, {.load_case = load_case_,
                                .mesh = model_.mesh(),
                                .compliance = options_.compliance,
                                .patch_load = options_.patch_load,
                                .centrifugal = model_.centrifugal()});
  }

 private:
  [[nodiscard]] SolvedContact solve_in_window(int half, double estimate) const {
    const SurfaceWindow window(radius_, spacing_, half, half);
    CoatingCompliance coating(formulation_, window, model_.tables(formulation_, 2 * half, options_.threads, watch_));
    const NormalContactProblem problem{
        .coating = coating, .drop = swelling_ * (radius_ - window.y()), .load = load_case_.load};
    try {
      ContactSolution contact = solve_normal_contact(
          problem, nodes_within(window, 0.8 * std::min(estimate, half * spacing_ * radius_)), limits_, watch_);
      if (load_case_.friction > 0.0) {
        contact = add_friction(problem, window, contact);
      } else if (const auto* given = std::get_if<DriveCreepage>(&load_case_.drive)) {
        contact.speed_ratio = 1.0 + given->creepage;
      }
      return {.window = window, .coating = std::move(coating), .contact = std::move(contact)};
    } catch (const std::length_error& error) {
      reject("mesh.nodes_per_revolution", "coarse enough for " + std::to_string(kMaxUnknowns) + " unknown forces",
             std::to_string(model_.mesh().nodes_per_revolution) + " (" + error.what() + ")");
    }
  }

  [[nodiscard]] ContactSolution add_friction(const NormalContactProblem& normal, const SurfaceWindow& window,
                                             const ContactSolution& frictionless) const {
    const WindowShape shape = window.shape();
    const double step = radius_ * spacing_;
    Eigen::ArrayXd ways = Eigen::ArrayXd::Constant(shape.size(), -step);
    if (options_.slip_kinematics == SlipKinematics::exact) {
      const Eigen::Index rest = shape.size() - shape.theta_nodes;
      ways.tail(rest) = swelling_ * (window.x().tail(rest) - window.x().head(rest));
    }
    const bool vertical = options_.compliance == Compliance::vertical;
    const FrictionalContactProblem problem{
        .normal = normal,
        .shape = shape,
        .x = swelling_ * window.x(),
        .y = swelling_ * window.y(),
        .ways = std::move(ways),
        .step = step,
        .friction = load_case_.friction,
        .drive = load_case_.drive,
        .lever_arm = vertical ? LeverArm::displaced : LeverArm::undisplaced,
    };
    try {
      return solve_frictional_contact(problem, frictionless, limits_, watch_);
    } catch (const ConvergenceError&) {
      if (std::holds_alternative<DriveTorque>(load_case_.drive)) require_rolling(problem, frictionless);
      throw;
    }
  }

  /// Refuse a driving torque that is out of reach of the moments of a sphere that slides as a whole.
  void require_rolling(FrictionalContactProblem problem, const ContactSolution& frictionless) const {
    const double torque = std::get<DriveTorque>(load_case_.drive).torque;
    std::array<double, 2> limits{};
    for (const std::size_t side : {0, 1}) {
      problem.drive = DriveCreepage{.creepage = side == 0 ? 1.0 : -1.0};
      limits[side] = contact_moment(problem, solve_frictional_contact(problem, frictionless, limits_, watch_));
    }
    if (torque > limits[0] && torque < limits[1]) return;
    reject("drive.torque",
           "between " + text(limits[0]) + " N m and " + text(limits[1]) + " N m, else the sphere slides without end",
           text(torque) + " N m");
  }

  [[noreturn]] void reject_load(const std::string& reason) const {
    reject("load", "small enough for the coating", text(load_case_.load) + " N (the sphere " + reason + ")");
  }

  void require_clear_of_core(double penetration) const {
    const double thickness = coating_thickness(model_.coating().sphere());
    if (!std::isfinite(penetration)) throw ConvergenceError("the contact equations have no finite solution", 0, 1.0);
    if (penetration >= thickness) {
      reject_load("is pressed " + text(penetration) + " m into a coating of " + text(thickness) + " m");
    }
  }

  const MeshModel& model_;
  const LoadCase& load_case_;
  const Options& options_;
  Watch& watch_;
  Formulation formulation_;
  ContactOptions limits_;
  double spacing_;
  double radius_;
  double swelling_;  // of the free surface, by the turning
};

}  // namespace

Result solve_load_case(const MeshModel& model, const LoadCase& load_case, const Options& options, Watch& watch) {
  const LoadCaseSolver solver(model, load_case, options, watch);
  return solver.result(solver.solve());
}

}  // namespace viscoroll::detail

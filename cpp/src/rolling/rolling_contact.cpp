#include "rolling/rolling_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "contact/multilevel.hpp"
#include "rolling/contact_estimate.hpp"
#include "rolling/result.hpp"
#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// Overclosure outside the box of a contact, per penetration, that shows that the contact reaches there.
constexpr double kOverclosure = 1e-8;

constexpr int kMostNodes = 25000000;  // of a window: some ten gigabytes

class LoadCaseSolver {
 public:
  LoadCaseSolver(const MeshModel& model, const LoadCase& load_case, const Options& options, Watch& watch)
      : model_(model),
        load_case_(load_case),
        options_(options),
        formulation_{
            .compliance = options.compliance, .patch_load = options.patch_load, .tangential = load_case.friction > 0.0},
        limits_{.max_iterations = options.max_iterations, .max_unknowns = kMaxUnknowns},
        execution_{.threads = options.threads, .watch = watch},
        grid_(model.grid()),
        swelling_(1.0 + model.centrifugal() / grid_.radius) {}

  [[nodiscard]] Result solve() const {
    if (load_case_.load > unbearable_load(model_.coating())) reject_load("would be pressed through any such coating");
    const double estimate =
        estimate_contact_radius(model_.coating().sphere(), load_case_.angular_speed, load_case_.load);
    // Beyond 60 degrees the plane runs along the surface rather than against it, and no load can be borne.
    const int phi_limit = model_.mesh().nodes_per_revolution / 6;
    const int theta_limit = theta_nodes_per_revolution(model_.mesh()) / 6;
    const auto half_width = [&](double spacing) {
      return static_cast<int>(std::ceil(1.1 * estimate / (grid_.radius * spacing))) + 2;
    };
    int phi = std::min(half_width(grid_.phi_spacing), phi_limit);
    int theta = std::min(half_width(grid_.theta_spacing), theta_limit);
    for (;;) {
      if (std::optional<Result> result = solve_in_window(phi, theta, estimate)) return *std::move(result);
      if (phi == phi_limit && theta == theta_limit) reject_load("is in contact over 60 degrees to a side");
      phi = std::min(phi + phi / 2 + 1, phi_limit);
      theta = std::min(theta + theta / 2 + 1, theta_limit);
    }
  }

 private:
  /// @return nothing where the contact reaches the edge of the window
  [[nodiscard]] std::optional<Result> solve_in_window(int half_phi, int half_theta, double estimate) const {
    require_few_nodes(half_phi, half_theta);
    const CandidateSurface surface{
        .formulation = formulation_,
        .window = {grid_, {-half_phi, half_phi}, {-half_theta, half_theta}},
        .tables = model_.tables(formulation_, TableKind::displacement, 2 * half_phi, 2 * half_theta, execution_),
        .swelling = swelling_};
    try {
      LocatedContact located = solve_contact(surface, estimate);
      for (;;) {
        const bool boxed = !located.window.covers_same(surface.window);
        const bool at_edge = touches_edge(located.contact, located.window.shape());
        if (!boxed && at_edge) return std::nullopt;
        const double lost = lost_work(located);
        const ContactSolution whole = extended(std::move(located), surface, execution_);
        const bool overclosed = whole.gap.minCoeff() < -kOverclosure * whole.penetration;
        if (!boxed || !(at_edge || overclosed)) return result(surface.window, whole, lost);
        located = solve_whole(whole, surface);
      }
    } catch (const std::length_error& error) {
      reject("mesh.nodes_per_revolution", "coarse enough for " + std::to_string(kMaxUnknowns) + " unknown forces",
             std::to_string(model_.mesh().nodes_per_revolution) + " (" + error.what() + ")");
    }
  }

  [[nodiscard]] Result result(const SurfaceWindow& window, const ContactSolution& contact, double lost_work) const {
    if (!(contact.penetration > 0.0)) {
      throw ConvergenceError("the load was found to lift the sphere", contact.iterations, contact.residual);
    }
    require_clear_of_core(contact.penetration - model_.centrifugal());
    return make_result(window, contact,
                       {.load_case = load_case_,
                        .mesh = model_.mesh(),
                        .compliance = options_.compliance,
                        .patch_load = options_.patch_load,
                        .coating_thickness = coating_thickness(model_.coating().sphere()),
                        .centrifugal = model_.centrifugal(),
                        .lost_work = lost_work});
  }

  [[nodiscard]] LocatedContact solve_contact(const CandidateSurface& surface, double estimate) const {
    if (load_case_.friction > 0.0) {
      return solve_multilevel(surface, FrictionalLoad{load_case_, options_.slip_kinematics}, estimate, limits_,
                              execution_);
    }
    return solve_multilevel(surface, load_case_.load, estimate, limits_, execution_);
  }

  /// The contact again on the whole window, where the box that was thought to hold it does not.
  [[nodiscard]] LocatedContact solve_whole(const ContactSolution& found, const CandidateSurface& surface) const {
    LocatedContact located = solve_on_window(found, surface, load_case_.load, limits_, execution_);
    if (load_case_.friction == 0.0) return located;
    return add_friction(std::move(located), surface, {load_case_, options_.slip_kinematics}, limits_);
  }

  [[nodiscard]] double lost_work(const LocatedContact& located) const {
    const WindowShape shape = located.window.shape();
    const auto tables =
        model_.tables(formulation_, TableKind::lost_work, shape.phi_nodes - 1, shape.theta_nodes - 1, execution_);
    return detail::lost_work(formulation_, located.window, *tables, located.contact.force, execution_);
  }

  void require_few_nodes(int half_phi, int half_theta) const {
    const double nodes = (2.0 * half_phi + 1.0) * (2.0 * half_theta + 1.0);
    if (nodes > kMostNodes) throw MeshTooFine(model_.mesh().nodes_per_revolution, nodes, kMostNodes);
  }

  [[noreturn]] void reject_load(const std::string& reason) const {
    reject("load", "small enough for the coating",
           text(load_case_.load) + " N (the sphere " + reason + relaxation_note() + ")");
  }

  /// What makes a load too large that a layer would bear if it did not relax.
  [[nodiscard]] std::string relaxation_note() const {
    constexpr double kNextToNothing = 1e-3;  // of the modulus with which the layer passes the contact
    const std::vector<Layer>& layers = model_.coating().sphere().layers;
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const std::array frequencies{0.0, load_case_.angular_speed * model_.mesh().nodes_per_revolution / 2.0};
      const auto moduli = complex_modulus(layers[i].shear_modulus, frequencies);
      const double share = moduli.front().real() / std::abs(moduli.back());
      if (share < kNextToNothing) {
        return "; layers[" + std::to_string(i) + "].shear_modulus relaxes to " + rounded(moduli.front().real()) +
               " Pa, " + rounded(share) + " of what it is in rolling, and steady rolling has relaxed for ever";
      }
    }
    return "";
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
  Formulation formulation_;
  ContactOptions limits_;
  Execution execution_;
  SurfaceGrid grid_;
  double swelling_;  // of the free surface, by the turning
};

}  // namespace

MeshTooFine::MeshTooFine(int nodes_per_revolution, double window_nodes, int most)
    : std::invalid_argument("mesh.nodes_per_revolution must be coarse enough for " + std::to_string(most) +
                            " nodes around the contact, got " + std::to_string(nodes_per_revolution) + " (it makes " +
                            text(window_nodes) + " nodes)") {}

Result solve_load_case(const MeshModel& model, const LoadCase& load_case, const Options& options, Watch& watch) {
  return LoadCaseSolver(model, load_case, options, watch).solve();
}

}  // namespace viscoroll::detail

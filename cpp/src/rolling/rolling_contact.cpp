#include "rolling/rolling_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "contact/multilevel.hpp"
#include "rolling/contact_estimate.hpp"
#include "rolling/drives.hpp"
#include "rolling/initial_gap.hpp"
#include "rolling/result.hpp"
#include "rolling/rigid_slip.hpp"
#include "rolling/rolling_body.hpp"
#include "surface/sphere_operator.hpp"
#include "surface/sum_operator.hpp"
#include "validate.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// Overclosure outside the box of a contact, per penetration, that shows that the contact reaches there.
constexpr double kOverclosure = 1e-8;

/// Smallest gap of the nodes that a box leaves out.
double least_gap_outside(const Window& box, Eigen::ArrayXd gap, const Window& window) {
  for_nodes_within(window, box, [&gap](Eigen::Index, Eigen::Index node) { gap[node] = 0.0; });
  return gap.minCoeff();
}

constexpr double kMarginOfEstimate = 1.1;  // of windows around a contact that was estimated, rather from above ...
constexpr double kMarginOfSeen = 1.2;      // ... and around one that was seen on a coarser mesh

constexpr int kRoughNodes = 16;  // from the lowest one to the edge of a window, on a mesh that is to show its size

constexpr double kPressedThrough = 10.0;  // depths in thicknesses that no coating bears

constexpr Eigen::Index kFewNodes = 1024;  // that show whether a window holds a contact
constexpr int kMostNodes = 25000000;      // of a window: some ten gigabytes

class LoadCaseSolver {
 public:
  LoadCaseSolver(const MeshModel& model, const LoadCase& load_case, const Options& options, Watch& watch)
      : model_(model),
        load_case_(load_case),
        options_(options),
        formulation_{.compliance = options.compliance,
                     .patch_load = options.patch_load,
                     .tangential = load_case.friction > 0.0,
                     .collocation = model.collocation()},
        limits_{.max_iterations = options.max_iterations},
        execution_{.threads = options.threads, .watch = watch},
        grid_(model.grid()),
        swelling_(1.0 + model.centrifugal() / grid_.radius) {}

  [[nodiscard]] Result solve(const std::optional<ContactReach>& seen) const {
    if (is_roller(model_.body()) && options_.patch_load != PatchLoad::flat) {
      reject("patch_load", "FLAT with a cylinder", "SPHERICAL");
    }
    if (model_.track() != nullptr) require_plain_formulation();
    if (load_case_.load > unbearable_load(model_.pair(), model_.stiffest_modulus())) {
      reject_load("would be pressed through any such coating");
    }
    const double estimate = estimate_contact_radius(model_.pair(), load_case_.angular_speed, load_case_.load);
    require_lasting_stiffness(estimate);
    // Beyond 60 degrees the plane runs along the surface rather than against it, and no load can be borne.
    const int phi_limit = model_.mesh().nodes_per_revolution / 6;
    const int theta_limit = is_roller(model_.body()) ? 0 : theta_nodes_per_revolution(model_.mesh()) / 6;
    const ContactReach likely = seen.value_or(ContactReach{.along = estimate, .across = estimate});
    const double margin = seen ? kMarginOfSeen : kMarginOfEstimate;
    const auto half_width = [&](double reach, double spacing) {
      return static_cast<int>(std::ceil(margin * reach / (grid_.radius * spacing))) + 2;
    };
    int phi = std::min(half_width(likely.along, grid_.phi_spacing), phi_limit);
    int theta = std::min(half_width(likely.across, grid_.theta_spacing), theta_limit);
    const bool shallow = estimated_depth(estimate) < 0.5 * thickness(model_.pair());
    const bool cheap = is_roller(model_.body());  // a single row of nodes
    bool is_seen = seen.has_value();
    for (bool is_likely = cheap || shallow || is_seen;; is_likely = cheap) {
      const bool widest = phi == phi_limit && theta == theta_limit;
      if (is_likely || holds_rough_contact(phi, theta, estimate, widest)) {
        if (std::optional<Result> result = solve_in_window(phi, theta, estimate, widest, !is_seen))
          return *std::move(result);
      }
      is_seen = false;
      if (widest) reject_load("is in contact over 60 degrees to a side");
      phi = std::min(phi + phi / 2 + 1, phi_limit);
      theta = std::min(theta + theta / 2 + 1, theta_limit);
    }
  }

 private:
  /// @param[in] widest whether there is no wider window
  /// @param[in] uncertain whether the contact without friction is to show first that it fits
  /// @return nothing where the contact reaches the edge of the window
  [[nodiscard]] std::optional<Result> solve_in_window(int half_phi, int half_theta, double estimate, bool widest,
                                                      bool uncertain) const {
    require_few_nodes(half_phi, half_theta);
    const SurfaceWindow nodes(grid_, {{-half_phi, half_phi}, {-half_theta, half_theta}});
    const ContactProblem problem = make_problem(nodes);
    if (uncertain && problem.friction && !holds_pressed_contact(problem, estimated_depth(estimate), kFewNodes) &&
        !(widest && holds_pressed_contact(problem, estimated_depth(estimate), problem.initial_gap.size()))) {
      return std::nullopt;
    }
    LocatedContact located = solve_contact(problem, swelling_ * estimated_depth(estimate));
    for (;;) {
      const bool boxed = located.window() != nodes.window();
      const bool at_edge = touches_edge(located);
      if (!boxed && at_edge) return std::nullopt;
      const ContactSolution whole = extended(located, problem);
      const bool overclosed =
          least_gap_outside(located.window(), whole.gap, nodes.window()) < -kOverclosure * whole.penetration;
      if (!boxed || !(at_edge || overclosed)) {
        return result(nodes, problem, whole, located.problem.surface->dissipation(located.contact.force));
      }
      // The box that was thought to hold the contact does not.
      located = solve_on_window(problem, whole, limits_);
    }
  }

  /// Initial gap at the rim of the estimated contact, which is half as wide again as the contact.
  [[nodiscard]] double estimated_depth(double estimate) const {
    return grid_.radius - std::sqrt(std::max(std::pow(grid_.radius, 2) - std::pow(0.8 * estimate, 2), 0.0));
  }

  /// Whether a window holds the contact, as far as a mesh shows that is much coarser: of a load that is far beyond the
  /// estimate, or absurd, fine meshes on window after window would take long.
  [[nodiscard]] bool holds_rough_contact(int half_phi, int half_theta, double estimate, bool widest) const {
    if (half_phi < 3 * kRoughNodes) return true;
    // A larger window costs little where the torus says that it is needed and the sphere does not; a refused load does.
    const bool torus_will_do = model_.curvature() == Curvature::exact && !widest;
    const Curvature curvature = torus_will_do ? Curvature::sphere : model_.curvature();
    const double bearable_depth = kPressedThrough * thickness(model_.pair());
    try {
      if (rough_contact(half_phi, half_theta, estimate, curvature)) return true;
    } catch (const ConvergenceError&) {
      // Estimates are from above, if not by so much.
      if (estimated_depth(estimate) > bearable_depth) reject_load("would be pressed through it");
      throw;
    }
    const double angle = std::min(half_phi * grid_.phi_spacing, half_theta * grid_.theta_spacing);
    if (grid_.radius * (1.0 - std::cos(angle)) > bearable_depth) reject_load("would be pressed through it");
    return false;
  }

  /// Without friction, on a mesh that leaves a window kRoughNodes to a side. @return nothing where the contact reaches
  /// the edge
  [[nodiscard]] std::optional<Result> rough_contact(int half_phi, int half_theta, double estimate,
                                                    Curvature curvature) const {
    const double coarsening = static_cast<double>(half_phi) / kRoughNodes;
    const auto coarsened = [coarsening](int nodes) { return static_cast<int>(nodes / coarsening); };
    const Mesh mesh{.nodes_per_revolution = coarsened(model_.mesh().nodes_per_revolution),
                    .theta_nodes_per_revolution = coarsened(theta_nodes_per_revolution(model_.mesh()))};
    const MeshModel rough(model_.pair(), load_case_.angular_speed, mesh, curvature, options_.threads, execution_.watch);
    const LoadCase pressed{.load = load_case_.load, .angular_speed = load_case_.angular_speed};
    const auto scaled = [coarsening](int half) { return static_cast<int>(half / coarsening) + 1; };
    return LoadCaseSolver(rough, pressed, options_, execution_.watch)
        .solve_in_window(scaled(half_phi), scaled(half_theta), estimate, false, false);
  }

  [[nodiscard]] ContactProblem make_problem(const SurfaceWindow& nodes) const {
    const SurfaceWindow points = displaced_points(nodes);
    ContactProblem problem{.surface = make_surface(nodes),
                           .initial_gap = swelling_ * points.height() + counterpart_drop(points, model_.pair().on),
                           .normal_force = load_case_.load,
                           .friction = std::nullopt};
    if (load_case_.friction > 0.0) problem.friction = make_friction(nodes);
    return problem;
  }

  /// Of what rolls, of what it rolls on, or the sum of both.
  [[nodiscard]] std::shared_ptr<const SurfaceOperator> make_surface(const SurfaceWindow& nodes) const {
    std::shared_ptr<const SurfaceOperator> own;
    if (model_.sphere_tables() != nullptr) {
      own = on_exact_sphere(nodes);
    } else if (model_.own() != nullptr) {
      own = operator_of(*model_.own(), formulation_, nodes);
    }
    if (model_.track() == nullptr) return own;
    Formulation formulation = formulation_;
    formulation.is_counterpart = true;
    formulation.counterpart_curvature = counterpart_curvature(model_.pair());
    auto track = operator_of(*model_.track(), formulation, nodes);
    return own ? std::make_shared<SumOperator>(std::move(own), std::move(track)) : track;
  }

  [[nodiscard]] std::shared_ptr<const SurfaceOperator> operator_of(const TableStore& store,
                                                                   const Formulation& formulation,
                                                                   const SurfaceWindow& nodes) const {
    const auto tables = [&store, formulation, this](TableKind kind) {
      return [&store, formulation, kind, this](int phi_reach, int theta_reach) {
        return store.tables(formulation, kind, phi_reach, theta_reach, execution_);
      };
    };
    const WindowShape shape = nodes.shape();
    return std::make_shared<TableOperator>(formulation, nodes,
                                           tables(TableKind::displacement)(shape.phi_nodes - 1, shape.theta_nodes - 1),
                                           tables(TableKind::dissipation), execution_);
  }

  [[nodiscard]] std::shared_ptr<const SurfaceOperator> on_exact_sphere(const SurfaceWindow& nodes) const {
    SphereRequest request{.tangential = formulation_.tangential || formulation_.compliance == Compliance::vertical,
                          .power = false,
                          .patch_load = formulation_.patch_load,
                          .collocation = formulation_.collocation};
    const auto& [phi, theta] = nodes.window();
    const SphereTables& tables = *model_.sphere_tables();
    const double values = tables.values(request, theta.last);
    if (values > kMostHarmonicValues) {
      const std::string most = text(kMostHarmonicValues) + " values of harmonics";
      const std::string made = text(values) + " with curvature EXACT";
      if (const auto order = model_.mesh().max_order) {
        reject("mesh.max_order", "small enough for " + most, std::to_string(*order) + " (it makes " + made + ")");
      }
      throw MeshTooFine(model_.mesh().nodes_per_revolution, most, made);
    }
    auto influence = tables.influence(request, phi.count() - 1, theta.last, execution_);
    Formulation flat = formulation_;
    flat.patch_load = PatchLoad::flat;
    auto nearby = std::make_shared<const TableOperator>(
        flat, nodes, std::make_shared<const std::vector<Table>>(tables_around_equator(*influence)),
        TableOperator::DissipationSource{}, execution_);
    request.power = true;
    return std::make_shared<SphereOperator>(std::move(nearby), std::move(influence),
                                            [this, &tables, request](int phi_reach, int half_theta) {
                                              return tables.influence(request, phi_reach, half_theta, execution_);
                                            });
  }

  [[nodiscard]] Friction make_friction(const SurfaceWindow& nodes) const {
    const RigidSlip slip = rigid_slip(displaced_points(nodes), swelling_, options_.slip_kinematics, model_.pair(),
                                      given_motion(load_case_.drive));
    return {.coefficient = load_case_.friction,
            .rigid_slip = slip.own + slip.guided,
            .guided_slip = slip.guided,
            .step = grid_.radius * grid_.phi_spacing,
            .arms = lever_arms(nodes),
            .drive = row_of(load_case_.drive, pressure_share())};
  }

  /// D_2 = sum of p dw_2/d(way of the material): the force of the pressure along the counterpart's own deformed
  /// surface; under a rigid ball that is the ball's.
  [[nodiscard]] double drag(const SurfaceWindow& nodes, const ContactProblem& problem,
                            const ContactSolution& contact) const {
    switch (problem.surface->bodies()) {
      case Bodies::rolling:
        return 0.0;
      case Bodies::counterpart:
        return (pressing_force(contact) * (nodes.x() / grid_.radius - slope_of_counterpart(nodes))).sum();
      default:
        return problem.surface->pushback(contact.force);
    }
  }

  /// Undeformed, downwards along the way of the material.
  [[nodiscard]] Eigen::ArrayXd slope_of_counterpart(const SurfaceWindow& nodes) const {
    return -counterpart_curvature(model_.pair()) * pressure_lever(nodes, model_.pair());
  }

  /// What the tables of a counterpart are made for.
  void require_plain_formulation() const {
    const std::string why = " where the counterpart deforms";
    if (options_.compliance == Compliance::vertical) reject("compliance", "RADIAL" + why, "VERTICAL");
    if (options_.patch_load != PatchLoad::flat) reject("patch_load", "FLAT" + why, "SPHERICAL");
  }

  /// A half-space under a line load has no place that rests: each octave of longer waves adds as much to displacements.
  [[nodiscard]] bool approach_exists() const {
    return !is_roller(model_.body()) || std::isfinite(thickness(model_.pair()));
  }

  /// Of what rolls by itself.
  [[nodiscard]] static VectorField own_displacement(const ContactProblem& problem, const ContactSolution& contact) {
    if (problem.surface->bodies() == Bodies::rolling) return contact.displacement;
    return problem.surface->rolling_displacement(contact.force);
  }

  [[nodiscard]] LeverArms lever_arms(const SurfaceWindow& nodes) const {
    LeverArms arms{.x = swelling_ * nodes.x(), .y = swelling_ * nodes.y(), .radius = grid_.radius};
    if (counterpart_curvature(model_.pair()) != 0.0) arms.slope = slope_of_counterpart(nodes);
    return arms;
  }

  /// Where displacements are taken.
  [[nodiscard]] SurfaceWindow displaced_points(const SurfaceWindow& nodes) const {
    return {grid_, nodes.window(), formulation_.collocation};
  }

  /// With the radial compliance pressure does no work along the plane.
  [[nodiscard]] double pressure_share() const { return options_.compliance == Compliance::vertical ? 1.0 : 0.0; }

  [[nodiscard]] Result result(const SurfaceWindow& nodes, const ContactProblem& problem, const ContactSolution& contact,
                              const Losses& losses) const {
    if (approach_exists() && !(contact.penetration > 0.0)) {
      reject("friction", "so small that the forces along the plane do not lift the sphere out of its own contact",
             text(load_case_.friction));
    }
    require_clear_of_core(contact.penetration - model_.centrifugal());
    const SurfaceWindow points = displaced_points(nodes);
    return make_result(nodes, contact,
                       {.load_case = load_case_,
                        .mesh = model_.mesh(),
                        .arms = displaced(lever_arms(nodes), own_displacement(problem, contact), pressure_share()),
                        .curvature = model_.curvature(),
                        .patch_load = options_.patch_load,
                        .thickness = layer_thickness(model_.pair()),
                        .half_space_share = half_space_share(model_.pair()),
                        .centrifugal = model_.centrifugal(),
                        .approach_exists = approach_exists(),
                        .height = points.height() + counterpart_drop(points, model_.pair().on),
                        .losses = losses,
                        .lever = pressure_lever(nodes, model_.pair()),
                        .counterpart_curvature = counterpart_curvature(model_.pair()),
                        .drag = drag(nodes, problem, contact)});
  }

  [[nodiscard]] LocatedContact solve_contact(const ContactProblem& problem, double likely_depth) const {
    try {
      return solve_multilevel(problem, likely_depth, limits_);
    } catch (const ConvergenceError&) {
      if (const auto torque = given_motion(load_case_.drive).torque) require_rolling(problem, likely_depth, *torque);
      throw;
    }
  }

  /// Refuse a driving torque that is out of reach of the moments of a sphere that slides as a whole.
  void require_rolling(const ContactProblem& problem, double likely_depth, double torque) const {
    // In a contact over 60 degrees the lever of friction is half of the radius; that of the pressure is no larger than
    // it.
    const double unit = load_case_.load * outer_radius(model_.pair().body);
    if (std::abs(torque) < (0.5 * load_case_.friction - 1.0) * unit) return;
    // No lever of friction is longer than the radius, nor is that of the pressure about the center, nor the slope of a
    // counterpart times it.
    const double largest = (load_case_.friction + 2.0) * unit;
    std::array<double, 2> limits{};
    try {
      limits = sliding_moments(problem, likely_depth);
    } catch (const ConvergenceError&) {
      limits = {-largest, largest};
    }
    if (torque > limits[0] && torque < limits[1]) return;
    reject(
        "drive.torque",
        "between " + rounded(limits[0]) + " N m and " + rounded(limits[1]) + " N m, else the sphere slides without end",
        text(torque) + " N m");
  }

  /// Moments about the center of a sphere that skids, and of one that spins on the spot.
  [[nodiscard]] std::array<double, 2> sliding_moments(ContactProblem problem, double likely_depth) const {
    std::array<double, 2> moments{};
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
      problem.friction->drive = std::make_shared<GivenCreepage>(side == 0 ? 1.0 : -1.0);
      const LocatedContact sliding = solve_multilevel(problem, likely_depth, limits_);
      moments[side] = moment_about_center({*sliding.problem.surface, sliding.problem.friction->arms,
                                           sliding.contact.force, sliding.contact.displacement},
                                          pressure_share());
    }
    return moments;
  }

  /// Whether a window holds the contact without friction, before stick and slip are sought; loads that press the sphere
  /// to the core are refused.
  /// @param[in] most_nodes up to which every other node is left out
  [[nodiscard]] bool holds_pressed_contact(ContactProblem problem, double likely_depth, Eigen::Index most_nodes) const {
    problem.friction.reset();
    while (problem.initial_gap.size() > most_nodes) problem = coarsened(problem);
    const LocatedContact pressed = solve_multilevel(problem, likely_depth, limits_);
    if (pressed.window() == problem.surface->window() && touches_edge(pressed)) return false;
    require_clear_of_core(pressed.contact.penetration - model_.centrifugal());
    return true;
  }

  void require_few_nodes(int half_phi, int half_theta) const {
    const double nodes = (2.0 * half_phi + 1.0) * (2.0 * half_theta + 1.0);
    if (nodes > kMostNodes) {
      throw MeshTooFine(model_.mesh().nodes_per_revolution, std::to_string(kMostNodes) + " nodes around the contact",
                        text(nodes) + " nodes");
    }
  }

  [[noreturn]] void reject_load(const std::string& reason) const {
    reject("load", "small enough for the coating",
           text(load_case_.load) + " " + std::string(load_unit(model_.body())) + " (the " +
               std::string(name(model_.body())) + " " + reason + ")");
  }

  /// The layer that relaxes most, and to which share of its modulus at the frequency of what passes the contact.
  struct Relaxation {
    std::string layer;
    double modulus;  ///< relaxed [Pa]
    double share;
  };

  [[nodiscard]] Relaxation strongest_relaxation(double contact_radius) const {
    const std::array frequencies{0.0, load_case_.angular_speed * std::max(1.0, grid_.radius / contact_radius)};
    Relaxation strongest{.layer = "", .modulus = 0.0, .share = 2.0};
    for (const auto& [name, layer] : layers(model_.pair())) {
      const auto moduli = complex_modulus(layer.shear_modulus, frequencies);
      const double share = moduli.front().real() / std::abs(moduli.back());
      if (share < strongest.share) strongest = {.layer = name, .modulus = moduli.front().real(), .share = share};
    }
    return strongest;
  }

  /// Steady rolling has gone on for ever: order m = 0 has relaxed, and leaves a groove all around that a modulus of
  /// next to nothing cannot bound.
  void require_lasting_stiffness(double contact_radius) const {
    constexpr double kLeastShare = 3e-3;  // below, sets of nodes in contact do not settle
    const Relaxation relaxation = strongest_relaxation(contact_radius);
    if (relaxation.share >= kLeastShare) return;
    reject(relaxation.layer + ".shear_modulus",
           "one that relaxes to " + text(kLeastShare) + " of what it is in passing the contact at the least",
           "a relaxed modulus of " + rounded(relaxation.modulus) + " Pa, " + rounded(relaxation.share) + " of it");
  }

  void require_clear_of_core(double penetration) const {
    const double thickness = detail::thickness(model_.pair());
    if (!std::isfinite(penetration)) throw ConvergenceError("the contact equations have no finite solution", 0, 1.0);
    if (penetration >= thickness) {
      reject_load("is pressed " + rounded(penetration) + " m into a coating of " + text(thickness) + " m");
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

MeshTooFine::MeshTooFine(int nodes_per_revolution, const std::string& most, const std::string& made)
    : std::invalid_argument("mesh.nodes_per_revolution must be coarse enough for " + most + ", got " +
                            std::to_string(nodes_per_revolution) + " (it makes " + made + ")") {}

ContactReach contact_reach(const Result& result) {
  ContactReach reach{.along = 0.0, .across = 0.0};
  for (std::size_t node = 0; node < result.contact.size(); ++node) {
    if (result.contact[node] == 0) continue;
    reach.along = std::max(reach.along, std::abs(result.x[node]));
    reach.across = std::max(reach.across, std::abs(result.z[node]));
  }
  return reach;
}

Result solve_load_case(const MeshModel& model, const LoadCase& load_case, const Options& options, Watch& watch,
                       const std::optional<ContactReach>& seen) {
  return LoadCaseSolver(model, load_case, options, watch).solve(seen);
}

}  // namespace viscoroll::detail

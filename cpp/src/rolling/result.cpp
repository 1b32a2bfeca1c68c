#include "rolling/result.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "contact/contact_extent.hpp"
#include "modal/harmonic_moduli.hpp"
#include "rolling/adhesion.hpp"
#include "rolling/drives.hpp"
#include "rolling/initial_gap.hpp"
#include "rolling/pressure_peak.hpp"

namespace viscoroll {

FrozenContact frozen_contact(const Result& result) {
  return {.phi_nodes = result.phi_nodes,
          .theta_nodes = result.theta_nodes,
          .contact = result.contact,
          .stick = result.stick,
          .pressure = result.pressure,
          .shear_traction = result.shear_traction,
          .penetration = result.penetration.value_or(0.0),
          .creepage = result.creepage.value_or(0.0)};
}

}  // namespace viscoroll

namespace viscoroll::detail {
namespace {

using Eigen::ArrayX2d;
using Eigen::ArrayXd;
using Eigen::Index;

/// Values in the type of the result, without an intermediate array: on large windows these arrays take most of the
/// memory.
template <class Values>
std::vector<double> to_vector(const Eigen::ArrayBase<Values>& values) {
  std::vector<double> result(static_cast<std::size_t>(values.size()));
  Eigen::Map<ArrayXd>(result.data(), values.size()) = values;
  return result;
}

/// Two columns with a number of rows, one after the other, filled by a function.
template <class Function>
std::vector<double> columns(Index rows, const Function& function) {
  std::vector<double> result(2 * static_cast<std::size_t>(rows));
  Eigen::Map<ArrayX2d> both(result.data(), rows, 2);
  function(both);
  return result;
}

/// Moment arms of loaded nodes, displaced by the rolling body's own displacement.
MomentArms displaced_arms(const ContactSetup& given, const WindowContact& solved, const std::vector<Index>& contact) {
  const double share = given.pressure_work_factor();
  const MomentArms arms =
      displaced(given.moment_arms(solved.nodes, contact), solved.contact.displacement(contact, Eigen::all), share);
  const VectorField& counterbody = solved.contact.counterbody_displacement;
  return counterbody.rows() == 0 ? arms : displaced(arms, -counterbody(contact, Eigen::all), share);
}

std::vector<unsigned char> mask(const std::vector<Index>& nodes, Index size) {
  std::vector<unsigned char> values(static_cast<std::size_t>(size), 0);
  for (const Index node : nodes) values[static_cast<std::size_t>(node)] = 1;
  return values;
}

/// Sum of forces or moments, without the round-off of canceling terms and the remainder of an iteration towards a given
/// value.
double settled(double sum, double largest_summand, std::optional<double> given = std::nullopt) {
  constexpr double kRoundOff = 1e-12;
  constexpr double kIterationError = 1e-9;
  if (given && std::abs(sum - *given) < kIterationError * largest_summand) return *given;
  return std::abs(sum) < kRoundOff * largest_summand ? 0.0 : sum;
}

/// D_2 = sum of p dw_2/dxi: force of the pressure along the counterbody's deformed surface. Under a rigid ball it
/// follows from the surface of the ball.
double deformed_slope_force(const ContactSetup& given, const WindowContact& solved, const std::vector<Index>& contact) {
  switch (solved.problem.surface->deforming()) {
    case Deforming::rolling:
      return 0.0;
    case Deforming::counterbody: {
      const ArrayXd slope = counterbody_slope(solved.nodes, given.pair.growth, given.pair, contact);
      return -(solved.contact.force.col(kDown)(contact) *
               (solved.nodes.x()(contact) / solved.nodes.grid().radius - slope))
                  .sum();
    }
    default:
      return solved.problem.surface->slope_force(solved.contact.force);
  }
}

/// Areas by which the forces on patches are divided: those of the patches, or that of the paper's flat patch, which has
/// the size of the patches on the equator [m^2].
ArrayXd traction_area(const ContactSetup& given, const SurfaceGrid& grid, const ArrayXd& area) {
  if (given.options.patch_load != PatchLoad::flat || given.model.curvature == Curvature::exact) return area;
  return ArrayXd::Constant(area.size(), std::pow(grid.radius, 2) * grid.phi_spacing * grid.theta_spacing);
}

/// Set the relative errors of linear theory that follow from the strain. They cover finite elements of balls in slow
/// rolling (tests/reference/finite_strain_table.py) and of rollers at three speeds (docs/theory/finite-strain.md).
/// @param[in] is_ball whether the rolling body is a ball, whose torque deviates less than that of rollers and wheels
/// @param[in] further relative error due to the layer equations
void set_model_errors(Result& r, bool is_ball, double further) {
  const double strain = std::abs(*r.strain);
  r.model_error = (is_ball ? 0.75 : 0.9 + 4.5 * strain) * strain + further;
  r.finite_strain_torque_error = (0.5 + 4.0 * strain * strain) * strain + further;
  r.penetration_model_error = strain + further;
  r.max_pressure_model_error = 0.9 * strain + further;
  r.contact_length_model_error = strain + further;
}

/// Whether a body returns all work: it is rigid, or its layers have no loss.
bool returns_all_work(const Body& body) {
  return std::ranges::all_of(body.layers(),
                             [](const NamedLayer& named) { return is_lossless(named.layer.shear_modulus); });
}

/// Computes the results of a solved contact, one group of members after the other.
class Summary {
 public:
  Summary(const ContactSetup& given, const WindowContact& solved)
      : given_(given),
        window_(solved.nodes),
        contact_(solved.contact),
        losses_(solved.losses),
        size_(window_.shape().size()),
        loaded_(loaded_nodes(contact_)),
        force_(contact_.force(loaded_, Eigen::all)),
        arms_(displaced_arms(given, solved, loaded_)),
        curvature_(given.pair.growth.met() * given.pair.on->curvatures().along),
        slope_force_(deformed_slope_force(given, solved, loaded_)),
        area_(window_.patch_area(loaded_)),
        traction_area_(traction_area(given, window_.grid(), area_)) {}

  void add_status(Result& r) const {
    r.status = contact_.converged ? Status::converged : Status::max_iterations;
    r.iterations = contact_.iterations;
    r.residual = contact_.residual;
    r.operator_applications = contact_.operator_applications;
  }

  void add_shape(Result& r) const {
    r.centrifugal_displacement = given_.pair.centrifugal;
    if (contact_.adhesion) {
      add_adhesive_shape(r);
    } else {
      contact_extent(window_, contact_.contact, area_, -force_.col(kDown) / traction_area_).copy_to(r);
    }
    if (!approach_exists(given_.pair)) return;
    const double penetration = given_.load_case.penetration.value_or(contact_.penetration - given_.pair.centrifugal);
    r.penetration = penetration;
    r.center_height = radius() - penetration;
    // In a half-space, the contact width takes the place of the thickness.
    const double contact_size = std::sqrt(r.semi_axis_x * r.semi_axis_z.value_or(r.semi_axis_x));
    r.strain = penetration /
               (layer_thickness(given_.pair) + half_space_share(given_.pair, given_.pair.angular_speed) * contact_size);
  }

  void add_forces(Result& r) const {
    const auto forward = force_.col(kForward);
    const std::vector<Index>& contact = loaded_;
    r.load = given_.load_case.load.value_or(-force_.col(kDown).sum());
    const double load = force_scale(r);
    if (is_reversible()) return;
    r.resisting_torque = -(pressure_moment_arm(window_, given_.pair, contact) * force_.col(kDown)).sum();
    const GivenMotion motion = given_motion(given_.load_case);
    r.driving_force = settled(-forward.sum() + counterbody_force(r), load, motion.force);
    const auto sideways = force_.col(kSideways);
    r.lateral_force = settled(sideways.sum(), load);
    r.spin_moment =
        settled((window_.z()(contact) * forward - window_.x()(contact) * sideways).sum(), load * r.semi_axis_x);

    // The slope of the counterbody reduces the moment of the pressure about the center.
    r.driving_torque = settled(moment(arms_, force_) - radius() * counterbody_force(r), load * radius(), motion.torque);
  }

  void add_powers(Result& r) const {
    const LoadCase& load_case = given_.load_case;
    const GivenMotion motion = given_motion(load_case);
    r.creepage = motion.creepage ? motion.creepage : contact_.creepage;
    if (r.creepage) r.linear_speed = (1.0 + *r.creepage) * load_case.angular_speed * radius();
    const double speed = r.linear_speed.value_or(load_case.angular_speed * radius());
    // The sum over the spectrum of a lossless body is round-off.
    const auto& [body, on] = static_cast<const RollingPair&>(given_.pair);
    r.rolling_bulk_power = returns_all_work(*body) ? 0.0 : load_case.angular_speed * losses_.rolling;
    r.counterbody_bulk_power = returns_all_work(*on) ? 0.0 : std::abs(speed) / radius() * losses_.counterbody;
    r.bulk_power = r.rolling_bulk_power + r.counterbody_bulk_power;
    if (contact_.slip.rows() > 0) {
      r.slip_power = slip_power();
    }
    if (contact_.adhesion) r.adhesion_power = std::abs(speed) * contact_.adhesion->lost_work;
    r.dissipated_power = r.bulk_power + r.slip_power + r.adhesion_power.value_or(0.0);
    r.rolling_resistance_force = r.dissipated_power == 0.0 ? 0.0 : r.dissipated_power / std::abs(speed);
    r.rolling_resistance_torque = r.dissipated_power / load_case.angular_speed;
    r.rolling_resistance_coefficient = coefficient(r, std::abs(speed));
    double work =
        r.driving_torque * load_case.angular_speed + (r.driving_force + force_of_turning_counterbody(r)) * speed;
    const double guided = r.lateral_force * motion.lateral_creepage + r.spin_moment * motion.spin;
    work -= guided * load_case.angular_speed * radius();
    // Smaller powers, relative to the largest torque that the load could cause, are round-off of a lossless coating.
    const double negligible =
        std::max(1e-10 * force_scale(r) * load_case.angular_speed * r.semi_axis_x, std::numeric_limits<double>::min());
    r.energy_balance_error =
        std::abs(work - r.dissipated_power) / std::max({std::abs(work), std::abs(r.dissipated_power), negligible});
  }

  void add_fields(Result& r) const {
    r.pressure.assign(static_cast<std::size_t>(size_), 0.0);
    const Eigen::Map<ArrayXd> pressures(r.pressure.data(), size_);
    put(-force_.col(kDown) / traction_area_, pressures);
    r.max_pressure_error = unresolved_peak(pressures, contact_.contact, window_.shape().theta_nodes);
    r.mesh = given_.model.mesh;
    r.phi_nodes = window_.shape().phi_nodes;
    r.theta_nodes = window_.shape().theta_nodes;
    r.x = to_vector(window_.x());
    r.z = to_vector(window_.z());
    r.gap = to_vector(contact_.gap);
    // The gap is H - y - u_y, so the upward displacement -u_y is gap + y - H, and H = r_o - penetration.
    ArrayXd rise = initial_gap(given_.displaced_points(window_), {}, given_.pair);
    rise = contact_.gap - rise;
    r.displacement = to_vector(rise + r.penetration.value_or(-rise[window_.window().number_of(0, 0)]));
    r.contact = mask(contact_.contact, size_);
    r.stick = mask(contact_.stick, size_);
    r.slip = r.contact;
    for (const Index node : contact_.stick) r.slip[static_cast<std::size_t>(node)] = 0;
    r.shear_traction = columns(size_, [&](auto& shear) {
      put(force_.col(kForward) / traction_area_, shear.col(0));
      put(force_.col(kSideways) / traction_area_, shear.col(1));
    });
    r.slip_velocity = columns(size_, [&](auto& velocity) { add_slip_velocity(velocity); });
  }

  /// Results that depend on the distance to the ends of the outermost patches. The fields must be set.
  void add_limits(Result& r) const {
    const ContactReach reach = reach_of_patches(r, window_.grid());
    const double clear = 0.5 * width(given_.pair) - reach.across;
    // Patches end at the side faces except for round-off.
    if (std::isfinite(clear)) r.face_distance = clear > 1e-9 * reach.across ? clear : 0.0;
    if (!r.strain) return;
    const auto& [body, on] = static_cast<const RollingPair&>(given_.pair);
    const bool is_ball = !body->form().is_line() && !std::isfinite(body->width());
    set_model_errors(r, is_ball, body->further_error(reach) + on->further_error(reach));
  }

 private:
  /// Set the shape of a contact with adhesion, whose pressure does not vanish at its edges.
  void add_adhesive_shape(Result& r) const {
    const std::vector<Index>& contact = contact_.contact;
    const AdhesiveEdges& edges = *contact_.adhesion;
    const auto touching = static_cast<Index>(contact.size());
    contact_extent(window_, contact, window_.patch_area(contact), ArrayXd::Ones(touching)).copy_to(r);
    r.max_pressure =
        (-contact_.force.col(kDown)(contact) / traction_area(given_, window_.grid(), window_.patch_area(contact)))
            .maxCoeff();
    const bool is_line = window_.window().is_line();
    const EdgeReleases edges_alone = releases_at_edges(given_);
    const Adhesion& adhesion = *given_.load_case.adhesion;
    r.attracted_area = is_line ? area_.sum() : r.contact_area + window_.patch_area(edges.zone).sum();
    r.opening_energy_ratio = edges_alone.opening / adhesion.separation_work.value_or(adhesion.work);
    r.closing_energy_ratio = edges_alone.closing / adhesion.work;
    r.cohesive_zone_nodes =
        std::max(edges.zone_length, edges_alone.shorter_zone) / node_spacing(window_.grid(), is_line);
  }

  /// Force to which sums of forces are compared [N]: the load, or with adhesion the sum of pressing and pulling forces.
  [[nodiscard]] double force_scale(const Result& r) const {
    return contact_.adhesion ? force_.col(kDown).abs().sum() : r.load;
  }

  /// Dissipated power per load and speed; infinite unless the load is positive.
  [[nodiscard]] static double coefficient(const Result& r, double speed) {
    if (!(r.load > 0.0)) return std::numeric_limits<double>::infinity();
    return r.dissipated_power == 0.0 ? 0.0 : r.dissipated_power / (r.load * speed);
  }

  [[nodiscard]] double radius() const { return window_.grid().radius; }

  /// Whether the contact has no loss at all. Its pressure is then even in x, because the response to a load is even in
  /// the distance if all compliances are real, so that torques and forces along the path vanish except for round-off.
  [[nodiscard]] bool is_reversible() const {
    const auto& [body, on] = static_cast<const RollingPair&>(given_.pair);
    const std::optional<Adhesion>& adhesion = given_.load_case.adhesion;
    return given_.load_case.friction == 0.0 && returns_all_work(*body) && returns_all_work(*on) &&
           !(adhesion && adhesion->separation_work);
  }

  /// Set the values of the loaded nodes in a field of all nodes.
  template <class Values, class Field>
  void put(const Values& values, Field field) const {
    Index i = 0;
    for (const Index node : loaded_) field[node] = values[i++];
  }

  /// Backward force of the pressure on the body, due to the deformed and curved surface of the counterbody.
  [[nodiscard]] double counterbody_force(const Result& r) const {
    return slope_force_ - r.resisting_torque * curvature_;
  }

  /// Force whose work supplements that of the force on the center if the counterbody turns: the moment about the axis
  /// of the counterbody, divided by its radius.
  [[nodiscard]] double force_of_turning_counterbody(const Result& r) const {
    if (curvature_ == 0.0) return 0.0;
    double moment = r.resisting_torque;
    if (r.center_height) moment += ((arms_.y - *r.center_height) * force_.col(kForward)).sum();
    return curvature_ * moment;
  }

  /// Set the slip velocity of the nodes in contact; a node takes spacing / Omega to reach its neighbor's position.
  void add_slip_velocity(Eigen::Map<ArrayX2d>& velocity) const {
    if (contact_.slip.rows() == 0) return;
    const double rate = given_.load_case.angular_speed / window_.grid().phi_spacing;
    for (const Index node : contact_.contact) velocity.row(node) = rate * contact_.slip.row(node);
  }

  /// Power dissipated by slip. The patch of a node extends half a spacing to both neighbors, so that its force acts
  /// over half of the slip from the previous node and half of the slip to the next node. If the next node has left the
  /// contact, it may move ahead of the force; friction supplies no power, so such a node contributes nothing.
  [[nodiscard]] double slip_power() const {
    const Index stride = window_.shape().theta_nodes;
    const Index rest = size_ - stride;
    const auto work = [&](Index column, Axis axis) -> ArrayXd {
      const auto force = contact_.force.col(axis).head(rest);
      const auto slip = contact_.slip.col(column);
      return -0.5 * force * (slip.head(rest) + slip.tail(rest));
    };
    const ArrayXd taken = (work(0, kForward) + work(1, kSideways)).max(0.0);
    return given_.load_case.angular_speed / window_.grid().phi_spacing * taken.sum();
  }

  const ContactSetup& given_;
  const SurfaceWindow& window_;
  const ContactSolution& contact_;
  const Losses& losses_;
  Index size_;
  std::vector<Index> loaded_;
  VectorField force_;      // on the nodes in contact
  MomentArms arms_;        // of the loaded nodes, displaced
  double curvature_;       // of the counterbody along the path, with centrifugal growth [1/m]
  double slope_force_;     // D_2, force of the pressure along the deformed surface of the counterbody [N]
  ArrayXd area_;           // of the patches in contact [m^2]
  ArrayXd traction_area_;  // by which forces on these patches are divided [m^2]
};

/// Extent of the nodes that fulfill a condition.
template <class Condition>
ContactReach reach_where(const Result& result, const Condition& condition) {
  ContactReach reach{.along = 0.0, .across = 0.0};
  for (std::size_t node = 0; node < result.contact.size(); ++node) {
    if (!condition(node)) continue;
    reach.along = std::max(reach.along, std::abs(result.x[node]));
    reach.across = std::max(reach.across, std::abs(result.z[node]));
  }
  return reach;
}

}  // namespace

ContactReach contact_reach(const Result& result) {
  return reach_where(result, [&](std::size_t node) { return result.contact[node] != 0; });
}

ContactReach loaded_reach(const Result& result) {
  return reach_where(result,
                     [&](std::size_t node) { return result.contact[node] != 0 || result.pressure[node] != 0.0; });
}

ContactReach reach_of_patches(const Result& result, const SurfaceGrid& grid) {
  ContactReach reach = contact_reach(result);
  reach.along += 0.5 * grid.radius * grid.phi_spacing;
  reach.across += 0.5 * grid.radius * grid.theta_spacing;
  return reach;
}

Result make_result(const ContactSetup& given, const WindowContact& solved) {
  const Summary summary(given, solved);
  Result r;
  summary.add_status(r);
  summary.add_shape(r);
  summary.add_forces(r);
  summary.add_powers(r);
  summary.add_fields(r);
  summary.add_limits(r);
  r.error_estimate = r.energy_balance_error;
  r.refinements = {{.mesh = given.model.mesh,
                    .contact_nodes = static_cast<int>(solved.contact.contact.size()),
                    .resisting_torque = r.resisting_torque,
                    .penetration = r.penetration,
                    .energy_balance_error = r.energy_balance_error,
                    .error_estimate = r.error_estimate}};
  return r;
}

}  // namespace viscoroll::detail

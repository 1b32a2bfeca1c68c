#include "contact/stick_slip_system.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <variant>

#include "contact/dense_lu.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
constexpr std::array kAllAxes{kForward, kDown, kSideways};
constexpr Index kNone = -1;

/// Nodes that carry unknowns, and the images that share them where the problem is symmetric.
class Carriers {
 public:
  Carriers(const FrictionalContactProblem& problem, const std::vector<Index>& contact)
      : theta_nodes_(problem.shape.theta_nodes) {
    const auto* creepage = std::get_if<DriveCreepage>(&problem.drive);
    symmetric_ = creepage == nullptr || creepage->lateral_creepage == 0.0;
    for (std::size_t i = 0; i < contact.size(); ++i) {
      if (!symmetric_ || contact[i] % theta_nodes_ >= theta_nodes_ / 2) {
        nodes_.push_back(contact[i]);
        numbers_.push_back(i);
      }
    }
  }

  [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }
  /// Place of the i-th carrier in the list of all nodes in contact.
  [[nodiscard]] std::size_t number(std::size_t i) const { return numbers_[i]; }
  [[nodiscard]] bool symmetric() const { return symmetric_; }
  [[nodiscard]] Index mirror(Index node) const { return node + theta_nodes_ - 1 - 2 * (node % theta_nodes_); }
  [[nodiscard]] bool in_middle(Index node) const { return symmetric_ && mirror(node) == node; }
  /// How many nodes a carrier stands for.
  [[nodiscard]] double weight(Index node) const { return symmetric_ && !in_middle(node) ? 2.0 : 1.0; }

 private:
  Index theta_nodes_;
  bool symmetric_;
  std::vector<Index> nodes_;
  std::vector<std::size_t> numbers_;
};

/// An unknown: the multiple of a force on a carrier.
struct Unknown {
  std::size_t carrier;
  Eigen::Vector3d force;  // along x, y, z
};

std::vector<Unknown> list_unknowns(const Carriers& carriers, const ContactSets& sets, double friction) {
  std::vector<Unknown> unknowns;
  for (std::size_t i = 0; i < carriers.nodes().size(); ++i) {
    const TangentialState& state = sets.states[carriers.number(i)];
    const bool sideways = !carriers.in_middle(carriers.nodes()[i]);
    const auto& e = state.direction;
    if (state.stick) {
      unknowns.push_back({i, {0.0, -1.0, 0.0}});
      unknowns.push_back({i, {1.0, 0.0, 0.0}});
      if (sideways) unknowns.push_back({i, {0.0, 0.0, 1.0}});
    } else {
      unknowns.push_back({i, {friction * e[0], -1.0, sideways ? friction * e[1] : 0.0}});
      if (sideways) unknowns.push_back({i, {-e[1], 0.0, e[0]}});
    }
  }
  return unknowns;
}

/// Displacements of carriers and of their upstream neighbors by the unknowns.
class Response {
 public:
  Response(const FrictionalContactProblem& problem, const Carriers& carriers, const std::vector<Unknown>& unknowns)
      : places_(static_cast<std::size_t>(problem.shape.size()), kNone), theta_nodes_(problem.shape.theta_nodes) {
    for (const Index node : carriers.nodes()) add(node);
    for (const Index node : carriers.nodes()) add(node - theta_nodes_);
    const Eigen::MatrixXd compliance = assemble(problem.normal.coating, carriers);
    const auto sources = static_cast<Index>(carriers.nodes().size());
    matrix_.resize(compliance.rows(), static_cast<Index>(unknowns.size()));
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
      auto column = matrix_.col(static_cast<Index>(u));
      column.setZero();
      for (const Axis axis : kAllAxes) {
        const double force = unknowns[u].force[axis];
        if (force != 0.0) column += force * compliance.col(axis * sources + static_cast<Index>(unknowns[u].carrier));
      }
    }
  }

  /// Displacement of a node along an axis, a row over the unknowns.
  [[nodiscard]] auto displacement(Index node, Axis axis) const {
    return matrix_.row(axis * static_cast<Index>(targets_.size()) + places_[static_cast<std::size_t>(node)]);
  }
  /// Displacement of a node relative to its upstream neighbor.
  [[nodiscard]] auto difference(Index node, Axis axis) const {
    return displacement(node, axis) - displacement(node - theta_nodes_, axis);
  }

 private:
  void add(Index node) {
    Index& place = places_[static_cast<std::size_t>(node)];
    if (place != kNone) return;
    place = static_cast<Index>(targets_.size());
    targets_.push_back(node);
  }

  /// Compliance to forces on the carriers and, of opposite sideways direction, on their images.
  [[nodiscard]] Eigen::MatrixXd assemble(const CoatingCompliance& coating, const Carriers& carriers) const {
    Eigen::MatrixXd own = coating.block(targets_, carriers.nodes(), kAllAxes);
    if (!carriers.symmetric()) return own;
    std::vector<Index> images;
    for (const Index node : carriers.nodes()) images.push_back(carriers.mirror(node));
    const Eigen::MatrixXd image = coating.block(targets_, images, kAllAxes);
    const auto sources = static_cast<Index>(images.size());
    for (Index s = 0; s < sources; ++s) {
      if (carriers.in_middle(carriers.nodes()[static_cast<std::size_t>(s)])) continue;
      own.col(s) += image.col(s);
      own.col(sources + s) += image.col(sources + s);
      own.col(2 * sources + s) -= image.col(2 * sources + s);
    }
    return own;
  }

  std::vector<Index> places_;
  std::vector<Index> targets_;
  Index theta_nodes_;
  Eigen::MatrixXd matrix_;  // row axis * targets + place
};

/// The linear system: forces first, then the penetration times scales.normal and the speed ratio times
/// step * scales.tangential.
class System {
 public:
  System(const FrictionalContactProblem& problem, const ConditionScales& scales, const Carriers& carriers,
         const std::vector<Unknown>& unknowns, const Response& response)
      : problem_(problem),
        scales_(scales),
        carriers_(carriers),
        unknowns_(unknowns),
        response_(response),
        forces_(static_cast<Index>(unknowns.size())),
        matrix_(Eigen::MatrixXd::Zero(forces_ + 2, forces_ + 2)),
        right_(Eigen::MatrixXd::Zero(forces_ + 2, 1)) {
    if (const auto* drive = std::get_if<DriveCreepage>(&problem.drive))
      lateral_way_ = drive->lateral_creepage * problem.step;
  }

  void add_contact_conditions(const ContactSets& sets) {
    Index row = 0;
    for (std::size_t i = 0; i < carriers_.nodes().size(); ++i) {
      const Index node = carriers_.nodes()[i];
      const TangentialState& state = sets.states[carriers_.number(i)];
      touch(row++, node);
      if (state.stick) {
        stick(row++, node, kForward, problem_.ways[node]);
        if (!carriers_.in_middle(node)) stick(row++, node, kSideways, lateral_way_);
      } else if (!carriers_.in_middle(node)) {
        slip(row, node, state);
        ++row;
      }
    }
  }

  void balance_load() {
    for (Index u = 0; u < forces_; ++u) matrix_(forces_, u) = -weight(u) * force(u, kDown);
    right_(forces_) = problem_.normal.load;
  }

  /// The last row: which speed. A prescribed moment is linearized at `state`.
  void drive(const ContactSolution& state) {
    const Index row = forces_ + 1;
    if (const auto* given = std::get_if<DriveCreepage>(&problem_.drive)) {
      matrix_(row, row) = 1.0;
      right_(row) = (1.0 + given->creepage) * problem_.step * scales_.tangential;
    } else if (const auto* pull = std::get_if<DriveForce>(&problem_.drive)) {
      for (Index u = 0; u < forces_; ++u) matrix_(row, u) = weight(u) * force(u, kForward);
      right_(row) = -pull->force;
    } else {
      prescribe_moment(std::get<DriveTorque>(problem_.drive).torque, state);
    }
  }

  [[nodiscard]] Eigen::VectorXd solve() const {
    const Execution& execution = problem_.normal.coating.execution();
    return solve_dense(matrix_, right_, execution.threads, execution.watch);
  }

 private:
  [[nodiscard]] double force(Index unknown, Axis axis) const {
    return unknowns_[static_cast<std::size_t>(unknown)].force[axis];
  }
  [[nodiscard]] Index node(Index unknown) const {
    return carriers_.nodes()[unknowns_[static_cast<std::size_t>(unknown)].carrier];
  }
  [[nodiscard]] double weight(Index unknown) const { return carriers_.weight(node(unknown)); }

  void touch(Index row, Index node) {
    matrix_.row(row).head(forces_) = -scales_.normal * response_.displacement(node, kDown);
    matrix_(row, forces_) = -1.0;
    right_(row) = -scales_.normal * problem_.normal.drop[node];
  }

  void stick(Index row, Index node, Axis axis, double way) {
    matrix_.row(row).head(forces_) = scales_.tangential * response_.difference(node, axis);
    if (axis == kForward) matrix_(row, forces_ + 1) = 1.0;
    right_(row) = -scales_.tangential * way;
  }

  void slip(Index row, Index node, const TangentialState& state) {
    const auto& e = state.direction;
    const double kappa = state.rigidity * scales_.tangential;
    matrix_.row(row).head(forces_) =
        kappa * (e[0] * response_.difference(node, kSideways) - e[1] * response_.difference(node, kForward));
    for (Index u = 0; u < forces_; ++u) {
      if (this->node(u) != node) continue;
      matrix_(row, u) += (1.0 - state.rigidity) * (e[0] * force(u, kSideways) - e[1] * force(u, kForward));
    }
    matrix_(row, forces_ + 1) = -state.rigidity * e[1];
    right_(row) = -kappa * (e[0] * lateral_way_ - e[1] * problem_.ways[node]);
  }

  void prescribe_moment(double moment, const ContactSolution& state) {
    const Index row = forces_ + 1;
    const double arm = problem_.step;  // any length turns the condition into one on a force
    const double displaced = problem_.lever_arm == LeverArm::displaced ? 1.0 : 0.0;
    right_(row) = moment / arm;
    for (Index u = 0; u < forces_; ++u) {
      const Index i = node(u);
      const double x = problem_.x[i] + displaced * state.displacement(i, kForward);
      const double y = problem_.y[i] + state.displacement(i, kDown);
      matrix_(row, u) = weight(u) / arm * (y * force(u, kForward) - x * force(u, kDown));
    }
    for (const Index i : carriers_.nodes()) {
      const double factor = carriers_.weight(i) / arm;
      matrix_.row(row).head(forces_) +=
          factor * (state.force(i, kForward) * response_.displacement(i, kDown) -
                    displaced * state.force(i, kDown) * response_.displacement(i, kForward));
      right_(row) += factor * (state.force(i, kForward) * state.displacement(i, kDown) -
                               displaced * state.force(i, kDown) * state.displacement(i, kForward));
    }
  }

  const FrictionalContactProblem& problem_;
  ConditionScales scales_;
  const Carriers& carriers_;
  const std::vector<Unknown>& unknowns_;
  const Response& response_;
  double lateral_way_ = 0.0;
  Index forces_;
  Eigen::MatrixXd matrix_;
  Eigen::MatrixXd right_;
};

}  // namespace

ConditionScales condition_scales(const FrictionalContactProblem& problem) {
  const Index lowest = problem.shape.size() / 2;
  const std::array targets{lowest, lowest - problem.shape.theta_nodes};
  const Eigen::MatrixXd own = problem.normal.coating.block(targets, std::array{lowest}, kAllAxes);
  return {.normal = 1.0 / own(2 * kDown, kDown),
          .tangential = 1.0 / std::abs(own(2 * kForward, kForward) - own(2 * kForward + 1, kForward))};
}

void take_newton_step(const FrictionalContactProblem& problem, double friction, const ConditionScales& scales,
                      const ContactSets& sets, const ContactOptions& options, ContactSolution& state) {
  const Carriers carriers(problem, sets.contact);
  const std::vector<Unknown> unknowns = list_unknowns(carriers, sets, friction);
  if (static_cast<Index>(unknowns.size()) > options.max_unknowns) {
    throw std::length_error(std::to_string(sets.contact.size()) + " nodes in contact");
  }
  const Response response(problem, carriers, unknowns);
  System system(problem, scales, carriers, unknowns, response);
  system.add_contact_conditions(sets);
  system.balance_load();
  system.drive(state);
  const Eigen::VectorXd solution = system.solve();

  state.force.setZero();
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const Index node = carriers.nodes()[unknowns[u].carrier];
    const Eigen::Array3d force = solution[static_cast<Index>(u)] * unknowns[u].force.array();
    state.force.row(node) += force.transpose();
    if (carriers.weight(node) == 2.0) {
      state.force.row(carriers.mirror(node)) += (force * Eigen::Array3d(1.0, 1.0, -1.0)).transpose();
    }
  }
  const auto forces = static_cast<Index>(unknowns.size());
  state.penetration = solution[forces] / scales.normal;
  state.speed_ratio = solution[forces + 1] / (scales.tangential * problem.step);
}

}  // namespace viscoroll::detail

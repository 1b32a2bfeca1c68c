#include "transient/elastic_contact.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kFirstTolerance = 1e-4;  // of displacements relative to the penetration, in the first pass
constexpr double kTolerance = 1e-11;      // in all other passes
constexpr int kMaxPasses = 200;
constexpr int kMaxProducts = 400;  // of one pass

/// Largest number of contact nodes for which an inverse is kept. A larger one does not fit into the cache and takes
/// seconds to compute.
constexpr std::size_t kMaxKept = 1000;

/// Largest number of contact nodes that a matrix displaces in less time than the tables.
constexpr std::size_t kMaxDense = 150;

constexpr int kFewProducts = 12;  // of a pass with a current inverse; more show that it is outdated

/// Surface of a coating under normal forces; conjugate gradients solve the linear systems.
class CoatingSurface : public PressedSurface {
 public:
  CoatingSurface(const ElasticContactProblem& problem, ContactInverse& inverse)
      : problem_(problem), inverse_(inverse), weights_(problem.weights.reshaped()) {}

  /// Solve the equations of the nodes in contact. The iteration starts from the estimate of the preconditioner, and its
  /// steps keep the condition. If the condition contains forces and penetration, the matrix is that of the surface and
  /// of a spring of that stiffness behind it (docs/theory/ground.md, "Axle").
  void press(PressedNodes& contact, double tolerance) override {
    const auto& nodes = contact.nodes;
    is_kept_ = nodes.size() <= kMaxKept;
    if (is_kept_) inverse_.follow(problem_.surface, nodes);
    matrix_.resize(0, 0);
    if (nodes.size() <= kMaxDense) matrix_ = problem_.surface.normal_compliance(nodes, nodes);
    const VectorXd weight = weights_(nodes);
    const VectorXd gap = problem_.gap.reshaped()(nodes);
    const VectorXd by_weight = about_forces(weight);  // forces that displace all nodes equally
    VectorXd forces = is_kept_ ? about_forces(-gap) : VectorXd(contact.pressing(nodes));
    const ApproachCondition& condition = problem_.condition;
    const bool is_spring = condition.force != 0.0 && condition.penetration != 0.0;
    const double behind = is_spring ? 1.0 / condition.penetration : 0.0;
    const double stiffness = weight.dot(by_weight);
    // Penetration at which some forces, and those that it adds, fulfill the condition.
    const auto penetration_for = [&](double sum, double missing) {
      const double excess = missing - condition.force * (sum + condition.coasted * stiffness);
      return condition.coasted + excess / (condition.force * stiffness + condition.penetration);
    };
    double penetration = penetration_for(weight.dot(forces), condition.value);
    forces += penetration * by_weight;
    VectorXd residual = -(displacements(nodes, forces) + gap);
    const auto is_solved = [&] {
      const VectorXd violation = residual + penetration * weight;
      return violation.norm() <= tolerance * std::abs(penetration) * weight.norm();
    };
    VectorXd direction;
    double product = 0.0;
    int products = 0;
    for (; products < kMaxProducts && !is_solved(); ++products) {
      VectorXd step = about_forces(residual);
      const double missing =
          condition.penetration == 0.0 ? 0.0 : condition.value - condition.force * weight.dot(forces);
      penetration = penetration_for(weight.dot(step), missing);
      if (is_solved()) break;
      step += penetration * by_weight;
      const double next = step.dot(residual + penetration * weight) + behind * std::pow(weight.dot(step), 2);
      direction = products == 0 ? step : VectorXd(step + next / product * direction);
      product = next;
      const VectorXd change = displacements(nodes, direction);
      const double length = product / (direction.dot(change) + behind * std::pow(weight.dot(direction), 2));
      forces += length * direction;
      residual -= length * change;
    }
    if (products > kFewProducts) inverse_.forget();
    contact.penetration = penetration;
    contact.pressing.setZero();
    contact.pressing(nodes) = forces.array();
  }

  [[nodiscard]] ArrayXd height(const PressedNodes& contact) override {
    const bool is_known = pressing_.size() == contact.pressing.size() && (pressing_ == contact.pressing).all();
    if (!is_known) {
      const Index half_nodes = problem_.gap.rows();
      displace(contact.pressing, contact.nodes.front() / half_nodes, contact.nodes.back() / half_nodes);
    }
    return (problem_.gap + displaced_).reshaped();
  }

  [[nodiscard]] const ArrayXd& weights() const override { return weights_; }
  [[nodiscard]] double stiffness() const override { return 1.0 / problem_.surface.diagonal_compliance(); }

 private:
  /// Approximate forces for displacements. Without an inverse, the own compliance of each node serves, at the cost of
  /// some tens of products.
  [[nodiscard]] VectorXd about_forces(const VectorXd& displacements) const {
    return is_kept_ ? inverse_.times(displacements) : VectorXd(displacements / problem_.surface.diagonal_compliance());
  }

  /// Displacements of the nodes in contact, by a matrix, or by a product with the tables, which also gives those of the
  /// other nodes.
  [[nodiscard]] VectorXd displacements(const std::vector<Index>& nodes, const VectorXd& forces) {
    if (matrix_.rows() > 0) return matrix_ * forces;
    ArrayXd pressing = ArrayXd::Zero(problem_.gap.size());
    pressing(nodes) = forces.array();
    displace(pressing, nodes.front() / problem_.gap.rows(), nodes.back() / problem_.gap.rows());
    return displaced_.reshaped()(nodes);
  }

  /// @param[in] first,last rows with forces
  void displace(const ArrayXd& pressing, Index first, Index last) {
    pressing_ = pressing;
    displaced_ = problem_.surface.normal_displacement(
        pressing.matrix().reshaped(problem_.gap.rows(), problem_.gap.cols()), first, last);
  }

  const ElasticContactProblem& problem_;
  ContactInverse& inverse_;
  ArrayXd weights_;
  bool is_kept_ = false;    // whether the inverse is used for the present contact
  Eigen::MatrixXd matrix_;  // compliance between few nodes
  ArrayXd pressing_;        // forces of the last product
  HalfField displaced_;     // displacements of the last product
};

}  // namespace

PressedNodes solve_elastic_contact(const ElasticContactProblem& problem, const ArrayXd& guess,
                                   ContactInverse& inverse) {
  CoatingSurface surface(problem, inverse);
  PressedNodes start{.pressing = guess, .nodes = {}, .penetration = {}};
  for (Index node = 0; node < guess.size(); ++node) {
    if (start.pressing[node] > 0.0) start.nodes.push_back(node);
  }
  // With an inverse, full accuracy has no further cost.
  const double first_tolerance = start.nodes.size() <= kMaxKept ? kTolerance : kFirstTolerance;
  PressedNodes contact = find_contact(
      surface, std::move(start),
      {.max_passes = kMaxPasses, .first_tolerance = first_tolerance, .tightening = 0.0, .tolerance = kTolerance});
  if (!contact.converged) throw ConvergenceError("the set of nodes in contact did not converge", kMaxPasses, 1.0);
  return contact;
}

}  // namespace viscoroll::detail

#include "transient/elastic_contact.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kFirstTolerance = 1e-4;  // of residuals as displacements per penetration, in the first pass
constexpr double kTolerance = 1e-11;      // and in all others
constexpr int kMostPasses = 200;
constexpr int kMostProducts = 400;  // of a pass

/// Nodes in contact up to which a factor that is kept pays: with 100 of a wheel steps take half the time, with 200 the
/// same, with 400 a third more; with 10 000 products take 9 s for a first contact, a factor over a minute.
constexpr std::size_t kMostDense = 300;

/// How the nodes in contact displace each other, and about which forces do that.
class NodeCompliance {
 public:
  virtual ~NodeCompliance() = default;
  [[nodiscard]] virtual VectorXd displacements(const VectorXd& forces) const = 0;
  [[nodiscard]] virtual VectorXd about_forces(const VectorXd& displacements) const = 0;
};

/// By a matrix, and the factor of that of an earlier contact.
class DenseCompliance final : public NodeCompliance {
 public:
  DenseCompliance(const StepOperator& surface, const std::vector<Index>& nodes, ContactInverse& inverse)
      : matrix_(surface.normal_compliance(nodes)), inverse_(inverse) {
    inverse_.follow(nodes, matrix_);
  }

  [[nodiscard]] VectorXd displacements(const VectorXd& forces) const override {
    return matrix_.selfadjointView<Eigen::Lower>() * forces;
  }
  [[nodiscard]] VectorXd about_forces(const VectorXd& displacements) const override {
    return inverse_.times(displacements);
  }

 private:
  Eigen::MatrixXd matrix_;
  ContactInverse& inverse_;
};

/// By products with the tables: the forces of each node alone tell its displacement well enough for some tens of them,
/// as thin layers do.
class ComplianceByProducts final : public NodeCompliance {
 public:
  ComplianceByProducts(const ElasticContactProblem& problem, const std::vector<Index>& nodes)
      : problem_(problem), nodes_(nodes) {}

  [[nodiscard]] VectorXd displacements(const VectorXd& forces) const override {
    const Index half_nodes = problem_.gap.rows();
    HalfField pressing = HalfField::Zero(half_nodes, problem_.gap.cols());
    pressing.reshaped()(nodes_) = forces;
    const HalfField displaced =
        problem_.surface.normal_displacement(pressing, nodes_.front() / half_nodes, nodes_.back() / half_nodes);
    return displaced.reshaped()(nodes_);
  }
  [[nodiscard]] VectorXd about_forces(const VectorXd& displacements) const override {
    return displacements / problem_.surface.own_compliance();
  }

 private:
  const ElasticContactProblem& problem_;
  const std::vector<Index>& nodes_;
};

/// A coating over the plane: conjugate gradients solve the systems.
class CoatingSurface : public PressedSurface {
 public:
  CoatingSurface(const ElasticContactProblem& problem, ContactInverse& inverse)
      : problem_(problem), inverse_(inverse), weights_(problem.weights.reshaped()) {}

  /// The preconditioner keeps the sum of forces as it is.
  void press(PressedNodes& contact, double tolerance) override {
    const auto& nodes = contact.nodes;
    const std::unique_ptr<const NodeCompliance> compliance = compliance_of(nodes);
    const VectorXd weight = weights_(nodes);
    const VectorXd by_weight = compliance->about_forces(weight);  // forces that displace all nodes alike
    VectorXd forces = contact.pressing(nodes);
    forces += by_weight * ((problem_.load - weight.dot(forces)) / weight.dot(by_weight));
    VectorXd residual = -(compliance->displacements(forces) + problem_.gap.reshaped()(nodes));
    VectorXd direction;
    double penetration = 0.0;
    double product = 0.0;
    for (int i = 0; i < kMostProducts; ++i) {
      VectorXd step = compliance->about_forces(residual);
      penetration = -weight.dot(step) / weight.dot(by_weight);
      const VectorXd violation = residual + penetration * weight;
      if (violation.norm() <= tolerance * std::abs(penetration) * weight.norm()) break;
      step += penetration * by_weight;
      const double next = violation.dot(step);
      direction = i == 0 ? step : VectorXd(step + next / product * direction);
      product = next;
      const VectorXd change = compliance->displacements(direction);
      const double length = product / direction.dot(change);
      forces += length * direction;
      residual -= length * change;
    }
    contact.penetration = penetration;
    contact.pressing.setZero();
    contact.pressing(nodes) = forces.array();
  }

  [[nodiscard]] ArrayXd height(const PressedNodes& contact) override {
    const Index half_nodes = problem_.gap.rows();
    const Index first = contact.nodes.front() / half_nodes;
    const Index last = contact.nodes.back() / half_nodes;
    const HalfField pressing = contact.pressing.matrix().reshaped(half_nodes, problem_.gap.cols());
    return (problem_.gap + problem_.surface.normal_displacement(pressing, first, last)).reshaped();
  }

  [[nodiscard]] const ArrayXd& weights() const override { return weights_; }
  [[nodiscard]] double stiffness() const override { return 1.0 / problem_.surface.own_compliance(); }

 private:
  [[nodiscard]] std::unique_ptr<const NodeCompliance> compliance_of(const std::vector<Index>& nodes) {
    if (nodes.size() > kMostDense) return std::make_unique<ComplianceByProducts>(problem_, nodes);
    return std::make_unique<DenseCompliance>(problem_.surface, nodes, inverse_);
  }

  const ElasticContactProblem& problem_;
  ContactInverse& inverse_;
  ArrayXd weights_;
};

}  // namespace

void ContactInverse::follow(const std::vector<Index>& nodes, const Eigen::MatrixXd& compliance) {
  constexpr std::size_t kChanged = 3;  // one node in so many
  if (factor_) {
    std::vector<Index> common;
    std::ranges::set_intersection(nodes, factor_->nodes, std::back_inserter(common));
    const std::size_t changed = nodes.size() + factor_->nodes.size() - 2 * common.size();
    if (kChanged * changed > nodes.size()) factor_.reset();
  }
  if (!factor_) {
    factor_ = std::make_shared<const Factor>(nodes, compliance.selfadjointView<Eigen::Lower>().llt().matrixL(),
                                             compliance(0, 0));
  }
  places_.clear();
  for (const Index node : nodes) {
    const auto place = std::ranges::lower_bound(factor_->nodes, node);
    const bool found = place != factor_->nodes.end() && *place == node;
    places_.push_back(found ? place - factor_->nodes.begin() : -1);
  }
}

VectorXd ContactInverse::times(const VectorXd& displacement) const {
  VectorXd known = VectorXd::Zero(static_cast<Index>(factor_->nodes.size()));
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i] >= 0) known[places_[i]] = displacement[static_cast<Index>(i)];
  }
  factor_->lower.triangularView<Eigen::Lower>().solveInPlace(known);
  factor_->lower.transpose().triangularView<Eigen::Upper>().solveInPlace(known);
  VectorXd forces(displacement.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto node = static_cast<Index>(i);
    forces[node] = places_[i] >= 0 ? known[places_[i]] : displacement[node] / factor_->own_compliance;
  }
  return forces;
}

void ContactInverse::write(NumberWriter& numbers) const {
  numbers.put(factor_ ? factor_->nodes : std::vector<Index>{});
  if (!factor_) return;
  numbers.put(factor_->lower);
  numbers.put(factor_->own_compliance);
}

void ContactInverse::read(NumberReader& numbers, Index last) {
  factor_.reset();
  std::vector<Index> nodes = numbers.indices(last);
  if (nodes.empty()) return;
  const auto size = static_cast<Index>(nodes.size());
  Eigen::MatrixXd lower = numbers.matrix();
  NumberReader::require(lower.rows() == size && lower.cols() == size && std::ranges::is_sorted(nodes));
  factor_ = std::make_shared<const Factor>(std::move(nodes), std::move(lower), numbers.get());
}

PressedNodes solve_elastic_contact(const ElasticContactProblem& problem, const ArrayXd& guess,
                                   ContactInverse& inverse) {
  CoatingSurface surface(problem, inverse);
  PressedNodes start{.pressing = guess, .nodes = {}, .penetration = {}};
  for (Index node = 0; node < guess.size(); ++node) {
    if (start.pressing[node] > 0.0) start.nodes.push_back(node);
  }
  PressedNodes contact = find_contact(
      surface, std::move(start),
      {.most_passes = kMostPasses, .first_tolerance = kFirstTolerance, .tightening = 0.0, .tolerance = kTolerance});
  if (!contact.converged) throw ConvergenceError("the nodes in contact did not settle", kMostPasses, 1.0);
  return contact;
}

}  // namespace viscoroll::detail

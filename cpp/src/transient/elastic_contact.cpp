#include "transient/elastic_contact.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Residuals of the first and of the last pass, as displacements per penetration.
constexpr double kFirstTolerance = 1e-4;
constexpr double kTolerance = 1e-11;
constexpr int kMostPasses = 200;
/// Passes in which nodes join while others leave; later, nodes join only when none leaves.
constexpr int kExchanges = 8;
constexpr int kMostProducts = 400;  // of a pass
constexpr double kPredictionStiffness = 0.3;

class ElasticContactSolver {
 public:
  ElasticContactSolver(const ElasticContactProblem& problem, HalfField guess, ContactInverse& inverse)
      : problem_(problem), inverse_(inverse), pressing_(std::move(guess)) {}

  [[nodiscard]] ElasticContact solve() {
    double tolerance = kFirstTolerance;
    predict_nodes();
    for (int pass = 0; pass < kMostPasses; ++pass) {
      find_nodes();
      if (nodes_.empty()) throw ConvergenceError("no node carries load", pass, 1.0);
      press(tolerance);
      const bool left = drop_tensile();
      const bool joined = (pass < kExchanges || !left) && add_overclosed(tolerance);
      if (!left && !joined && tolerance == kTolerance) return result();
      tolerance = kTolerance;
    }
    throw ConvergenceError("the nodes in contact did not settle", kMostPasses, 1.0);
  }

 private:
  /// Who touches, by the forces of the guess and the gaps that they leave.
  void predict_nodes() {
    Index first = 0;
    Index last = pressing_.cols() - 1;
    while (first < last && (pressing_.col(first).array() == 0.0).all()) ++first;
    while (first < last && (pressing_.col(last).array() == 0.0).all()) --last;
    HalfField gap = problem_.displacement(pressing_, first, last) + problem_.gap;
    const double depth = gap.cwiseProduct(pressing_).sum() / problem_.weights.cwiseProduct(pressing_).sum();
    gap -= depth * problem_.weights;
    const double stiffness = kPredictionStiffness * problem_.stiffness;
    HalfField predicted = (pressing_ - stiffness * gap).cwiseMax(0.0);
    if ((predicted.array() > 0.0).any()) pressing_ = std::move(predicted);
  }

  /// Nodes with a force, or with the smallest of forces, which marks those that join.
  void find_nodes() {
    nodes_.clear();
    for (Index node = 0; node < pressing_.size(); ++node) {
      if (pressing_.data()[node] > 0.0) nodes_.push_back(node);
    }
    compliance_ = problem_.compliance(nodes_);
    inverse_.follow(nodes_, compliance_);
    weight_ = problem_.weights.reshaped()(nodes_);
    by_weight_ = inverse_.times(weight_);
  }

  [[nodiscard]] VectorXd times(const VectorXd& forces) const {
    return compliance_.selfadjointView<Eigen::Lower>() * forces;
  }

  /// Conjugate gradients for the nodes in contact; the preconditioner keeps the sum of forces as it is.
  void press(double tolerance) {
    VectorXd forces = pressing_.reshaped()(nodes_);
    forces += by_weight_ * ((problem_.load - weight_.dot(forces)) / weight_.dot(by_weight_));
    VectorXd residual = -(times(forces) + problem_.gap.reshaped()(nodes_));
    VectorXd direction;
    double product = 0.0;
    for (int i = 0; i < kMostProducts; ++i) {
      VectorXd step = inverse_.times(residual);
      penetration_ = -weight_.dot(step) / weight_.dot(by_weight_);
      const VectorXd violation = residual + penetration_ * weight_;
      if (violation.norm() <= tolerance * std::abs(penetration_) * weight_.norm()) break;
      step += penetration_ * by_weight_;
      const double next = violation.dot(step);
      direction = i == 0 ? step : VectorXd(step + next / product * direction);
      product = next;
      const VectorXd change = times(direction);
      const double length = product / direction.dot(change);
      forces += length * direction;
      residual -= length * change;
    }
    pressing_.setZero();
    pressing_.reshaped()(nodes_) = forces;
    const Index height = pressing_.rows();
    displacement_ = problem_.displacement(pressing_, nodes_.front() / height, nodes_.back() / height);
  }

  bool drop_tensile() {
    const bool left = (pressing_.reshaped()(nodes_).array() <= 0.0).any();
    pressing_ = pressing_.cwiseMax(0.0);
    return left;
  }

  bool add_overclosed(double tolerance) {
    const double least = 1e-12 * problem_.load;
    const double slack = 10.0 * tolerance * std::abs(penetration_);
    const HalfField gap = displacement_ + problem_.gap - penetration_ * problem_.weights;
    std::vector<Index> added;
    for (Index node = 0; node < gap.size(); ++node) {
      if (gap.data()[node] < -slack && !std::ranges::binary_search(nodes_, node)) added.push_back(node);
    }
    for (const Index node : added) pressing_.data()[node] = least;
    return !added.empty();
  }

  [[nodiscard]] ElasticContact result() {
    return {.pressing = std::move(pressing_), .penetration = penetration_, .nodes = std::move(nodes_)};
  }

  const ElasticContactProblem& problem_;
  ContactInverse& inverse_;
  HalfField pressing_;
  HalfField displacement_;
  double penetration_ = 0.0;
  std::vector<Index> nodes_;
  Eigen::MatrixXd compliance_;
  VectorXd weight_;
  VectorXd by_weight_;  // forces that displace all nodes alike
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
    factor_ = std::make_shared<const Factor>(nodes, compliance.selfadjointView<Eigen::Lower>().llt(), compliance(0, 0));
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
  factor_->cholesky.solveInPlace(known);
  VectorXd forces(displacement.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto node = static_cast<Index>(i);
    forces[node] = places_[i] >= 0 ? known[places_[i]] : displacement[node] / factor_->own_compliance;
  }
  return forces;
}

ElasticContact solve_elastic_contact(const ElasticContactProblem& problem, const HalfField& guess,
                                     ContactInverse& inverse) {
  return ElasticContactSolver(problem, guess, inverse).solve();
}

}  // namespace viscoroll::detail

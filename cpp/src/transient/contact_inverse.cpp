#include "transient/contact_inverse.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Largest relative change of the shares of the bodies for which the inverse is kept; Newton steps correct the
/// difference.
constexpr double kNearlySame = 1e-2;

double sum(const std::vector<double>& shares) { return std::accumulate(shares.begin(), shares.end(), 0.0); }

MatrixXd normal_compliance(const StepOperator& surface, const std::vector<Index>& displaced,
                           const std::vector<Index>& loaded) {
  return surface.normal_compliance(displaced, loaded);
}

/// Compliance between nodes. Nodes on the middle line do not move sideways, so that any sideways compliance serves
/// there.
MatrixXd compliance(const StepOperator& surface, const std::vector<Index>& displaced,
                    const std::vector<Index>& loaded) {
  MatrixXd matrix = surface.compliance(displaced, loaded);
  if (displaced != loaded) return matrix;
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    const auto sideways = static_cast<Index>(3 * i + 2);
    if (loaded[i] % surface.half_nodes() == 0) matrix(sideways, sideways) = surface.diagonal_compliance();
  }
  return matrix;
}

}  // namespace

ContactStiffness::ContactStiffness() : KeptInverse(3, compliance, kNearlySame) {}

ContactInverse::ContactInverse() : KeptInverse(1, normal_compliance, std::numeric_limits<double>::infinity()) {}

void ContactInverse::follow(const StepOperator& surface, const std::vector<Index>& contact) {
  cover(surface, contact);
  scale_ = sum(shares()) / sum(surface.shares());
  touching_.assign(contact.size(), 0);
  apart_.clear();
  for (std::size_t place = 0; place < nodes().size(); ++place) {
    const auto found = std::ranges::lower_bound(contact, nodes()[place]);
    if (found != contact.end() && *found == nodes()[place]) {
      touching_[static_cast<std::size_t>(found - contact.begin())] = static_cast<Index>(place);
    } else {
      apart_.push_back(static_cast<Index>(place));
    }
  }
  reactions_.compute(matrix()(apart_, apart_));
}

VectorXd ContactInverse::times(const VectorXd& displacement) const {
  VectorXd displaced = VectorXd::Zero(matrix().rows());
  displaced(touching_) = displacement;
  VectorXd forces = matrix().selfadjointView<Eigen::Lower>() * displaced;
  if (!apart_.empty()) {
    const VectorXd undone = reactions_.solve(forces(apart_));
    for (std::size_t i = 0; i < apart_.size(); ++i) forces -= undone[static_cast<Index>(i)] * matrix().col(apart_[i]);
  }
  return scale_ * forces(touching_);
}

}  // namespace viscoroll::detail

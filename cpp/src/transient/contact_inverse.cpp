#include "transient/contact_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Largest number of nodes of the inverse per node in contact. Nodes that join and leave at the edge while a spacing
/// passes stay in the inverse.
constexpr double kMaxNodeRatio = 1.5;

/// Number of unknowns that are added at once, for fast products.
constexpr Index kTogether = 48;

bool are_near(const std::vector<double>& a, const std::vector<double>& b, double max_change) {
  return std::ranges::equal(a, b, [&](double x, double y) { return std::abs(x - y) <= max_change * std::abs(y); });
}

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

bool KeptInverse::cover(const StepOperator& surface, const std::vector<Index>& contact) {
  if (inverse_ && !are_near(surface.shares(), inverse_->shares, max_change_)) inverse_.reset();
  std::vector<Index> known;
  if (inverse_) known = inverse_->nodes;
  std::ranges::sort(known);
  std::vector<Index> missing;
  std::ranges::set_difference(contact, known, std::back_inserter(missing));
  const auto count = static_cast<double>(known.size() + missing.size());
  const bool is_wide = count > kMaxNodeRatio * static_cast<double>(contact.size());
  if (missing.empty() && !is_wide) return false;
  Inverse inverse{.nodes = {}, .matrix = {}, .shares = surface.shares()};
  if (is_wide) {
    missing = contact;
  } else if (inverse_) {
    inverse = *inverse_;
  }
  const StepOperator bordered = surface.with_shares(inverse.shares);
  const auto together = static_cast<std::size_t>(kTogether / components_);
  for (std::size_t first = 0; first < missing.size(); first += together) {
    surface.checkpoint();
    const std::size_t last = std::min(first + together, missing.size());
    const std::vector<Index> added{missing.begin() + static_cast<Index>(first),
                                   missing.begin() + static_cast<Index>(last)};
    inverse.matrix = bordered_inverse(inverse.matrix, compliance_(bordered, inverse.nodes, added),
                                      compliance_(bordered, added, added));
    inverse.nodes.insert(inverse.nodes.end(), added.begin(), added.end());
  }
  inverse_ = std::make_shared<const Inverse>(std::move(inverse));
  return true;
}

void KeptInverse::write(NumberWriter& numbers) const {
  numbers.put(inverse_ ? inverse_->nodes : std::vector<Index>{});
  if (!inverse_) return;
  numbers.put(inverse_->matrix);
  numbers.put(inverse_->shares);
}

void KeptInverse::read(NumberReader& numbers, Index last) {
  inverse_.reset();
  std::vector<Index> nodes = numbers.indices(last);
  if (nodes.empty()) return;
  const Index size = components_ * static_cast<Index>(nodes.size());
  MatrixXd matrix = numbers.matrix();
  NumberReader::require(matrix.rows() == size && matrix.cols() == size);
  inverse_ = std::make_shared<const Inverse>(std::move(nodes), std::move(matrix), numbers.values());
}

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

#include "transient/contact_inverse.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <iterator>
#include <utility>

#include "transient/bordered_inverse.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Nodes that may be in it, per node in contact: who comes and goes at the edge while a spacing passes stays in it.
constexpr double kMostNodes = 1.3;

/// Nodes that are added at once, for products to be quick.
constexpr std::size_t kTogether = 32;

}  // namespace

void ContactInverse::cover(const StepOperator& surface, const std::vector<Index>& contact) {
  std::vector<Index> known;
  if (inverse_) known = inverse_->nodes;
  std::ranges::sort(known);
  std::vector<Index> missing;
  std::ranges::set_difference(contact, known, std::back_inserter(missing));
  const auto count = static_cast<double>(known.size() + missing.size());
  const bool is_wide = count > kMostNodes * static_cast<double>(contact.size());
  if (missing.empty() && !is_wide) return;
  Inverse inverse;
  if (is_wide) {
    missing = contact;
  } else if (inverse_) {
    inverse = *inverse_;
  }
  for (std::size_t first = 0; first < missing.size(); first += kTogether) {
    surface.checkpoint();
    const std::size_t last = std::min(first + kTogether, missing.size());
    const std::vector<Index> added{missing.begin() + static_cast<Index>(first),
                                   missing.begin() + static_cast<Index>(last)};
    inverse.matrix = bordered_inverse(inverse.matrix, surface.normal_compliance(inverse.nodes, added),
                                      surface.normal_compliance(added, added));
    inverse.nodes.insert(inverse.nodes.end(), added.begin(), added.end());
  }
  inverse_ = std::make_shared<const Inverse>(std::move(inverse));
}

void ContactInverse::follow(const StepOperator& surface, const std::vector<Index>& contact) {
  cover(surface, contact);
  touching_.assign(contact.size(), 0);
  apart_.clear();
  for (std::size_t place = 0; place < inverse_->nodes.size(); ++place) {
    const auto found = std::ranges::lower_bound(contact, inverse_->nodes[place]);
    if (found != contact.end() && *found == inverse_->nodes[place]) {
      touching_[static_cast<std::size_t>(found - contact.begin())] = static_cast<Index>(place);
    } else {
      apart_.push_back(static_cast<Index>(place));
    }
  }
  lower_ = MatrixXd(inverse_->matrix(apart_, apart_)).llt().matrixL();
}

VectorXd ContactInverse::times(const VectorXd& displacement) const {
  const MatrixXd& matrix = inverse_->matrix;
  VectorXd displaced = VectorXd::Zero(matrix.rows());
  displaced(touching_) = displacement;
  VectorXd forces = matrix.selfadjointView<Eigen::Lower>() * displaced;
  if (!apart_.empty()) {
    VectorXd undone = forces(apart_);
    lower_.triangularView<Eigen::Lower>().solveInPlace(undone);
    lower_.transpose().triangularView<Eigen::Upper>().solveInPlace(undone);
    for (std::size_t i = 0; i < apart_.size(); ++i) forces -= undone[static_cast<Index>(i)] * matrix.col(apart_[i]);
  }
  return forces(touching_);
}

void ContactInverse::write(NumberWriter& numbers) const {
  numbers.put(inverse_ ? inverse_->nodes : std::vector<Index>{});
  if (inverse_) numbers.put(inverse_->matrix);
}

void ContactInverse::read(NumberReader& numbers, Index last) {
  inverse_.reset();
  std::vector<Index> nodes = numbers.indices(last);
  if (nodes.empty()) return;
  const auto size = static_cast<Index>(nodes.size());
  MatrixXd matrix = numbers.matrix();
  NumberReader::require(matrix.rows() == size && matrix.cols() == size);
  inverse_ = std::make_shared<const Inverse>(std::move(nodes), std::move(matrix));
}

}  // namespace viscoroll::detail

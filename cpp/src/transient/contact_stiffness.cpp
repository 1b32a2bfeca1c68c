#include "transient/contact_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "dense_products.hpp"
#include "dense_solvers.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Nodes that may be in it, per node in contact: who comes and goes at the edge while a spacing passes stays in it.
constexpr double kMostNodes = 1.5;

/// By how much shares may differ from those that the inverse was begun with: what is left, steps correct.
constexpr double kNearlySame = 1e-2;

bool are_near(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) <= kNearlySame * std::abs(y); });
}

/// Nodes that are added at once, for products to be quick.
constexpr std::size_t kTogether = 16;

}  // namespace

bool ContactStiffness::cover(const StepOperator& surface, const std::vector<Index>& contact) {
  std::vector<double> shares = surface.shares();
  if (inverse_ && !are_near(shares, inverse_->shares)) inverse_.reset();
  std::vector<Index> known;
  if (inverse_) known = inverse_->nodes;
  std::ranges::sort(known);
  std::vector<Index> missing;
  std::ranges::set_difference(contact, known, std::back_inserter(missing));
  const auto count = static_cast<double>(known.size() + missing.size());
  const bool is_wide = count > kMostNodes * static_cast<double>(contact.size());
  if (missing.empty() && !is_wide) return false;
  Inverse inverse{.nodes = {}, .matrix = {}, .shares = std::move(shares)};
  if (is_wide) {
    missing = contact;
  } else if (inverse_) {
    inverse = *inverse_;
  }
  for (std::size_t first = 0; first < missing.size(); first += kTogether) {
    surface.checkpoint();
    const std::size_t last = std::min(first + kTogether, missing.size());
    inverse = bordered(inverse, surface,
                       {missing.begin() + static_cast<Index>(first), missing.begin() + static_cast<Index>(last)});
  }
  inverse_ = std::make_shared<const Inverse>(std::move(inverse));
  return true;
}

ContactStiffness::Inverse ContactStiffness::bordered(const Inverse& inverse, const StepOperator& surface,
                                                     const std::vector<Index>& added) {
  const Index before = inverse.matrix.rows();
  const auto size = static_cast<Index>(3 * added.size());
  const MatrixXd beside = surface.compliance(inverse.nodes, added);
  MatrixXd complement = surface.compliance(added, added);
  for (std::size_t i = 0; i < added.size(); ++i) {
    const auto sideways = static_cast<Index>(3 * i + 2);  // nothing moves that way in the middle
    if (added[i] % surface.half_nodes() == 0) complement(sideways, sideways) = surface.own_compliance();
  }
  const MatrixXd moved = product(inverse.matrix, beside);
  complement -= product(moved.transpose(), beside);
  Inverse wide{.nodes = inverse.nodes, .matrix = MatrixXd(before + size, before + size), .shares = inverse.shares};
  wide.nodes.insert(wide.nodes.end(), added.begin(), added.end());
  const MatrixXd corner = dense_inverse(complement);
  const MatrixXd edge = product(moved, corner);
  wide.matrix.topLeftCorner(before, before) = inverse.matrix;
  add_product(edge, moved.transpose(), wide.matrix.topLeftCorner(before, before));
  wide.matrix.topRightCorner(before, size) = -edge;
  wide.matrix.bottomLeftCorner(size, before) = -edge.transpose();
  wide.matrix.bottomRightCorner(size, size) = corner;
  return wide;
}

void ContactStiffness::write(NumberWriter& numbers) const {
  numbers.put(inverse_ ? inverse_->nodes : std::vector<Index>{});
  if (!inverse_) return;
  numbers.put(inverse_->matrix);
  numbers.put(inverse_->shares);
}

void ContactStiffness::read(NumberReader& numbers, Index last) {
  inverse_.reset();
  std::vector<Index> nodes = numbers.indices(last);
  if (nodes.empty()) return;
  const auto size = static_cast<Index>(3 * nodes.size());
  MatrixXd matrix = numbers.matrix();
  NumberReader::require(matrix.rows() == size && matrix.cols() == size);
  inverse_ = std::make_shared<const Inverse>(std::move(nodes), std::move(matrix), numbers.values());
}

}  // namespace viscoroll::detail

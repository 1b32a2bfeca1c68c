#include "transient/kept_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "transient/bordered_inverse.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Largest number of nodes of the inverse per node in contact. Nodes that join and leave at the edge while a spacing
/// passes stay in the inverse.
constexpr double kMaxNodeRatio = 1.5;

/// Number of unknowns that are added at once, for fast products.
constexpr Index kTogether = 48;

bool are_near(const std::vector<double>& a, const std::vector<double>& b, double max_change) {
  return std::ranges::equal(a, b, [&](double x, double y) { return std::abs(x - y) <= max_change * std::abs(y); });
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

}  // namespace viscoroll::detail

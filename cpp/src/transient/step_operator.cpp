#include "transient/step_operator.hpp"

#include <span>

namespace viscoroll::detail {
namespace {

using Eigen::Index;

/// The sum of what each part gives; of a single part with a share of 1 nothing is changed.
template <class Field, class Parts>
Field summed(const Parts& parts, const auto& field) {
  Field sum = field(*parts.front().tables);
  if (parts.front().share != 1.0) sum *= parts.front().share;
  for (const auto& [share, tables] : std::span(parts).subspan(1)) sum += share * field(*tables);
  return sum;
}

}  // namespace

double StepOperator::own_compliance() const {
  double sum = 0.0;
  for (const auto& [share, tables] : parts_) sum += share * tables->own_compliance();
  return sum;
}

Eigen::MatrixXd StepOperator::compliance(const std::vector<Index>& nodes,
                                         const std::array<HalfField, 3>& direction) const {
  return summed<Eigen::MatrixXd>(parts_,
                                 [&](const MirroredTables& tables) { return tables.compliance(nodes, direction); });
}

HalfField StepOperator::displacement(const HalfField& loads, Index first, Index last) const {
  return summed<HalfField>(parts_,
                           [&](const MirroredTables& tables) { return tables.displacement(loads, first, last); });
}

}  // namespace viscoroll::detail

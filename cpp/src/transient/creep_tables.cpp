#include "transient/creep_tables.hpp"

namespace viscoroll::detail {

double CreepTables::diagonal_compliance() const {
  double sum = 0.0;
  for (const MirroredTables& tables : *tables_) sum += tables.diagonal_compliance();
  return sum;
}

InstantaneousTables CreepTables::instantaneous(std::vector<double> parts,
                                               const std::function<void()>& checkpoint) const {
  if (count() == 1) {
    const double share = parts.front();
    return {.parts = std::move(parts), .share = share, .tables = {tables_, &tables_->front()}};
  }
  auto tables = std::make_shared<const MirroredTables>(MirroredTables::sum_of(*tables_, parts, checkpoint));
  return {.parts = std::move(parts), .share = 1.0, .tables = std::move(tables)};
}

}  // namespace viscoroll::detail

#include "surface/sum_operator.hpp"

#include <algorithm>
#include <utility>

namespace viscoroll::detail {
namespace {

/// Return first + sign * second, for the offsets that both tables contain.
std::shared_ptr<const Table> sum_of(const Table& first, const Table& second, double sign) {
  const int phi_reach = std::min(first.phi_reach(), second.phi_reach());
  const int theta_reach = std::min(first.theta_reach(), second.theta_reach());
  auto sum = std::make_shared<Table>(phi_reach, theta_reach, first.mirror() < 0.0);
  for (int j = -phi_reach; j <= phi_reach; ++j) {
    const auto row = sum->row(j);
    for (std::size_t l = 0; l < row.size(); ++l) row[l] = first.row(j)[l] + sign * second.row(j)[l];
  }
  return sum;
}

/// Sign of an entry of the counterbody in the sum of compliances. The compliances between normal and tangential
/// directions are subtracted, because the shear tractions on the two bodies have opposite signs in their own frames.
double sign_of(std::size_t entry) {
  const auto mixed = static_cast<Entry>(entry);
  return mixed == Entry::rphi || mixed == Entry::rtheta ? -1.0 : 1.0;
}

}  // namespace

SumOperator::SumOperator(std::shared_ptr<const SurfaceOperator> rolling,
                         std::shared_ptr<const SurfaceOperator> counterbody)
    : rolling_(std::move(rolling)), counterbody_(std::move(counterbody)), local_(rolling_->local()) {
  const auto& counterbody_tables = counterbody_->local().tables;
  for (std::size_t entry = 0; entry < counterbody_tables.size(); ++entry) {
    auto& table = local_.tables[entry];
    if (table) table = sum_of(*table, *counterbody_tables[entry], sign_of(entry));
  }
}

std::optional<Eigen::MatrixXd> SumOperator::normal_compliance(const std::vector<Eigen::Index>& displaced,
                                                              const std::vector<Eigen::Index>& loaded) const {
  auto sum = rolling_->normal_compliance(displaced, loaded);
  const auto other = counterbody_->normal_compliance(displaced, loaded);
  if (!sum || !other) return std::nullopt;
  *sum += *other;
  return sum;
}

}  // namespace viscoroll::detail

#include "influence/table.hpp"

#include <algorithm>

namespace viscoroll::detail {

void add(double factor, const Table& table, Table& sum) {
  for (int j = -sum.phi_reach(); j <= sum.phi_reach(); ++j) {
    std::ranges::transform(table.row(j), sum.row(j), sum.row(j).begin(),
                           [factor](double value, double before) { return before + factor * value; });
  }
}

Table widened(const Table& fine, int stride, double downstream) {
  const int aside = fine.theta_reach() == 0 ? 0 : 1;
  const std::array<double, 3> share = aside == 0 ? std::array{0.0, 1.0, 0.0} : std::array{0.25, 0.5, 0.25};
  const std::array<double, 4> phi_share = wide_patch_shares(downstream);
  const int last = downstream > 0.0 ? 2 : 1;
  Table coarse((fine.phi_reach() - last) / stride, (fine.theta_reach() - aside) / stride, fine.mirror() < 0.0);
  for (int j = -coarse.phi_reach(); j <= coarse.phi_reach(); ++j) {
    const auto row = coarse.row(j);
    for (int l = 0; l <= coarse.theta_reach(); ++l) {
      double sum = 0.0;
      for (int dj = -1; dj <= last; ++dj) {
        for (int dl = -aside; dl <= aside; ++dl) {
          sum += phi_share[static_cast<std::size_t>(dj + 1)] * share[static_cast<std::size_t>(dl + 1)] *
                 fine(stride * j + dj, stride * l + dl);
        }
      }
      row[static_cast<std::size_t>(l)] = sum;
    }
  }
  return coarse;
}

}  // namespace viscoroll::detail

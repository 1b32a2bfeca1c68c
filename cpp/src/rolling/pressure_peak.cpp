#include "rolling/pressure_peak.hpp"

#include <algorithm>

namespace viscoroll::detail {

double unresolved_peak(const Eigen::Ref<const Eigen::ArrayXd>& pressure, const std::vector<Eigen::Index>& contact,
                       Eigen::Index stride) {
  const double largest = pressure.maxCoeff();
  double ahead = largest;
  for (const Eigen::Index node : contact) {
    const double behind = node + stride < pressure.size() ? pressure[node + stride] : 0.0;
    ahead = std::max(ahead, 2.0 * pressure[node] - behind);
  }
  return largest > 0.0 ? ahead / largest - 1.0 : 0.0;
}

}  // namespace viscoroll::detail

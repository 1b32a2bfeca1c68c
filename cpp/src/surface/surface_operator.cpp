#include "surface/surface_operator.hpp"

#include <cmath>
#include <numeric>

namespace viscoroll::detail {

Eigen::ArrayXd SurfaceOperator::normal_displacement(const Eigen::ArrayXd& pressing) const {
  std::vector<Eigen::Index> all(static_cast<std::size_t>(pressing.size()));
  std::iota(all.begin(), all.end(), 0);
  return normal_displacement(NodeRows(shape(), all), pressing.matrix()).array();
}

double SurfaceOperator::normal_stiffness() const { return 1.0 / local().table(Entry::rr)(0, 0); }

double SurfaceOperator::slip_stiffness() const {
  const Table& forward = local().table(Entry::phiphi);
  return 1.0 / std::abs(forward(0, 0) - forward(-1, 0));
}

}  // namespace viscoroll::detail

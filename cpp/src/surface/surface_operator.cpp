#include "surface/surface_operator.hpp"

#include <cmath>
#include <numeric>

#include "surface/patch_slope.hpp"

namespace viscoroll::detail {

Displacements SurfaceOperator::displacements(const VectorField& force) const {
  return deforming() == Deforming::counterpart ? Displacements{.rolling = {}, .counterpart = displacement(force)}
                                               : Displacements{.rolling = displacement(force), .counterpart = {}};
}

double SurfaceOperator::pushback(const VectorField& force) const {
  if (deforming() != Deforming::counterpart) return 0.0;
  const Eigen::Index row = shape().theta_nodes;
  const Eigen::ArrayXd depth = at_nodes(-displacement(force).col(kDown), row, collocation());
  return -(force.col(kDown) * patch_slope(depth, row, row_distance())).sum();
}

Losses SurfaceOperator::losses(double lost) const {
  return deforming() == Deforming::counterpart ? Losses{.counterpart = lost} : Losses{.rolling = lost};
}

Eigen::ArrayXXd LocalCompliance::loads(const VectorField& force) const {
  Eigen::ArrayXXd loads(force.rows(), static_cast<Eigen::Index>(directions.size()));
  for (std::size_t p = 0; p < directions.size(); ++p) {
    loads.col(static_cast<Eigen::Index>(p)) = directions[p][kForward] * force.col(kForward) +
                                              directions[p][kDown] * force.col(kDown) +
                                              directions[p][kSideways] * force.col(kSideways);
  }
  return loads;
}

VectorField LocalCompliance::displacements(const Eigen::ArrayXXd& components) const {
  VectorField result = VectorField::Zero(components.rows(), 3);
  for (std::size_t p = 0; p < displaced_directions.size(); ++p) {
    for (const Axis axis : {kForward, kDown, kSideways}) {
      result.col(axis) +=
          displaced_directions[p][static_cast<std::size_t>(axis)] * components.col(static_cast<Eigen::Index>(p));
    }
  }
  return result;
}

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

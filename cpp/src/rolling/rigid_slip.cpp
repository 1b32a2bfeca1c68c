#include "rolling/rigid_slip.hpp"

#include "rolling/initial_gap.hpp"

namespace viscoroll::detail {

RigidSlip rigid_slip(const SurfaceWindow& points, double swelling, SlipKinematics kinematics, const RollingPair& pair,
                     const GivenMotion& given) {
  using Eigen::ArrayX2d;
  const double step = points.grid().radius * points.grid().phi_spacing;
  const Eigen::Index nodes = points.shape().size();
  const Eigen::Index rest = nodes - points.shape().theta_nodes;
  RigidSlip slip{.own = ArrayX2d::Zero(nodes, 2), .guided = ArrayX2d::Zero(nodes, 2)};
  if (kinematics == SlipKinematics::exact) {
    slip.own.col(0).tail(rest) = (1.0 - swelling) * step + swelling * points.lag().tail(rest);
  }
  const Eigen::ArrayXd delay = counterpart_delay(points, pair);
  slip.own.col(0).tail(rest) -= 0.5 * step * (delay.tail(rest) + delay.head(rest));
  slip.guided.col(0).tail(rest) = given.spin * step * points.z().tail(rest);
  slip.guided.col(1).tail(rest) = given.lateral_creepage * step - given.spin * step * points.x().tail(rest);
  return slip;
}

}  // namespace viscoroll::detail

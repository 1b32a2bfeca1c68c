#include "rolling/rigid_slip.hpp"

#include "rolling/initial_gap.hpp"

namespace viscoroll::detail {

RigidWays rigid_slip(const SurfaceWindow& points, const Swelling& swelling, SlipKinematics kinematics,
                     const RollingPair& pair, const GivenMotion& given) {
  using Eigen::ArrayX2d;
  using Eigen::ArrayXd;
  const double step = points.grid().radius * points.grid().phi_spacing;
  const Eigen::Index nodes = points.shape().size();
  const Eigen::Index rest = nodes - points.shape().theta_nodes;
  const ArrayXd delay = counterpart_delay(points, swelling, pair);
  const ArrayXd lag = 0.5 * step * (delay.tail(rest) + delay.head(rest));
  RigidWays ways{.slip = ArrayX2d::Zero(nodes, 2), .counterpart_way = ArrayX2d::Zero(nodes, 2)};
  ways.counterpart_way.col(0).tail(rest) = swelling.counterpart * step - lag;
  if (kinematics == SlipKinematics::exact) {
    ways.slip.col(0).tail(rest) = (swelling.counterpart - swelling.own) * step + swelling.own * points.lag().tail(rest);
  }
  ways.slip.col(0).tail(rest) += given.spin * step * points.z().tail(rest) - lag;
  ways.slip.col(1).tail(rest) = given.lateral_creepage * step - given.spin * step * points.x().tail(rest);
  return ways;
}

}  // namespace viscoroll::detail

#include "rolling/rigid_slip.hpp"

#include "rolling/initial_gap.hpp"

namespace viscoroll::detail {

RigidDisplacements rigid_slip(const SurfaceWindow& points, const CentrifugalGrowth& growth, SlipKinematics kinematics,
                              const RollingPair& pair, const GivenMotion& given) {
  using Eigen::ArrayX2d;
  using Eigen::ArrayXd;
  const double step = points.grid().radius * points.grid().phi_spacing;
  const Eigen::Index nodes = points.shape().size();
  const Eigen::Index rest = nodes - points.shape().theta_nodes;
  const ArrayXd delay = counterbody_delay(points, growth, pair);
  const ArrayXd lag = 0.5 * step * (delay.tail(rest) + delay.head(rest));
  RigidDisplacements rigid{.slip = ArrayX2d::Zero(nodes, 2), .counterbody = ArrayX2d::Zero(nodes, 2)};
  rigid.counterbody.col(0).tail(rest) = growth.counterbody * step - lag;
  if (kinematics == SlipKinematics::exact) {
    rigid.slip.col(0).tail(rest) = (growth.counterbody - growth.own) * step + growth.own * points.lag().tail(rest);
  }
  rigid.slip.col(0).tail(rest) += given.spin * step * points.z().tail(rest) - lag;
  rigid.slip.col(1).tail(rest) = given.lateral_creepage * step - given.spin * step * points.x().tail(rest);
  return rigid;
}

}  // namespace viscoroll::detail

#include "transient/plane_frame.hpp"

namespace viscoroll::detail {

HalfField along(const std::array<HalfField, 3>& direction, const HalfField& field) {
  const Eigen::Index half_nodes = direction[0].rows();
  HalfField result = direction[0].cwiseProduct(field.topRows(half_nodes));
  result += direction[1].cwiseProduct(field.middleRows(half_nodes, half_nodes));
  result += direction[2].cwiseProduct(field.bottomRows(half_nodes));
  return result;
}

HalfField spread(const std::array<HalfField, 3>& direction, const HalfField& scalar) {
  HalfField field(3 * scalar.rows(), scalar.cols());
  field << direction[0].cwiseProduct(scalar), direction[1].cwiseProduct(scalar), direction[2].cwiseProduct(scalar);
  return field;
}

HalfField on_plane(const Axes& axes, const VectorField& force) {
  const auto part = [&](std::size_t axis) {
    return spread(axes[axis], as_field(-force.col(static_cast<Eigen::Index>(axis)), axes[axis][0].rows()));
  };
  return part(kDown) + part(kForward) + part(kSideways);
}

}  // namespace viscoroll::detail

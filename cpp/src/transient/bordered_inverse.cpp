#include "transient/bordered_inverse.hpp"

#include "base/dense_products.hpp"
#include "base/dense_solvers.hpp"

namespace viscoroll::detail {

Eigen::MatrixXd bordered_inverse(const Eigen::MatrixXd& inverse, const Eigen::MatrixXd& beside,
                                 Eigen::MatrixXd corner) {
  const Eigen::Index before = inverse.rows();
  const Eigen::Index added = corner.rows();
  const Eigen::MatrixXd moved = product(inverse, beside);
  corner -= product(moved.transpose(), beside);
  const Eigen::MatrixXd complement = dense_inverse(corner);
  const Eigen::MatrixXd edge = product(moved, complement);
  Eigen::MatrixXd wide(before + added, before + added);
  wide.topLeftCorner(before, before) = inverse;
  add_product(edge, moved.transpose(), wide.topLeftCorner(before, before));
  wide.topRightCorner(before, added) = -edge;
  wide.bottomLeftCorner(added, before) = -edge.transpose();
  wide.bottomRightCorner(added, added) = complement;
  // The inverse of an ill-conditioned complement is symmetric only up to its own round-off, but sums of forces are
  // computed both by rows and by columns.
  return 0.5 * (wide + wide.transpose());
}

}  // namespace viscoroll::detail

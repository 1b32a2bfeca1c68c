#include "surface/pushback.hpp"

namespace viscoroll::detail {
namespace {

/// Mean slope from row to row over the patches of nodes, which are as long as their distance: of the differences over
/// two rows and over four what leaves no error of second order, but for the last two rows, where hardly anything
/// presses.
Eigen::ArrayXd patch_slope(const Eigen::ArrayXd& values, Eigen::Index row, double distance) {
  const auto difference = [&](Eigen::Index rows) {
    const Eigen::Index count = values.size() - 2 * rows * row;
    return Eigen::ArrayXd((values.tail(count) - values.head(count)) / (2.0 * static_cast<double>(rows) * distance));
  };
  Eigen::ArrayXd slope = Eigen::ArrayXd::Zero(values.size());
  slope.segment(row, values.size() - 2 * row) = difference(1);
  const Eigen::Index inner = values.size() - 4 * row;
  if (inner <= 0) return slope;
  slope.segment(2 * row, inner) = 1.25 * slope.segment(2 * row, inner) - 0.25 * difference(2);
  return slope;
}

}  // namespace

double pushback_by(const VectorField& displacement, const VectorField& force, Eigen::Index row, double distance) {
  const Eigen::ArrayXd depth = -displacement.col(kDown);
  return -(force.col(kDown) * patch_slope(depth, row, distance)).sum();
}

}  // namespace viscoroll::detail

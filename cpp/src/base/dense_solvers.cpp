#include "base/dense_solvers.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "base/dense_products.hpp"

namespace viscoroll::detail {

void DenseFactors::compute(const Eigen::MatrixXd& matrix) {
  factors_ = matrix;
  places_.resize(static_cast<std::size_t>(matrix.rows()));
  best_products().factor(factors_.data(), factors_.rows(), places_.data());
}

Eigen::VectorXd DenseFactors::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd solution(right.size());
  for (std::size_t row = 0; row < places_.size(); ++row) solution[places_[row]] = right[static_cast<Eigen::Index>(row)];
  factors_.triangularView<Eigen::UnitLower>().solveInPlace(solution);
  factors_.triangularView<Eigen::Upper>().solveInPlace(solution);
  return solution;
}

void SingleFactors::compute(const Eigen::MatrixXd& matrix) {
  factors_ = matrix.cast<float>();
  places_.resize(static_cast<std::size_t>(matrix.rows()));
  best_products().factor_single(factors_.data(), factors_.rows(), places_.data());
}

Eigen::VectorXd SingleFactors::solve(const Eigen::VectorXd& right) const {
  const double size = right.cwiseAbs().maxCoeff();
  if (!(size > 0.0)) return right;
  const Eigen::VectorXd scaled = right / size;  // to stay within the range of single precision
  Eigen::VectorXd solution(right.size());
  best_products().solve_single(factors_.data(), factors_.rows(), places_.data(), scaled.data(), solution.data());
  return size * solution;
}

Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& matrix) { return matrix.partialPivLu().inverse(); }

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

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Nonnegative least squares: the set of positive unknowns grows by one unknown at a time.
class ActiveSet {
 public:
  ActiveSet(const Eigen::MatrixXd& matrix, const VectorXd& right)
      : matrix_(matrix), right_(right), solution_(VectorXd::Zero(matrix.cols())) {}

  [[nodiscard]] VectorXd solve() {
    const double round_off = 1e-14 * (matrix_.transpose() * right_).cwiseAbs().maxCoeff();
    for (Index pass = 0; pass < 3 * matrix_.cols(); ++pass) {
      VectorXd gradient = matrix_.transpose() * (right_ - matrix_ * solution_);
      for (const Index i : positive_) gradient[i] = -1.0;
      Index steepest = 0;
      if (!(gradient.maxCoeff(&steepest) > round_off)) break;
      positive_.push_back(steepest);
      if (!step_inside(steepest)) break;
    }
    return solution_;
  }

 private:
  /// Move to the least squares of the positive unknowns, and remove those that would become negative on the way.
  /// @return false if round-off would remove the newest unknown again
  bool step_inside(Index newest) {
    for (;;) {
      const VectorXd target = matrix_(Eigen::all, positive_).colPivHouseholderQr().solve(right_);
      if (target.size() == 0) return true;
      if (!(target[target.size() - 1] > 0.0) && positive_.back() == newest && solution_[newest] == 0.0) return false;
      double share = 1.0;
      for (Index k = 0; k < target.size(); ++k) {
        const double now = solution_[positive_[static_cast<std::size_t>(k)]];
        if (!(target[k] > 0.0)) share = std::min(share, now / (now - target[k]));
      }
      for (Index k = 0; k < target.size(); ++k) {
        double& value = solution_[positive_[static_cast<std::size_t>(k)]];
        value += share * (target[k] - value);
      }
      if (share == 1.0) return true;
      std::erase_if(positive_, [&](Index i) {
        if (solution_[i] > std::numeric_limits<double>::min()) return false;
        solution_[i] = 0.0;
        return true;
      });
    }
  }

  const Eigen::MatrixXd& matrix_;
  const VectorXd& right_;
  VectorXd solution_;
  std::vector<Index> positive_;
};

}  // namespace

VectorXd nonnegative_least_squares(const Eigen::MatrixXd& matrix, const VectorXd& right) {
  return ActiveSet(matrix, right).solve();
}

}  // namespace viscoroll::detail

#include "transient/nnls.hpp"

#include <Eigen/QR>
#include <limits>
#include <vector>

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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

#include "base/dense_solvers.hpp"

#include <Eigen/LU>

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

}  // namespace viscoroll::detail

#include "dense_solvers.hpp"

namespace viscoroll::detail {

void DenseFactors::compute(const Eigen::MatrixXd& matrix) { factors_.compute(matrix); }

Eigen::VectorXd DenseFactors::solve(const Eigen::VectorXd& right) const { return factors_.solve(right); }

Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& matrix) { return matrix.partialPivLu().inverse(); }

}  // namespace viscoroll::detail

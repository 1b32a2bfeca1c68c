#include "influence/gauss_legendre.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace viscoroll::detail {

std::pair<Eigen::ArrayXd, Eigen::ArrayXd> gauss_legendre(int points) {
  Eigen::VectorXd off(points - 1);
  for (Eigen::Index i = 0; i < off.size(); ++i) {
    const auto n = static_cast<double>(i + 1);
    off[i] = n / std::sqrt(4.0 * n * n - 1.0);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::VectorXd::Zero(points), off);
  return {solver.eigenvalues().array(), 2.0 * solver.eigenvectors().row(0).transpose().array().square()};
}

}  // namespace viscoroll::detail

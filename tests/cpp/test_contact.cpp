#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdlib>

#include "contact/dense_lu.hpp"
#include "viscoroll/errors.hpp"

namespace viscoroll::detail {
namespace {

/// Unsymmetric, with a positive definite symmetric part, like a compliance with memory.
Eigen::MatrixXd unsymmetric(Eigen::Index size) {
  std::srand(1);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(size, size);
  return a * a.transpose() / static_cast<double>(size) + 0.1 * Eigen::MatrixXd::Identity(size, size) +
         0.5 * (a - a.transpose());
}

TEST(SolveDense, AgreesWithFullPivoting) {
  const Observer observer;
  Watch watch(observer);
  for (const Eigen::Index size : {1, 5, 96, 97, 400}) {
    const Eigen::MatrixXd matrix = unsymmetric(size);
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(size, 2);
    const Eigen::MatrixXd expected = matrix.fullPivLu().solve(right);
    const Eigen::MatrixXd solution = solve_dense(matrix, right, 2, watch);
    EXPECT_LT((solution - expected).norm(), 1e-10 * expected.norm()) << size;
  }
}

TEST(SolveDense, DoesNotDependOnTheNumberOfThreads) {
  const Observer observer;
  Watch watch(observer);
  const Eigen::MatrixXd matrix = unsymmetric(500);
  const Eigen::MatrixXd right = Eigen::MatrixXd::Ones(500, 1);
  EXPECT_EQ(solve_dense(matrix, right, 1, watch), solve_dense(matrix, right, 3, watch));
}

TEST(SolveDense, StopsOnRequest) {
  const Observer observer{.cancelled = [] { return true; }};
  Watch watch(observer);
  const Eigen::MatrixXd matrix = unsymmetric(1500);
  EXPECT_THROW(std::ignore = solve_dense(matrix, Eigen::MatrixXd::Ones(1500, 1), 2, watch), Cancelled);
}

}  // namespace
}  // namespace viscoroll::detail

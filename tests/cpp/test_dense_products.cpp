// Products with each instruction set of this processor, compared with scalar sums.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <type_traits>

#include "base/dense_products.hpp"
#include "base/dense_solvers.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using ColumnMajor = Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Return a matrix whose elements all differ.
template <class Matrix>
Matrix filled(Index rows, Index columns, double phase) {
  Matrix matrix(rows, columns);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) matrix(i, j) = std::cos(phase + 1.3 * static_cast<double>(i * columns + j));
  }
  return matrix;
}

/// Largest error of sum += left * right, where elements of `sum` around the product must not change.
template <class Left, class Right>
double error_of(const DenseProducts& products, Index rows, Index depth, Index columns) {
  const auto left = filled<Left>(rows, depth, 0.1);
  const auto right = filled<Right>(depth, columns, 0.7);
  auto sum = filled<RowMajor>(rows + 1, columns + 2, 0.3);
  RowMajor expected = sum;
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) {
      for (Index k = 0; k < depth; ++k) expected(i, j) += left(i, k) * right(k, j);
    }
  }
  const auto view = [](const auto& matrix) {
    return ConstMatrixView{.data = matrix.data(),
                           .rows = matrix.rows(),
                           .columns = matrix.cols(),
                           .stride = matrix.outerStride(),
                           .row_major = std::remove_cvref_t<decltype(matrix)>::IsRowMajor};
  };
  products.add(view(left), view(right),
               {.data = sum.data(), .rows = rows, .columns = columns, .stride = sum.outerStride()});
  return (sum - expected).cwiseAbs().maxCoeff();
}

TEST(DenseProductsTest, AgreeWithScalarSums) {
  for (const DenseProducts& products : usable_products()) {
    for (const Index columns : {1, 7, 64, 250}) {
      EXPECT_LT((error_of<RowMajor, RowMajor>(products, 32, 66, columns)), 1e-13);
      EXPECT_LT((error_of<RowMajor, ColumnMajor>(products, 3, 66, columns)), 1e-13);
      EXPECT_LT((error_of<ColumnMajor, RowMajor>(products, 91, 17, columns)), 1e-13);
      EXPECT_LT((error_of<ColumnMajor, ColumnMajor>(products, 1, 66, columns)), 1e-13);
    }
  }
}

TEST(DenseProductsTest, ComplexMatricesTimesVectors) {
  const std::complex<double> i(0.0, 1.0);
  const Eigen::MatrixXcd matrix = filled<ColumnMajor>(45, 31, 0.2) + i * filled<ColumnMajor>(45, 31, 0.9);
  const Eigen::VectorXcd vector = filled<ColumnMajor>(31, 1, 0.4) + i * filled<ColumnMajor>(31, 1, 0.5);
  for (const DenseProducts& products : usable_products()) {
    Eigen::VectorXcd product = Eigen::VectorXcd::Constant(45, 7.0);
    products.multiply({.data = matrix.data(), .rows = 45, .columns = 31}, vector.data(), product.data());
    for (Index row = 0; row < 45; ++row) {
      std::complex<double> expected = 0.0;
      for (Index k = 0; k < 31; ++k) expected += matrix(row, k) * vector[k];
      EXPECT_LT(std::abs(product[row] - expected), 1e-13);
    }
  }
}

TEST(DenseProductsTest, BlocksAndTransposes) {
  const auto left = filled<RowMajor>(20, 9, 0.1);
  const auto right = filled<ColumnMajor>(20, 30, 0.8);
  const ColumnMajor expected = left.transpose() * right;
  EXPECT_LT((product(left.transpose(), right) - expected).cwiseAbs().maxCoeff(), 1e-13);
  ColumnMajor sum = ColumnMajor::Zero(12, 30);
  add_product(left.transpose(), right, sum.middleRows(2, 9));
  EXPECT_LT((sum.middleRows(2, 9) - expected).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_EQ(sum.topRows(2).cwiseAbs().maxCoeff() + sum.bottomRows(1).cwiseAbs().maxCoeff(), 0.0);
}

/// Well-conditioned matrix with a large diagonal, of the size of a contact.
Eigen::MatrixXd well_posed(Eigen::Index size) {
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) matrix(i, j) = 1.0 / (1.0 + std::abs(static_cast<double>(i - j)));
  }
  return matrix;
}

TEST(DenseFactors, SolveWithRowExchanges) {
  const Eigen::MatrixXd matrix = well_posed(90).colwise().reverse();
  const Eigen::VectorXd wanted = Eigen::VectorXd::LinSpaced(90, -1.0, 2.0);
  const Eigen::VectorXd right = matrix * wanted;
  DenseFactors factors;
  factors.compute(matrix);
  EXPECT_LT((factors.solve(right) - wanted).cwiseAbs().maxCoeff(), 1e-13);
  SingleFactors rough;
  rough.compute(matrix);
  EXPECT_LT((rough.solve(1e-60 * right) - 1e-60 * wanted).cwiseAbs().maxCoeff(), 1e-65);  // the scale has no effect
  EXPECT_EQ(rough.solve(Eigen::VectorXd::Zero(90)).cwiseAbs().maxCoeff(), 0.0);
}

TEST(BorderedInverse, AgreesWithTheInverseOfTheWholeMatrix) {
  const Eigen::MatrixXd matrix = well_posed(60);
  const Eigen::MatrixXd first = bordered_inverse({}, Eigen::MatrixXd(0, 45), matrix.topLeftCorner(45, 45));
  const Eigen::MatrixXd whole =
      bordered_inverse(first, matrix.topRightCorner(45, 15), matrix.bottomRightCorner(15, 15));
  EXPECT_LT((whole * matrix - Eigen::MatrixXd::Identity(60, 60)).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace viscoroll::detail

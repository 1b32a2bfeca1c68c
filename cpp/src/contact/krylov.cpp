#include "contact/krylov.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <unsupported/Eigen/IterativeSolvers>

namespace viscoroll::detail {

class ProductMatrix;

}  // namespace viscoroll::detail

namespace Eigen::internal {

/// Eigen's iterative solvers take what behaves like a sparse matrix.
template <>
struct traits<viscoroll::detail::ProductMatrix> : traits<SparseMatrix<double>> {};

}  // namespace Eigen::internal

namespace viscoroll::detail {

/// A linear operator in the shape of a matrix.
class ProductMatrix : public Eigen::EigenBase<ProductMatrix> {
 public:
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic, IsRowMajor = false };

  ProductMatrix(const LinearOperator& product, Eigen::Index size) : product_(product), size_(size) {}

  [[nodiscard]] Eigen::Index rows() const { return size_; }
  [[nodiscard]] Eigen::Index cols() const { return size_; }

  template <class Right>
  [[nodiscard]] Eigen::Product<ProductMatrix, Right, Eigen::AliasFreeProduct> operator*(
      const Eigen::MatrixBase<Right>& right) const {
    return {*this, right.derived()};
  }

  [[nodiscard]] Eigen::VectorXd times(const Eigen::VectorXd& right) const { return product_(right); }

 private:
  const LinearOperator& product_;
  Eigen::Index size_;
};

namespace {

constexpr int kMostIterations = 200;  // some ten are enough
constexpr int kMostGmresIterations = 60;

class OperatorPreconditioner {
 public:
  void set(const LinearOperator& inverse) { inverse_ = &inverse; }

  // What Eigen calls on the way.
  template <class Matrix>
  OperatorPreconditioner& analyzePattern(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  OperatorPreconditioner& factorize(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  OperatorPreconditioner& compute(const Matrix&) {
    return *this;
  }
  [[nodiscard]] Eigen::ComputationInfo info() { return Eigen::Success; }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return (*inverse_)(right); }

 private:
  const LinearOperator* inverse_ = nullptr;
};

}  // namespace
}  // namespace viscoroll::detail

namespace Eigen::internal {

template <class Right>
struct generic_product_impl<viscoroll::detail::ProductMatrix, Right, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<viscoroll::detail::ProductMatrix, Right,
                                generic_product_impl<viscoroll::detail::ProductMatrix, Right>> {
  using Scalar = double;

  template <class Destination>
  static void scaleAndAddTo(Destination& destination, const viscoroll::detail::ProductMatrix& left, const Right& right,
                            const Scalar& scale) {
    destination.noalias() += scale * left.times(right);
  }
};

}  // namespace Eigen::internal

namespace viscoroll::detail {

namespace {

template <class Solver>
KrylovSolution solve_with(Solver&& solver, const LinearOperator& matrix, const LinearOperator& preconditioner,
                          const Eigen::VectorXd& right, const Eigen::VectorXd& guess, double tolerance) {
  int products = 0;
  const LinearOperator counted = [&](const Eigen::VectorXd& vector) {
    ++products;
    return matrix(vector);
  };
  const ProductMatrix product(counted, right.size());
  solver.preconditioner().set(preconditioner);
  solver.setTolerance(tolerance);
  solver.setMaxIterations(kMostIterations);
  solver.compute(product);
  Eigen::VectorXd unknowns = solver.solveWithGuess(right, guess);
  return {.unknowns = std::move(unknowns), .products = products, .error = solver.error()};
}

}  // namespace

KrylovSolution solve_krylov(KrylovMethod method, const LinearOperator& matrix, const LinearOperator& preconditioner,
                            const Eigen::VectorXd& right, const Eigen::VectorXd& guess, double tolerance) {
  if (method == KrylovMethod::cg) {
    return solve_with(Eigen::ConjugateGradient<ProductMatrix, Eigen::Lower | Eigen::Upper, OperatorPreconditioner>(),
                      matrix, preconditioner, right, guess, tolerance);
  }
  if (method == KrylovMethod::gmres) {
    Eigen::GMRES<ProductMatrix, OperatorPreconditioner> solver;
    solver.set_restart(kMostGmresIterations);
    return solve_with(solver, matrix, preconditioner, right, guess, tolerance);
  }
  return solve_with(Eigen::BiCGSTAB<ProductMatrix, OperatorPreconditioner>(), matrix, preconditioner, right, guess,
                    tolerance);
}

}  // namespace viscoroll::detail

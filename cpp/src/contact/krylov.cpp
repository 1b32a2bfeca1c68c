#include "contact/krylov.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

namespace viscoroll::detail {

class ContactMatrix;

}  // namespace viscoroll::detail

namespace Eigen::internal {

/// Eigen's iterative solvers take what behaves like a sparse matrix.
template <>
struct traits<viscoroll::detail::ContactMatrix> : traits<SparseMatrix<double>> {};

}  // namespace Eigen::internal

namespace viscoroll::detail {

/// C over the nodes in contact, as a product.
class ContactMatrix : public Eigen::EigenBase<ContactMatrix> {
 public:
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic, IsRowMajor = false };

  ContactMatrix(const CoatingCompliance& coating, const std::vector<Eigen::Index>& nodes, Eigen::Index window,
                Watch& watch)
      : coating_(coating), nodes_(nodes), window_(window), watch_(watch) {}

  [[nodiscard]] Eigen::Index rows() const { return static_cast<Eigen::Index>(nodes_.size()); }
  [[nodiscard]] Eigen::Index cols() const { return rows(); }

  template <class Right>
  [[nodiscard]] Eigen::Product<ContactMatrix, Right, Eigen::AliasFreeProduct> operator*(
      const Eigen::MatrixBase<Right>& right) const {
    return {*this, right.derived()};
  }

  template <class Right>
  [[nodiscard]] Eigen::VectorXd times(const Right& pressing) const {
    watch_.poll("solving the contact equations", 0.0);
    VectorField force = VectorField::Zero(window_, 3);
    for (std::size_t i = 0; i < nodes_.size(); ++i) force(nodes_[i], kDown) = -pressing[static_cast<Eigen::Index>(i)];
    const VectorField displacement = coating_.displacement(force);
    Eigen::VectorXd result(rows());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      result[static_cast<Eigen::Index>(i)] = -displacement(nodes_[i], kDown);
    }
    return result;
  }

  [[nodiscard]] const std::vector<Eigen::Index>& nodes() const { return nodes_; }
  [[nodiscard]] Eigen::Index window() const { return window_; }

 private:
  const CoatingCompliance& coating_;
  const std::vector<Eigen::Index>& nodes_;
  Eigen::Index window_;
  Watch& watch_;
};

namespace {

constexpr int kMostIterations = 300;  // some ten are enough

class SymbolPreconditioner {
 public:
  void set(const InverseConvolution& inverse, const ContactMatrix& matrix) {
    inverse_ = &inverse;
    matrix_ = &matrix;
  }

  // What Eigen calls on the way.
  template <class Matrix>
  SymbolPreconditioner& analyzePattern(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  SymbolPreconditioner& factorize(const Matrix&) {
    return *this;
  }
  template <class Matrix>
  SymbolPreconditioner& compute(const Matrix&) {
    return *this;
  }
  [[nodiscard]] Eigen::ComputationInfo info() { return Eigen::Success; }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    Eigen::ArrayXd field = Eigen::ArrayXd::Zero(matrix_->window());
    field(matrix_->nodes()) = right.array();
    return inverse_->apply(field)(matrix_->nodes()).matrix();
  }

 private:
  const InverseConvolution* inverse_ = nullptr;
  const ContactMatrix* matrix_ = nullptr;
};

}  // namespace
}  // namespace viscoroll::detail

namespace Eigen::internal {

template <class Right>
struct generic_product_impl<viscoroll::detail::ContactMatrix, Right, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<viscoroll::detail::ContactMatrix, Right,
                                generic_product_impl<viscoroll::detail::ContactMatrix, Right>> {
  using Scalar = double;

  template <class Destination>
  static void scaleAndAddTo(Destination& destination, const viscoroll::detail::ContactMatrix& left, const Right& right,
                            const Scalar& scale) {
    destination.noalias() += scale * left.times(right);
  }
};

}  // namespace Eigen::internal

namespace viscoroll::detail {

KrylovSolution solve_krylov(const CoatingCompliance& coating, const InverseConvolution& preconditioner,
                            const std::vector<Eigen::Index>& nodes, const Eigen::VectorXd& lowering,
                            const Eigen::VectorXd& guess, double tolerance, Watch& watch) {
  const ContactMatrix matrix(coating, nodes, coating.shape().size(), watch);
  Eigen::BiCGSTAB<ContactMatrix, SymbolPreconditioner> solver;
  solver.preconditioner().set(preconditioner, matrix);
  solver.setTolerance(tolerance);
  solver.setMaxIterations(kMostIterations);
  solver.compute(matrix);
  Eigen::VectorXd forces = solver.solveWithGuess(lowering, guess);
  return {.forces = std::move(forces), .iterations = static_cast<int>(solver.iterations()), .error = solver.error()};
}

}  // namespace viscoroll::detail

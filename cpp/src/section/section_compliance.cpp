#include "section/section_compliance.hpp"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <cassert>
#include <cmath>
#include <type_traits>
#include <utility>

#include "base/dense_solvers.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Triplets = std::vector<Eigen::Triplet<double>>;
using Sparse = Eigen::SparseMatrix<double>;

/// Add the real form of one entry: a real entry itself, or for an entry a + i b of a complex symmetric matrix the
/// symmetric block (a, -b; -b, -a). Its factors exist without pivoting in every order, because a > 0 (R. J. Vanderbei,
/// SIAM Journal on Optimization 5 (1995) 100-113).
void add_entry(int row, int column, double value, Triplets& triplets) { triplets.emplace_back(row, column, value); }

void add_entry(int row, int column, cplx value, Triplets& triplets) {
  triplets.emplace_back(2 * row, 2 * column, value.real());
  triplets.emplace_back(2 * row + 1, 2 * column, -value.imag());
  if (row != column) triplets.emplace_back(2 * row, 2 * column + 1, -value.imag());
  triplets.emplace_back(2 * row + 1, 2 * column + 1, -value.real());
}

/// Number of real unknowns per unknown.
template <class Scalar>
constexpr int kReals = std::is_same_v<Scalar, double> ? 1 : 2;

/// Stiffness of the last unknowns after the elimination of all others.
MatrixXd condensed(const Triplets& lower, Index size, Index eliminated) {
  Sparse matrix(size, size);
  matrix.setFromTriplets(lower.begin(), lower.end());
  const Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> factors(matrix);
  assert(factors.info() == Eigen::Success);
  const Sparse& below = factors.matrixL().nestedExpression();
  MatrixXd corner = MatrixXd::Identity(size - eliminated, size - eliminated);
  for (Index column = eliminated; column < size; ++column) {
    for (Sparse::InnerIterator entry(below, column); entry; ++entry) {
      if (entry.row() > column) corner(entry.row() - eliminated, column - eliminated) = entry.value();
    }
  }
  return corner * factors.vectorD().tail(size - eliminated).asDiagonal() * corner.transpose();
}

MatrixXd inverse(const MatrixXd& stiffness, double /*kind*/) { return dense_inverse(stiffness); }

Eigen::MatrixXcd inverse(const MatrixXd& stiffness, cplx /*kind*/) {
  const Index size = stiffness.rows() / 2;
  Eigen::MatrixXcd entries(size, size);
  for (Index i = 0; i < size; ++i) {
    for (Index j = 0; j < size; ++j) entries(i, j) = {stiffness(2 * i, 2 * j), -stiffness(2 * i + 1, 2 * j)};
  }
  return entries.inverse();
}

}  // namespace

SectionCompliance::SectionCompliance(SectionMesh mesh, bool tangential)
    : mesh_(std::move(mesh)), components_(tangential ? 3 : 1) {
  for (std::size_t column = 0; column < mesh_.columns(); ++column) {
    for (std::size_t row = 0; row < mesh_.element_rows(); ++row) {
      std::array<std::size_t, kElementNodes> nodes{};
      std::array<double, kElementNodes> r{};
      std::array<double, kElementNodes> z{};
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        const std::size_t line = 2 * column + n % 3;
        nodes[n] = mesh_.node(line, 2 * row + n / 3);
        r[n] = mesh_.radius(line, 2 * row + n / 3);
        z[n] = mesh_.z()[static_cast<Index>(line)];
      }
      nodes_.push_back(nodes);
      elements_.push_back(element_stiffness(r, z));
    }
    rotate_surface_unknowns(column, elements_.back());
  }
  for (const Parity part : kBothParts) eliminations_[part] = elimination(part);
}

void SectionCompliance::rotate_surface_unknowns(std::size_t column, ElementStiffness& stiffness) const {
  ElementMatrix turned = ElementMatrix::Identity();
  for (std::size_t n = 0; n < 3; ++n) {
    const double slope = mesh_.slope(2 * column + n);
    const Index u = 3 * (kElementNodes - 3 + static_cast<Index>(n));
    const double cosine = 1.0 / std::hypot(1.0, slope);
    turned(u, u) = turned(u + 2, u + 2) = cosine;
    turned(u, u + 2) = -cosine * slope;
    turned(u + 2, u) = cosine * slope;
  }
  for (PowersOfOrder* const powers : {&stiffness.shear, &stiffness.volumetric}) {
    for (ElementMatrix& matrix : *powers) matrix = (turned.transpose() * matrix * turned).eval();
  }
}

Eigen::VectorXd SectionCompliance::lengths() const {
  const auto lines = static_cast<Index>(mesh_.loaded_lines());
  Eigen::VectorXd lengths = Eigen::VectorXd::Ones(static_cast<Index>(components_) * lines);
  for (Index i = 0; i < lengths.size(); ++i) {
    if (i / lines != 1) lengths[i] = std::hypot(1.0, mesh_.slope(static_cast<std::size_t>(i % lines)));
  }
  return lengths;
}

SectionCompliance::Elimination SectionCompliance::elimination(Parity part) const {
  Elimination result;
  result.position.assign(3 * mesh_.lines() * mesh_.rows(), -1);
  std::vector<std::size_t> surface;
  for (std::size_t line = 0; line < mesh_.lines(); ++line) {
    for (std::size_t row = 1; row < mesh_.rows(); ++row) {  // the hub is fixed
      for (std::size_t component = 0; component < 3; ++component) {
        if (line == 0 && (component == 2) == (part == kEvenPart)) continue;
        const std::size_t unknown = 3 * mesh_.node(line, row) + component;
        const bool loaded = row + 1 == mesh_.rows() && line < mesh_.loaded_lines() && component < components_;
        if (loaded) {
          surface.push_back(unknown);
          result.loaded.push_back(static_cast<int>(component * mesh_.loaded_lines() + line));
        } else {
          result.position[unknown] = result.eliminated++;
        }
      }
    }
  }
  Triplets neighbors;
  for (const auto& nodes : nodes_) {
    for (const std::size_t a : nodes) {
      for (const std::size_t b : nodes) {
        for (std::size_t c = 0; c < 9; ++c) {
          const int row = result.position[3 * a + c % 3];
          const int column = result.position[3 * b + c / 3];
          if (row >= 0 && column >= 0) neighbors.emplace_back(row, column, 1.0);
        }
      }
    }
  }
  Sparse pattern(result.eliminated, result.eliminated);
  pattern.setFromTriplets(neighbors.begin(), neighbors.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern, order);  // unknown order.indices()[n] has position n
  Eigen::VectorXi position(result.eliminated);
  for (int n = 0; n < result.eliminated; ++n) position[order.indices()[n]] = n;
  for (int& unknown : result.position) {
    if (unknown >= 0) unknown = position[unknown];
  }
  for (std::size_t n = 0; n < surface.size(); ++n)
    result.position[surface[n]] = result.eliminated + static_cast<int>(n);
  return result;
}

template <class Scalar>
std::array<SectionCompliance::Matrix<Scalar>, 2> SectionCompliance::at(double m,
                                                                       const std::vector<SectionMedium<Scalar>>& layers,
                                                                       std::span<const Parity> parts) const {
  std::array<Triplets, 2> lower;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const SectionMedium<Scalar>& medium = layers[mesh_.layer(e % mesh_.element_rows())];
    const ElementMatrix shear = at_order(elements_[e].shear, m);
    const ElementMatrix volumetric = at_order(elements_[e].volumetric, m);
    for (const Parity part : parts) {
      const std::vector<int>& position = eliminations_[part].position;
      for (Index i = 0; i < kElementUnknowns; ++i) {
        const int row = position[3 * nodes_[e][static_cast<std::size_t>(i / 3)] + static_cast<std::size_t>(i % 3)];
        for (Index j = 0; j < kElementUnknowns; ++j) {
          const int column = position[3 * nodes_[e][static_cast<std::size_t>(j / 3)] + static_cast<std::size_t>(j % 3)];
          if (column < 0 || row < column) continue;
          add_entry(row, column, medium.shear * shear(i, j) + medium.lame * volumetric(i, j), lower[part]);
        }
      }
    }
  }
  std::array<Matrix<Scalar>, 2> result;
  const Eigen::VectorXd lengths = this->lengths();
  const Index rows = lengths.size();
  for (const Parity part : parts) {
    const auto& [position, eliminated, loaded] = eliminations_[part];
    const Index all = eliminated + static_cast<Index>(loaded.size());
    const Matrix<Scalar> moved =
        inverse(condensed(lower[part], kReals<Scalar> * all, kReals<Scalar> * eliminated), Scalar());
    result[part] = Matrix<Scalar>::Zero(rows, rows);
    result[part](loaded, loaded) = moved;
    result[part] = lengths.asDiagonal() * result[part] * lengths.asDiagonal();
  }
  return result;
}

template std::array<SectionCompliance::Matrix<double>, 2> SectionCompliance::at(
    double, const std::vector<SectionMedium<double>>&, std::span<const Parity>) const;
template std::array<SectionCompliance::Matrix<cplx>, 2> SectionCompliance::at(double,
                                                                              const std::vector<SectionMedium<cplx>>&,
                                                                              std::span<const Parity>) const;

}  // namespace viscoroll::detail

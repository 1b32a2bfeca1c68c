#include "section/section_compliance.hpp"

#include <Eigen/LU>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

#include "base/dense_solvers.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using cplx = std::complex<double>;

using Size = std::function<double(double)>;

/// Distance of the end of an unbounded section from the width, in thicknesses. The effect of the end of a bonded tread
/// decays by e^-1.4 per thickness if the tread is incompressible, and faster otherwise; it changes the stiffness under
/// a punch by 2e-4.
constexpr double kUnboundedSectionReach = 6.0;

/// Edges of elements from `first` to `last` with about the given size.
std::vector<double> edges(double first, double last, const Size& size) {
  // The number of samples resolves the size function, also at fine ends.
  constexpr double kMinSamples = 400.0;
  const double samples_for_ends = 4.0 * (last - first) / std::min(size(first), size(last));
  const int samples = static_cast<int>(std::max(kMinSamples, samples_for_ends));
  const double step = (last - first) / samples;
  std::vector<double> elements{0.0};
  for (int i = 0; i < samples; ++i) elements.push_back(elements.back() + step / size(first + (i + 0.5) * step));
  const int count = std::max(1, static_cast<int>(std::ceil(elements.back() - 1e-9)));
  std::vector<double> result{first};
  std::size_t place = 0;
  for (int n = 1; n < count; ++n) {
    const double wanted = elements.back() * n / count;
    while (elements[place + 1] < wanted) ++place;
    const double share = (wanted - elements[place]) / (elements[place + 1] - elements[place]);
    result.push_back(first + step * (static_cast<double>(place) + share));
  }
  result.push_back(last);
  return result;
}

/// Edges and the middles between them.
Eigen::ArrayXd with_middles(const std::vector<double>& edges) {
  Eigen::ArrayXd places(2 * static_cast<Eigen::Index>(edges.size()) - 1);
  for (Eigen::Index i = 0; i < places.size(); ++i) {
    const auto left = static_cast<std::size_t>(i / 2);
    places[i] = i % 2 == 0 ? edges[left] : 0.5 * (edges[left] + edges[left + 1]);
  }
  return places;
}

/// Slope of the crown at a distance from the middle. It is limited where the crown is vertical.
double crown_slope(const CoatedWheel& wheel, double z) {
  if (std::isinf(wheel.crown_radius)) return 0.0;
  constexpr double kMinCosine = 1e-3;
  const double sine = z / wheel.crown_radius;
  return sine / std::max(std::sqrt(1.0 - sine * sine), kMinCosine);
}

using StrainRows = Eigen::Matrix<double, 6, kElementUnknowns>;
using VolumeRows = Eigen::Matrix<double, 3, kElementUnknowns>;

enum Strain : Index { kRadial, kHoop, kAxial, kRadialHoop, kHoopAxial, kRadialAxial };

std::array<double, 3> quadratic_slopes(double x) { return {x - 0.5, -2.0 * x, x + 0.5}; }

/// Values and gradients of the nine shape functions at a Gauss point, and the weight of the point.
struct Point {
  Eigen::Matrix<double, kElementNodes, 1> value, along_r, along_z;
  double r;
  double measure;
};

Point point(const std::array<double, kElementNodes>& r, const std::array<double, kElementNodes>& z, double x, double y,
            double weight) {
  const auto across = quadratic_shares(x);
  const auto down = quadratic_shares(y);
  const auto across_slope = quadratic_slopes(x);
  const auto down_slope = quadratic_slopes(y);
  Point p{};
  Eigen::Matrix<double, kElementNodes, 2> local;
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();  // d(r, z)/d(x, y)
  for (Index n = 0; n < kElementNodes; ++n) {
    const auto node = static_cast<std::size_t>(n);
    p.value[n] = across[node % 3] * down[node / 3];
    local(n, 0) = across_slope[node % 3] * down[node / 3];
    local(n, 1) = across[node % 3] * down_slope[node / 3];
    p.r += p.value[n] * r[node];
    jacobian.row(0) += r[node] * local.row(n);
    jacobian.row(1) += z[node] * local.row(n);
  }
  const Eigen::Matrix<double, kElementNodes, 2> gradient = local * jacobian.inverse();
  p.along_r = gradient.col(0);
  p.along_z = gradient.col(1);
  p.measure = weight * std::abs(jacobian.determinant()) * p.r;
  return p;
}

/// Strain rows of order 0, and the part that is multiplied by m.
std::array<StrainRows, 2> strain_rows(const Point& p) {
  std::array<StrainRows, 2> rows{StrainRows::Zero(), StrainRows::Zero()};
  auto& [rest, order] = rows;
  for (Index n = 0; n < kElementNodes; ++n) {
    const Index u = 3 * n;
    const Index v = u + 1;
    const Index w = u + 2;
    const double hoop = p.value[n] / p.r;
    rest(kRadial, u) = p.along_r[n];
    rest(kHoop, u) = hoop;
    rest(kAxial, w) = p.along_z[n];
    rest(kRadialHoop, v) = p.along_r[n] - hoop;
    rest(kHoopAxial, v) = p.along_z[n];
    rest(kRadialAxial, u) = p.along_z[n];
    rest(kRadialAxial, w) = p.along_r[n];
    order(kHoop, v) = -hoop;
    order(kRadialHoop, u) = hoop;
    order(kHoopAxial, w) = hoop;
  }
  return rows;
}

/// Add (a + m b)^T weight (a + m b) to the powers of m, with a = rows[0] and b = rows[1].
template <class Rows, class Weight>
void add_square(const std::array<Rows, 2>& rows, const Weight& weight, PowersOfOrder& powers) {
  const Rows rest = weight * rows[0];
  const Rows order = weight * rows[1];
  const ElementMatrix mixed = rows[0].transpose() * order;
  powers[0] += rows[0].transpose() * rest;
  powers[1] += mixed + mixed.transpose();
  powers[2] += rows[1].transpose() * order;
}

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

SectionMesh::SectionMesh(const CoatedWheel& wheel, SectionEnd end, const SectionFineness& fineness) {
  const double thickness = coating_thickness(wheel);
  const double half = 0.5 * wheel.width;
  const double unit = std::min(thickness, wheel.width);
  const auto away = [&](double distance) { return unit * (fineness.finest + fineness.growth * distance / unit); };
  const double largest = fineness.largest * thickness;
  const double widest = std::min(std::max(largest, fineness.widest * wheel.width), 0.25 * half);

  std::vector<double> across = edges(0.0, half, [&](double z) { return std::min(away(half - z), widest); });
  loaded_lines_ = 2 * across.size() - 1;
  if (end == SectionEnd::unbounded) {
    const std::vector<double> beyond = edges(half, half + kUnboundedSectionReach * thickness,
                                             [&](double z) { return std::min(away(z - half), thickness); });
    across.insert(across.end(), beyond.begin() + 1, beyond.end());
  }
  z_ = with_middles(across);

  std::vector<double> radii{wheel.core_radius};
  const double surface = wheel.core_radius + thickness;
  for (std::size_t l = 0; l < wheel.layers.size(); ++l) {
    const double inner = radii.back();
    const double outer = l + 1 == wheel.layers.size() ? surface : inner + wheel.layers[l].thickness;
    const std::vector<double> layer = edges(
        inner, outer, [&](double r) { return std::min({away(surface - r), away(r - wheel.core_radius), largest}); });
    radii.insert(radii.end(), layer.begin() + 1, layer.end());
    layer_of_row_.insert(layer_of_row_.end(), layer.size() - 1, l);
  }
  const Eigen::ArrayXd straight = with_middles(radii);
  r_ = straight.replicate(1, z_.size());
  slope_.resize(z_.size());
  const double outermost = wheel.layers.back().thickness;
  const Eigen::ArrayXd drop_fractions = wheel.hub == Hub::crowned
                                            ? Eigen::ArrayXd::Ones(straight.size())
                                            : Eigen::ArrayXd(((straight - surface) / outermost + 1.0).max(0.0));
  for (Eigen::Index i = 0; i < z_.size(); ++i) {
    r_.col(i) -= drop_fractions * crown_drop(wheel, z_[i]);
    slope_[i] = crown_slope(wheel, z_[i]);
  }
}

std::array<double, 3> quadratic_shares(double x) { return {0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)}; }

ElementStiffness element_stiffness(const std::array<double, kElementNodes>& r,
                                   const std::array<double, kElementNodes>& z) {
  const double outer = std::sqrt(0.6);  // three Gauss points
  const std::array<double, 3> abscissas{-outer, 0.0, outer};
  const std::array<double, 3> weights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  const Eigen::DiagonalMatrix<double, 6> shear_weights(2.0, 2.0, 2.0, 1.0, 1.0, 1.0);
  ElementStiffness stiffness;
  for (auto* const powers : {&stiffness.shear, &stiffness.volumetric}) powers->fill(ElementMatrix::Zero());
  std::array<VolumeRows, 2> volume{VolumeRows::Zero(), VolumeRows::Zero()};
  Eigen::Matrix3d pressures = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Point p = point(r, z, abscissas[i], abscissas[j], weights[i] * weights[j]);
      const auto strains = strain_rows(p);
      add_square(strains, Eigen::DiagonalMatrix<double, 6>(p.measure * shear_weights.diagonal()), stiffness.shear);
      const Eigen::Vector3d pressure(1.0, abscissas[i], abscissas[j]);
      pressures += p.measure * pressure * pressure.transpose();
      for (std::size_t power = 0; power < 2; ++power) {
        volume[power] += p.measure * pressure * strains[power].topRows<3>().colwise().sum();
      }
    }
  }
  add_square(volume, Eigen::Matrix3d(pressures.inverse()), stiffness.volumetric);
  return stiffness;
}

ElementMatrix at_order(const PowersOfOrder& powers, double m) { return powers[0] + m * (powers[1] + m * powers[2]); }

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

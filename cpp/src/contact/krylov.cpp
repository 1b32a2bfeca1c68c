#include "contact/krylov.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kMaxDirections = 120;  // before a restart, for large systems
constexpr int kMaxProducts = 360;      // some ten are usually enough
constexpr double kStagnation = 0.5;    // ratio of residuals after and before a restart at which the method gives up

/// Orthonormal basis of a Krylov space and the least residual over it.
class Arnoldi {
 public:
  explicit Arnoldi(VectorXd residual) : right_side_{residual.norm()} {
    residual /= right_side_.front();
    directions_.push_back(std::move(residual));
  }

  [[nodiscard]] const VectorXd& last() const { return directions_.back(); }
  [[nodiscard]] Index count() const { return static_cast<Index>(rotations_.size()); }
  [[nodiscard]] double residual() const { return std::abs(right_side_.back()); }

  /// Add the image of the last direction.
  /// @param[in] step last direction, preconditioned
  /// @param[in] image matrix times `step`
  /// @return whether the image adds a direction
  bool extend(VectorXd step, VectorXd image) {
    const Index n = count();
    steps_.push_back(std::move(step));
    VectorXd column = VectorXd::Zero(n + 2);
    const double before = image.norm();
    for (int pass = 0; pass < 2; ++pass) {  // two passes give orthogonality to round-off
      for (Index i = 0; i <= n; ++i) {
        const double share = directions_[static_cast<std::size_t>(i)].dot(image);
        image -= share * directions_[static_cast<std::size_t>(i)];
        column[i] += share;
      }
    }
    const double rest = image.norm();
    column[n + 1] = rest;
    for (Index i = 0; i < n; ++i) rotations_[static_cast<std::size_t>(i)].apply(column[i], column[i + 1]);
    const double length = std::hypot(column[n], column[n + 1]);
    rotations_.push_back({.cosine = column[n] / length, .sine = column[n + 1] / length});
    column[n] = length;
    right_side_.push_back(0.0);
    rotations_.back().apply(right_side_[static_cast<std::size_t>(n)], right_side_[static_cast<std::size_t>(n + 1)]);
    columns_.emplace_back(column.head(n + 1));
    const bool adds = rest > 1e-15 * before;
    image /= rest;
    if (adds) directions_.push_back(std::move(image));
    return adds;
  }

  /// Return the combination of steps with the least residual.
  [[nodiscard]] VectorXd combination() const {
    const Index n = count();
    VectorXd shares(n);
    for (Index i = n - 1; i >= 0; --i) {
      double sum = right_side_[static_cast<std::size_t>(i)];
      for (Index j = i + 1; j < n; ++j) sum -= columns_[static_cast<std::size_t>(j)][i] * shares[j];
      shares[i] = sum / columns_[static_cast<std::size_t>(i)][i];
    }
    VectorXd result = VectorXd::Zero(directions_.front().size());
    for (Index i = 0; i < n; ++i) result += shares[i] * steps_[static_cast<std::size_t>(i)];
    return result;
  }

 private:
  struct Rotation {
    void apply(double& first, double& second) const {
      const double turned = cosine * first + sine * second;
      second = cosine * second - sine * first;
      first = turned;
    }
    double cosine;
    double sine;
  };

  std::vector<VectorXd> directions_;
  std::vector<VectorXd> steps_;    // stored, since preconditioning their combination takes as long as another product
  std::vector<VectorXd> columns_;  // columns of the triangular matrix that rotations make of the Hessenberg matrix
  std::vector<Rotation> rotations_;
  std::vector<double> right_side_;  // rotated in the same way; its last entry is the residual
};

}  // namespace

KrylovSolution solve_krylov(const LinearOperator& matrix, const LinearOperator& preconditioner, const VectorXd& right,
                            const VectorXd& guess, const KrylovTolerance& tolerance, std::optional<VectorXd> residual) {
  // Systems that no preconditioner suits, such as those of shells that bend, take as many directions as unknowns.
  const Index max_directions = right.size() > tolerance.small_system ? kMaxDirections : right.size();
  const Index max_products = std::max<Index>(kMaxProducts, max_directions);
  KrylovSolution solution{.unknowns = guess, .products = 0, .residual = 0.0};
  double small = tolerance.absolute;
  for (bool is_first = true;; is_first = false) {
    if (!residual) {
      residual = matrix(solution.unknowns);
      *residual = right - *residual;
      ++solution.products;
    }
    const double before = solution.residual;
    solution.residual = residual->norm();
    if (is_first) small = std::max(small, tolerance.relative * solution.residual);
    const bool stagnates = !is_first && !(solution.residual < kStagnation * before);
    if (!(solution.residual > small) || stagnates || solution.products >= max_products) return solution;
    Arnoldi space(*std::move(residual));
    residual.reset();
    for (bool adds = true; adds && space.residual() > small && space.count() < max_directions;) {
      VectorXd step = preconditioner(space.last());
      VectorXd image = matrix(step);
      adds = space.extend(std::move(step), std::move(image));
      ++solution.products;
    }
    solution.unknowns += space.combination();
    if (space.residual() <= small) {
      solution.residual = space.residual();
      return solution;
    }
  }
}

}  // namespace viscoroll::detail

#include "influence/sphere_product.hpp"

#include <algorithm>
#include <cmath>

#include "dense_products.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Below so many multiplications threads cost more than they save.
constexpr double kWorthThreads = 4e6;

/// Of products in one table: 40 MB of matrices.
constexpr double kMostJointOperations = 2e7;

/// So long that images do not meet.
int phi_period(WindowShape shape) { return RealFft::fast_length(2 * shape.phi_nodes - 1); }

std::size_t frequencies(int period) { return static_cast<std::size_t>(period / 2 + 1); }

/// Each power of the metric is a convolution of its own.
std::vector<ConvolutionTerm> local_terms(const SphereInfluence& influence) {
  const std::size_t components = influence.components();
  const std::size_t tables = influence.local.size() / influence.powers;
  std::vector<ConvolutionTerm> terms;
  for (std::size_t power = 0; power < influence.powers; ++power) {
    for (std::size_t p = 0; p < components; ++p) {
      for (std::size_t q = 0; q < components; ++q) {
        const SignedEntry source = entry_of(p, q);
        terms.push_back({.result = power * components + p,
                         .table = power * tables + static_cast<std::size_t>(source.entry),
                         .operand = power * components + q,
                         .sign = source.sign});
      }
    }
  }
  return terms;
}

/// Of the products between some thetas, at all frequencies along phi.
double matrix_operations(WindowShape shape, std::size_t components, Index thetas) {
  const auto lines = static_cast<double>(components) * static_cast<double>(thetas);
  return 8.0 * static_cast<double>(frequencies(phi_period(shape))) * lines * lines;
}

double local_operations(WindowShape shape, const SphereInfluence& influence) {
  const std::size_t components = influence.components();
  const std::size_t fields = influence.powers * components;
  return SpectralProduct(shape, doubled(shape)).operations(fields, fields * components, fields);
}

/// The influence between the nodes of a window, in one table.
SphereInfluence joined(const SphereInfluence& influence, WindowShape shape, int first_theta) {
  const Index thetas = shape.theta_nodes;
  const std::size_t components = influence.components();
  const std::size_t tables = influence.local.size() / influence.powers;
  const MatrixXd displaced = influence.displaced.middleRows(first_theta, thetas);
  const MatrixXd loaded = influence.loaded.middleRows(first_theta, thetas);
  const Eigen::ArrayXd root = influence.root.segment(first_theta, thetas);
  SphereInfluence all{.degrees = std::vector(influence.degrees.size(), SphereTable(shape.phi_nodes - 1, thetas)),
                      .displaced = MatrixXd::Identity(thetas, thetas),
                      .loaded = MatrixXd::Identity(thetas, thetas),
                      .local = {},
                      .root = root};
  for (std::size_t t = 0; t < all.degrees.size(); ++t) {
    const SignedEntry source = entry_of(t / components, t % components);
    for (int j = 1 - shape.phi_nodes; j < shape.phi_nodes; ++j) {
      MatrixXd& slice = all.degrees[t].slice(j);
      slice = displaced * influence.degrees[t].slice(j) * loaded.transpose();
      for (std::size_t power = 0; power < influence.powers; ++power) {
        const Table& table = influence.local[power * tables + static_cast<std::size_t>(source.entry)];
        const Eigen::VectorXd metric = root.pow(static_cast<double>(power) - 1.0);
        slice += source.sign * MatrixXd::NullaryExpr(thetas, thetas, [&](Index k, Index from) {
                   return metric[k] * metric[from] * table(j, static_cast<int>(k - from));
                 });
      }
    }
  }
  return all;
}

}  // namespace

SphereProduct make_sphere_product(WindowShape shape, int first_theta, const SphereInfluence& influence, int threads,
                                  Watch& watch) {
  const std::size_t components = influence.components();
  const double joint = matrix_operations(shape, components, shape.theta_nodes);
  const bool pays =
      influence.powers > 0 && joint < kMostJointOperations &&
      joint < matrix_operations(shape, components, influence.loaded.cols()) + local_operations(shape, influence);
  if (pays) return {shape, 0, joined(influence, shape, first_theta), threads, watch};
  return {shape, first_theta, influence, threads, watch};
}

SphereProduct::SphereProduct(WindowShape shape, int first_theta, const SphereInfluence& influence, int threads,
                             Watch& watch)
    : shape_(shape),
      components_(static_cast<Index>(influence.components())),
      displaced_(influence.displaced.middleRows(first_theta, shape.theta_nodes)),
      loaded_(influence.loaded.middleRows(first_theta, shape.theta_nodes)),
      period_(phi_period(shape)),
      fft_(period_),
      spectrum_(frequencies(period_)) {
  const Index thetas = loaded_.cols();
  const Index lines = components_ * thetas;
  for (Eigen::MatrixXcd& matrix : spectrum_) matrix.resize(lines, lines);
  parallel_for(static_cast<std::size_t>(lines), threads, watch, "transforming tables",
               [&](std::size_t i, const Worker& worker) {
                 RealBuffer line(static_cast<std::size_t>(period_));
                 ComplexBuffer transformed(spectrum_.size());
                 const auto column = static_cast<Index>(i);  // matrices are stored by columns, tables, too
                 for (Index row = 0; row < lines; ++row) {
                   const Index table = components_ * (row / thetas) + column / thetas;
                   const SphereTable& degrees = influence.degrees[static_cast<std::size_t>(table)];
                   std::ranges::fill(line, 0.0);
                   for (int j = 1 - shape_.phi_nodes; j < shape_.phi_nodes; ++j) {
                     line[static_cast<std::size_t>((j + period_) % period_)] =
                         degrees.slice(j)(row % thetas, column % thetas) / period_;
                   }
                   fft_.forward(line.data(), transformed.data());
                   for (std::size_t f = 0; f < spectrum_.size(); ++f) spectrum_[f](row, column) = transformed[f];
                 }
                 worker.checkpoint();
               });
  if (influence.local.empty()) return;
  const Eigen::ArrayXd root = influence.root.segment(first_theta, shape.theta_nodes);
  for (std::size_t power = 0; power < influence.powers; ++power) {
    metric_.emplace_back(root.pow(static_cast<double>(power) - 1.0).replicate(shape.phi_nodes, 1));
  }
  local_.emplace(shape, influence.local, local_terms(influence), threads, watch);
}

Eigen::ArrayXXd SphereProduct::apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const {
  const Index thetas = loaded_.cols();
  const Index lines = components_ * thetas;
  const auto count = static_cast<Index>(spectrum_.size());
  Eigen::MatrixXcd transformed(lines, count);
  RealBuffer line(static_cast<std::size_t>(period_));
  ComplexBuffer half(spectrum_.size());
  const Eigen::Map<Eigen::VectorXd> nodes(line.data(), shape_.phi_nodes);
  for (Index p = 0; p < components_; ++p) {
    const Eigen::Map<const MatrixXd> of_nodes(loads.col(p).data(), shape_.theta_nodes, shape_.phi_nodes);
    const MatrixXd of_thetas = of_nodes.transpose() * loaded_;
    for (Index k = 0; k < thetas; ++k) {
      std::ranges::fill(line, 0.0);
      Eigen::Map<Eigen::VectorXd>(line.data(), shape_.phi_nodes) = of_thetas.col(k);
      fft_.forward(line.data(), half.data());
      transformed.row(p * thetas + k) = Eigen::Map<const Eigen::RowVectorXcd>(half.data(), count);
    }
  }

  const double work = static_cast<double>(count) * static_cast<double>(lines) * static_cast<double>(lines);
  parallel_for(spectrum_.size(), work < kWorthThreads ? 1 : threads, watch, "solving contact",
               [&](std::size_t f, const Worker&) {
                 auto column = transformed.col(static_cast<Index>(f));
                 column = multiplied(spectrum_[f], column);
               });

  Eigen::ArrayXXd result(loads.rows(), components_);
  MatrixXd of_thetas(shape_.phi_nodes, thetas);
  for (Index p = 0; p < components_; ++p) {
    for (Index k = 0; k < thetas; ++k) {
      Eigen::Map<Eigen::RowVectorXcd>(half.data(), count) = transformed.row(p * thetas + k);
      fft_.backward(half.data(), line.data());
      of_thetas.col(k) = nodes;
    }
    Eigen::Map<MatrixXd>(result.col(p).data(), shape_.theta_nodes, shape_.phi_nodes) =
        displaced_ * of_thetas.transpose();
  }
  if (local_) add_local(loads, result, threads, watch);
  return result;
}

double SphereProduct::operations() const {
  return matrix_operations(shape_, static_cast<std::size_t>(components_), loaded_.cols()) +
         (local_ ? local_->operations() : 0.0);
}

void SphereProduct::add_local(const Eigen::ArrayXXd& loads, Eigen::ArrayXXd& result, int threads, Watch& watch) const {
  const auto powers = static_cast<Index>(metric_.size());
  Eigen::ArrayXXd weighted(loads.rows(), powers * components_);
  for (Index field = 0; field < weighted.cols(); ++field) {
    weighted.col(field) = metric_[static_cast<std::size_t>(field / components_)] * loads.col(field % components_);
  }
  const Eigen::ArrayXXd moved = local_->apply(weighted, threads, watch);
  for (Index field = 0; field < moved.cols(); ++field) {
    result.col(field % components_) += metric_[static_cast<std::size_t>(field / components_)] * moved.col(field);
  }
}

}  // namespace viscoroll::detail

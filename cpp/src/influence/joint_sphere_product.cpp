#include "influence/joint_sphere_product.hpp"

#include <algorithm>

#include "base/dense_products.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

int phi_period(WindowShape shape) { return RealFft::fast_length(2 * shape.phi_nodes - 1); }

std::size_t frequencies(int period) { return static_cast<std::size_t>(period / 2 + 1); }

/// Displacement along P due to forces along Q: [offset -reach ... reach, thetas * loaded theta + displaced theta].
MatrixXd table_of(int p, int q, WindowShape shape, int first_theta, const SphereInfluence& influence,
                  const OrderPhases& phases, const Worker& worker) {
  const Index thetas = shape.theta_nodes;
  const int reach = shape.phi_nodes - 1;
  const Index half_theta = std::max<Index>(-first_theta, first_theta + thetas - 1);
  const auto orders = static_cast<Index>(influence.orders.size());
  MatrixXd real(orders, thetas * thetas);
  MatrixXd imaginary(orders, thetas * thetas);
  for (Index m = 0; m < orders; ++m) {
    const Eigen::MatrixXcd all = sum_between(influence.orders[static_cast<std::size_t>(m)], p, q, half_theta);
    const Eigen::MatrixXcd own = all.block(half_theta + first_theta, half_theta + first_theta, thetas, thetas);
    real.row(m) = own.real().reshaped().transpose();
    imaginary.row(m) = own.imag().reshaped().transpose();
    worker.checkpoint();
  }
  const OrderPhases::Sums sums = phases(real, imaginary);
  MatrixXd table(2 * reach + 1, thetas * thetas);
  table.bottomRows(reach + 1) = sums.even + sums.odd;
  table.topRows(reach + 1) = (sums.even - sums.odd).colwise().reverse();

  const SignedEntry source = entry_of(static_cast<std::size_t>(p), static_cast<std::size_t>(q));
  const Eigen::ArrayXd root = influence.root.segment(influence.half_theta() + first_theta, thetas);
  const std::size_t tables = influence.powers == 0 ? 0 : influence.local.size() / influence.powers;
  for (std::size_t power = 0; power < influence.powers; ++power) {
    const Table& local = influence.local[power * tables + static_cast<std::size_t>(source.entry)];
    const Eigen::ArrayXd metric = root.pow(static_cast<double>(power) - 1.0);
    for (Index from = 0; from < thetas; ++from) {
      for (Index to = 0; to < thetas; ++to) {
        const double factor = source.sign * metric[to] * metric[from];
        for (int j = -reach; j <= reach; ++j) {
          table(j + reach, from * thetas + to) += factor * local(j, static_cast<int>(to - from));
        }
      }
    }
  }
  return table;
}

}  // namespace

JointSphereProduct::JointSphereProduct(WindowShape shape, int first_theta, const SphereInfluence& influence,
                                       int threads, Watch& watch)
    : shape_(shape),
      components_(static_cast<Index>(influence.components())),
      period_(phi_period(shape)),
      fft_(period_),
      spectrum_(frequencies(period_)) {
  const Index thetas = shape.theta_nodes;
  const Index lines = components_ * thetas;
  const int reach = shape.phi_nodes - 1;
  for (Eigen::MatrixXcd& matrix : spectrum_) matrix.resize(lines, lines);
  const OrderPhases phases(static_cast<int>(influence.orders.size()), reach, influence.phi_spacing);
  parallel_for(static_cast<std::size_t>(components_ * components_), threads, watch, "transforming tables",
               [&](std::size_t pair, const Worker& worker) {
                 const Index p = static_cast<Index>(pair) / components_;
                 const Index q = static_cast<Index>(pair) % components_;
                 const MatrixXd table =
                     table_of(static_cast<int>(p), static_cast<int>(q), shape, first_theta, influence, phases, worker);
                 worker.checkpoint();
                 RealBuffer line(static_cast<std::size_t>(period_));
                 ComplexBuffer transformed(spectrum_.size());
                 for (Index i = 0; i < table.cols(); ++i) {
                   std::ranges::fill(line, 0.0);
                   for (int j = -reach; j <= reach; ++j) {
                     line[static_cast<std::size_t>((j + period_) % period_)] = table(j + reach, i) / period_;
                   }
                   fft_.forward(line.data(), transformed.data());
                   for (std::size_t f = 0; f < spectrum_.size(); ++f) {
                     spectrum_[f](p * thetas + i % thetas, q * thetas + i / thetas) = transformed[f];
                   }
                 }
               });
}

double JointSphereProduct::operations(WindowShape shape, std::size_t components) {
  const auto lines = static_cast<double>(components) * shape.theta_nodes;
  return 8.0 * static_cast<double>(frequencies(phi_period(shape))) * lines * lines;
}

double JointSphereProduct::operations() const { return operations(shape_, static_cast<std::size_t>(components_)); }

Eigen::ArrayXXd JointSphereProduct::apply(const Eigen::ArrayXXd& loads, int /*threads*/, Watch& /*watch*/) const {
  const Index thetas = shape_.theta_nodes;
  const auto count = static_cast<Index>(spectrum_.size());
  Eigen::MatrixXcd transformed(components_ * thetas, count);
  RealBuffer line(static_cast<std::size_t>(period_));
  ComplexBuffer half(spectrum_.size());
  const Eigen::Map<Eigen::ArrayXd> nodes(line.data(), shape_.phi_nodes);
  for (Index row = 0; row < transformed.rows(); ++row) {
    const Eigen::Map<const Eigen::ArrayXXd> load(loads.col(row / thetas).data(), thetas, shape_.phi_nodes);
    std::ranges::fill(line, 0.0);
    for (Index j = 0; j < shape_.phi_nodes; ++j) line[static_cast<std::size_t>(j)] = load(row % thetas, j);
    fft_.forward(line.data(), half.data());
    transformed.row(row) = Eigen::Map<const Eigen::RowVectorXcd>(half.data(), count);
  }
  for (Index f = 0; f < count; ++f) {
    transformed.col(f) = multiplied(spectrum_[static_cast<std::size_t>(f)], transformed.col(f));
  }
  Eigen::ArrayXXd result(loads.rows(), components_);
  for (Index row = 0; row < transformed.rows(); ++row) {
    Eigen::Map<Eigen::RowVectorXcd>(half.data(), count) = transformed.row(row);
    fft_.backward(half.data(), line.data());
    Eigen::Map<Eigen::ArrayXXd> moved(result.col(row / thetas).data(), thetas, shape_.phi_nodes);
    moved.row(row % thetas) = nodes.transpose();
  }
  return result;
}

}  // namespace viscoroll::detail

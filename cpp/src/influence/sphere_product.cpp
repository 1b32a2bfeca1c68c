#include "influence/sphere_product.hpp"

#include <algorithm>
#include <cmath>

namespace viscoroll::detail {
namespace {

/// Below so many multiplications threads cost more than they save.
constexpr double kWorthThreads = 4e6;

std::size_t frequencies(int period) { return static_cast<std::size_t>(period / 2 + 1); }

}  // namespace

SphereProduct::SphereProduct(WindowShape shape, int first_theta, const std::vector<SphereTable>& tables, int threads,
                             Watch& watch)
    : shape_(shape),
      components_(tables.size() == 1 ? 1 : 3),
      period_(RealFft::fast_length(2 * shape.phi_nodes - 1)),
      fft_(period_),
      spectrum_(frequencies(period_)) {
  const int columns = shape.theta_nodes;
  const int rows = components_ * columns;
  for (Eigen::MatrixXcd& matrix : spectrum_) matrix.resize(rows, rows);
  parallel_for(static_cast<std::size_t>(rows), threads, watch, "transforming tables",
               [&](std::size_t row, const Worker& worker) {
                 RealBuffer line(static_cast<std::size_t>(period_));
                 ComplexBuffer transformed(spectrum_.size());
                 const int p = static_cast<int>(row) / columns;
                 const int k = static_cast<int>(row) % columns;
                 for (int column = 0; column < rows; ++column) {
                   const SphereTable& table = tables[static_cast<std::size_t>(components_ * p + column / columns)];
                   std::ranges::fill(line, 0.0);
                   for (int j = 1 - shape_.phi_nodes; j < shape_.phi_nodes; ++j) {
                     line[static_cast<std::size_t>((j + period_) % period_)] =
                         table.slice(j)(first_theta + k, first_theta + column % columns) / period_;
                   }
                   fft_.forward(line.data(), transformed.data());
                   for (std::size_t f = 0; f < spectrum_.size(); ++f) {
                     spectrum_[f](static_cast<Eigen::Index>(row), column) = transformed[f];
                   }
                 }
                 worker.checkpoint();
               });
}

Eigen::ArrayXXd SphereProduct::apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const {
  const Eigen::Index columns = shape_.theta_nodes;
  const Eigen::Index lines = components_ * columns;
  const auto count = static_cast<Eigen::Index>(spectrum_.size());
  Eigen::MatrixXcd transformed(lines, count);
  RealBuffer line(static_cast<std::size_t>(period_));
  ComplexBuffer half(spectrum_.size());
  for (Eigen::Index l = 0; l < lines; ++l) {
    std::ranges::fill(line, 0.0);
    for (Eigen::Index i = 0; i < shape_.phi_nodes; ++i) {
      line[static_cast<std::size_t>(i)] = loads(i * columns + l % columns, l / columns);
    }
    fft_.forward(line.data(), half.data());
    transformed.row(l) = Eigen::Map<const Eigen::RowVectorXcd>(half.data(), count);
  }

  const double work = static_cast<double>(count) * static_cast<double>(lines) * static_cast<double>(lines);
  parallel_for(spectrum_.size(), work < kWorthThreads ? 1 : threads, watch, "solving contact",
               [&](std::size_t f, const Worker&) {
                 auto column = transformed.col(static_cast<Eigen::Index>(f));
                 column = (spectrum_[f] * column).eval();
               });

  Eigen::ArrayXXd result(loads.rows(), components_);
  for (Eigen::Index l = 0; l < lines; ++l) {
    Eigen::Map<Eigen::RowVectorXcd>(half.data(), count) = transformed.row(l);
    fft_.backward(half.data(), line.data());
    for (Eigen::Index i = 0; i < shape_.phi_nodes; ++i) {
      result(i * columns + l % columns, l / columns) = line[static_cast<std::size_t>(i)];
    }
  }
  return result;
}

}  // namespace viscoroll::detail

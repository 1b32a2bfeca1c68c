#include "influence/spectral_product.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "instruction_sets.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;

constexpr std::size_t kColumns = 4;     // taken at a time: a cache line of every row
constexpr std::size_t kRows = 16;       // taken at a time
constexpr Index kThreadedSize = 20000;  // nodes below which starting threads costs more than they save

std::size_t parts(std::size_t count, std::size_t size) { return (count + size - 1) / size; }

std::size_t unsigned_size(int count) { return static_cast<std::size_t>(count); }

/// Copy `count` columns of `rows` rows to lines, and the other way.
void gather(const cplx* rows, std::size_t row_stride, std::size_t row_count, std::size_t count, cplx* lines,
            std::size_t line_stride) {
  for (std::size_t row = 0; row < row_count; ++row) {
    for (std::size_t c = 0; c < count; ++c) lines[c * line_stride + row] = rows[row * row_stride + c];
  }
}

void scatter(const cplx* lines, std::size_t line_stride, std::size_t row_count, std::size_t count, cplx* rows,
             std::size_t row_stride) {
  for (std::size_t row = 0; row < row_count; ++row) {
    for (std::size_t c = 0; c < count; ++c) rows[row * row_stride + c] = lines[c * line_stride + row];
  }
}

/// sum += sign * factor * line, for complex numbers as pairs of real ones
VISCOROLL_BEST_INSTRUCTIONS
void add_product(double sign, const double* factor, const double* line, std::size_t count, double* sum) {
  for (std::size_t i = 0; i < 2 * count; i += 2) {
    const double real = factor[i] * line[i] - factor[i + 1] * line[i + 1];
    const double imaginary = factor[i] * line[i + 1] + factor[i + 1] * line[i];
    sum[i] += sign * real;
    sum[i + 1] += sign * imaginary;
  }
}

const double* as_pairs(const cplx* numbers) { return reinterpret_cast<const double*>(numbers); }
double* as_pairs(cplx* numbers) { return reinterpret_cast<double*>(numbers); }

}  // namespace

WindowShape doubled(const WindowShape& shape) {
  return {ComplexFft::fast_length(2 * shape.phi_nodes - 1), RealFft::fast_length(2 * shape.theta_nodes - 1)};
}

SpectralProduct::SpectralProduct(WindowShape window, WindowShape period)
    : window_(window),
      period_(period),
      columns_(unsigned_size(period.theta_nodes / 2 + 1)),
      row_stride_(cache_line_stride(columns_)),
      column_stride_(cache_line_stride(unsigned_size(period.phi_nodes))),
      theta_fft_(period.theta_nodes),
      phi_fft_(period.phi_nodes) {}

int SpectralProduct::useful_threads(int threads) const { return period_.size() < kThreadedSize ? 1 : threads; }

ComplexBuffer SpectralProduct::transform(const std::function<void(int, double*, int)>& fill, int threads,
                                         Watch& watch) const {
  const std::size_t rows = unsigned_size(period_.phi_nodes);
  const double normalization = 1.0 / static_cast<double>(period_.size());
  ComplexBuffer half(rows * row_stride_);
  const std::size_t row_parts = parts(rows, kRows);
  const int useful = useful_threads(threads);
  std::vector<RealBuffer> lines(worker_count(row_parts, useful), RealBuffer(unsigned_size(period_.theta_nodes)));
  parallel_for(row_parts, useful, watch, "transforming tables", [&](std::size_t part, const Worker& worker) {
    RealBuffer& line = lines[worker.number];
    for (std::size_t row = part * kRows; row < std::min(rows, (part + 1) * kRows); ++row) {
      fill(static_cast<int>(row), line.data(), period_.theta_nodes);
      for (double& value : line) value *= normalization;
      theta_fft_.forward(line.data(), half.data() + row * row_stride_);
    }
  });
  ComplexBuffer spectrum(columns_ * column_stride_);
  parallel_for(parts(columns_, kColumns), useful, watch, "transforming tables", [&](std::size_t part, const Worker&) {
    const std::size_t first = part * kColumns;
    const std::size_t count = std::min(kColumns, columns_ - first);
    cplx* columns = spectrum.data() + first * column_stride_;
    gather(half.data() + first, row_stride_, rows, count, columns, column_stride_);
    phi_fft_.forward(columns, count, column_stride_);
  });
  return spectrum;
}

Eigen::ArrayXXd SpectralProduct::apply(const Eigen::ArrayXXd& operands, const std::vector<SpectralTerm>& terms,
                                       std::size_t results, int threads, Watch& watch) const {
  const Index theta_nodes = window_.theta_nodes;
  Eigen::ArrayXXd values(window_.size(), static_cast<Index>(results));
  apply(
      static_cast<std::size_t>(operands.cols()),
      [&](int row, std::size_t field, double* line) {
        std::copy_n(operands.col(static_cast<Index>(field)).data() + row * theta_nodes, theta_nodes, line);
      },
      terms, results,
      [&](int row, std::size_t result, const double* line) {
        std::copy_n(line, theta_nodes, values.col(static_cast<Index>(result)).data() + row * theta_nodes);
      },
      threads, watch);
  return values;
}

double SpectralProduct::operations(std::size_t fields, std::size_t terms, std::size_t results) const {
  const double points = static_cast<double>(period_.phi_nodes) * period_.theta_nodes;
  const double transform = 2.5 * points * std::log2(points);
  return static_cast<double>(fields + results) * transform + static_cast<double>(terms) * 4.0 * points;
}

void SpectralProduct::apply(std::size_t fields, const Fill& fill, const std::vector<SpectralTerm>& terms,
                            std::size_t results, const Take& take, int threads, Watch& watch) const {
  constexpr const char* kStage = "solving the contact equations";
  const std::size_t rows = unsigned_size(window_.phi_nodes);
  const std::size_t field_size = rows * row_stride_;
  const int useful = useful_threads(threads);
  const std::size_t row_parts = parts(rows, kRows);

  workspaces_.resize(worker_count(std::max(row_parts, parts(columns_, kColumns)), useful));
  for (Workspace& work : workspaces_) {
    work.row.resize(unsigned_size(period_.theta_nodes));
    work.lines.resize(fields * kColumns * column_stride_);
    work.sums.resize(kColumns * column_stride_);
  }
  half_.resize(std::max(fields, results) * field_size);

  parallel_for(row_parts, useful, watch, kStage, [&](std::size_t part, const Worker& worker) {
    RealBuffer& line = workspaces_[worker.number].row;
    for (std::size_t row = part * kRows; row < std::min(rows, (part + 1) * kRows); ++row) {
      for (std::size_t field = 0; field < fields; ++field) {
        std::ranges::fill(line, 0.0);
        fill(static_cast<int>(row), field, line.data());
        theta_fft_.forward(line.data(), half_.data() + field * field_size + row * row_stride_);
      }
    }
  });

  parallel_for(parts(columns_, kColumns), useful, watch, kStage, [&](std::size_t part, const Worker& worker) {
    Workspace& work = workspaces_[worker.number];
    const std::size_t first = part * kColumns;
    const std::size_t count = std::min(kColumns, columns_ - first);
    for (std::size_t field = 0; field < fields; ++field) {
      cplx* lines = work.lines.data() + field * kColumns * column_stride_;
      gather(half_.data() + field * field_size + first, row_stride_, rows, count, lines, column_stride_);
      for (std::size_t c = 0; c < count; ++c) {
        std::fill(lines + c * column_stride_ + rows, lines + (c + 1) * column_stride_, cplx());
      }
      phi_fft_.forward(lines, count, column_stride_);
    }
    for (std::size_t result = 0; result < results; ++result) {
      std::ranges::fill(work.sums, cplx());
      for (const SpectralTerm& term : terms) {
        if (term.result != result) continue;
        add_product(term.sign, as_pairs(term.spectrum->data() + first * column_stride_),
                    as_pairs(work.lines.data() + term.operand * kColumns * column_stride_), count * column_stride_,
                    as_pairs(work.sums.data()));
      }
      phi_fft_.backward(work.sums.data(), count, column_stride_);
      scatter(work.sums.data(), column_stride_, rows, count, half_.data() + result * field_size + first, row_stride_);
    }
  });

  parallel_for(row_parts, useful, watch, kStage, [&](std::size_t part, const Worker& worker) {
    RealBuffer& line = workspaces_[worker.number].row;
    for (std::size_t row = part * kRows; row < std::min(rows, (part + 1) * kRows); ++row) {
      for (std::size_t result = 0; result < results; ++result) {
        theta_fft_.backward(half_.data() + result * field_size + row * row_stride_, line.data());
        take(static_cast<int>(row), result, line.data());
      }
    }
  });
}

}  // namespace viscoroll::detail

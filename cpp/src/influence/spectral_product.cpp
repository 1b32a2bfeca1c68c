#include "influence/spectral_product.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>

#include "base/instruction_sets.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using cplx = std::complex<double>;

constexpr std::size_t kColumns = ColumnBlocks::kColumns;
constexpr std::size_t kRows = 16;       // rows that are processed together
constexpr Index kThreadedSize = 20000;  // nodes below which starting threads costs more than it saves

std::size_t parts(std::size_t count, std::size_t size) { return (count + size - 1) / size; }

std::size_t unsigned_size(int count) { return static_cast<std::size_t>(count); }

/// sum += sign * factor * line, for complex numbers stored as pairs of real ones
VISCOROLL_BEST_INSTRUCTIONS
void add_signed_product(double sign, const double* factor, const double* line, std::size_t count, double* sum) {
  for (std::size_t i = 0; i < 2 * count; i += 2) {
    const double real = factor[i] * line[i] - factor[i + 1] * line[i + 1];
    const double imaginary = factor[i] * line[i + 1] + factor[i + 1] * line[i];
    sum[i] += sign * real;
    sum[i + 1] += sign * imaginary;
  }
}

const double* as_pairs(const cplx* numbers) { return reinterpret_cast<const double*>(numbers); }
double* as_pairs(cplx* numbers) { return reinterpret_cast<double*>(numbers); }

/// Extend a line given from the middle on to the whole period: an even line, to which an odd one is added.
void mirror(double* line, const double* odd, int length) {
  for (int k = 1; 2 * k < length; ++k) {
    line[length - k] = line[k] - odd[k];
    line[k] += odd[k];
  }
}

/// Inverse of `mirror`.
void split(double* line, double* odd, int length) {
  odd[0] = 0.0;
  for (int k = 1; 2 * k < length; ++k) {
    odd[k] = 0.5 * (line[k] - line[length - k]);
    line[k] = 0.5 * (line[k] + line[length - k]);
  }
}

/// Indices of an even and an odd field, or of one of them, whose lines are transformed as one.
struct FieldPair {
  std::optional<std::size_t> even;
  std::optional<std::size_t> odd;
};

std::vector<FieldPair> paired(const std::vector<FieldPart>& parts) {
  std::vector<FieldPair> all;
  for (const FieldPart& part : parts) {
    const auto member = part.odd ? &FieldPair::odd : &FieldPair::even;
    auto free = std::ranges::find_if(all, [&](const FieldPair& pair) { return !(pair.*member); });
    if (free == all.end()) free = all.emplace(all.end());
    (*free).*member = part.field;
  }
  return all;
}

WindowShape fast_period(int phi_nodes, int theta_nodes) {
  return {RealFft::fast_length(phi_nodes), RealFft::fast_length(theta_nodes)};
}

}  // namespace

WindowShape doubled(const WindowShape& shape) { return doubled(shape, shape); }

WindowShape doubled(const WindowShape& shape, const WindowShape& loaded) {
  return fast_period(shape.phi_nodes + loaded.phi_nodes - 1, shape.theta_nodes + loaded.theta_nodes - 1);
}

SpectralProduct::SpectralProduct(WindowShape window, WindowShape period)
    : window_(window),
      period_(period),
      columns_(unsigned_size(period.theta_nodes / 2 + 1)),
      line_stride_(cache_line_stride<double>(unsigned_size(period.phi_nodes))),
      column_stride_(cache_line_stride<cplx>(unsigned_size(period.phi_nodes / 2 + 1))),
      theta_fft_(period.theta_nodes),
      phi_fft_(period.phi_nodes) {}

int SpectralProduct::useful_threads(int threads) const { return period_.size() < kThreadedSize ? 1 : threads; }

cplx* SpectralProduct::half_row(Workspace& work, std::size_t place) const {
  return work.half_rows.data() + place * ColumnBlocks::count(columns_) * kColumns;
}

void SpectralProduct::reserve(std::size_t parts_of_fields, int threads) const {
  const std::size_t rows = unsigned_size(window_.phi_nodes);
  const std::size_t blocks = ColumnBlocks::count(columns_);
  workspaces_.resize(worker_count(std::max(parts(rows, kRows), blocks), useful_threads(threads)));
  for (Workspace& work : workspaces_) {
    work.row.resize(unsigned_size(period_.theta_nodes));
    work.odd_row.resize(columns_);
    work.half_rows.resize(std::min(rows, kRows) * blocks * kColumns);
    work.lines.resize(kColumns * line_stride_);
    work.scratch.resize(RealFft::scratch_size(period_.phi_nodes));
    work.columns.resize(parts_of_fields * kColumns * column_stride_);
    work.sums.resize(kColumns * column_stride_);
  }
  rows_.resize(parts_of_fields, rows, columns_);
}

void SpectralProduct::for_rows(int threads, Watch& watch,
                               const std::function<void(std::size_t, std::size_t, Workspace&)>& function) const {
  const std::size_t rows = unsigned_size(window_.phi_nodes);
  parallel_for(parts(rows, kRows), useful_threads(threads), watch, "solving the contact equations",
               [&](std::size_t part, const Worker& worker) {
                 function(part * kRows, std::min(rows, (part + 1) * kRows), workspaces_[worker.number]);
               });
}

ComplexBuffer SpectralProduct::transform(const std::function<void(int, double*, int)>& fill, bool odd, int threads,
                                         Watch& watch) const {
  const std::size_t rows = unsigned_size(period_.phi_nodes);
  const std::size_t blocks = ColumnBlocks::count(columns_);
  const std::size_t length = unsigned_size(period_.theta_nodes);
  const double normalization = 1.0 / static_cast<double>(period_.size());
  const int useful = useful_threads(threads);
  const std::size_t workers = worker_count(std::max(parts(rows, kRows), blocks), useful);

  ColumnBlocks half;
  half.resize(1, rows, columns_);
  std::vector<RealBuffer> lines(workers, RealBuffer(std::max(length, kColumns * line_stride_)));
  std::vector<ComplexBuffer> half_rows(workers, ComplexBuffer(std::min(rows, kRows) * blocks * kColumns));
  parallel_for(parts(rows, kRows), useful, watch, "transforming tables", [&](std::size_t part, const Worker& worker) {
    double* line = lines[worker.number].data();
    cplx* transformed = half_rows[worker.number].data();
    const std::size_t first = part * kRows;
    const std::size_t end = std::min(rows, first + kRows);
    for (std::size_t row = first; row < end; ++row) {
      fill(static_cast<int>(row), line, static_cast<int>(columns_));
      for (std::size_t k = 0; k < columns_; ++k) line[k] *= normalization;
      for (std::size_t k = 1; 2 * k < length; ++k) line[length - k] = odd ? -line[k] : line[k];
      if (odd) line[0] = 0.0;
      theta_fft_.forward(line, transformed + (row - first) * blocks * kColumns);
    }
    half.store(transformed, 0, odd, first, end);
  });

  ComplexBuffer spectrum(blocks * kColumns * column_stride_);
  std::vector<RealBuffer> scratches(workers, RealBuffer(RealFft::scratch_size(period_.phi_nodes)));
  parallel_for(blocks, useful, watch, "transforming tables", [&](std::size_t block, const Worker& worker) {
    double* columns = lines[worker.number].data();
    half.gather(0, block, columns, line_stride_);
    phi_fft_.forward(columns, spectrum.data() + block * kColumns * column_stride_,
                     {.count = std::min(kColumns, columns_ - block * kColumns),
                      .real_stride = line_stride_,
                      .spectrum_stride = column_stride_},
                     scratches[worker.number].data());
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

double SpectralProduct::operations(WindowShape period, std::size_t fields, std::size_t terms, std::size_t results) {
  const double points = static_cast<double>(period.phi_nodes) * period.theta_nodes;
  const double transform = 2.5 * points * std::log2(points);
  return static_cast<double>(fields + results) * transform + static_cast<double>(terms) * 4.0 * points;
}

void SpectralProduct::apply(std::size_t fields, const Fill& fill, const std::vector<SpectralTerm>& terms,
                            std::size_t results, const Take& take, int threads, Watch& watch) const {
  const auto both_parts = [](std::size_t count) {
    Parts all;
    for (std::size_t field = 0; field < count; ++field) {
      all.push_back({.field = field, .odd = false});
      all.push_back({.field = field, .odd = true});
    }
    return all;
  };
  reserve(2 * std::max(fields, results), threads);
  for_rows(threads, watch, [&](std::size_t first, std::size_t end, Workspace& work) {
    for (std::size_t field = 0; field < fields; ++field) {
      for (std::size_t row = first; row < end; ++row) {
        std::ranges::fill(work.row, 0.0);
        fill(static_cast<int>(row), field, work.row.data());
        theta_fft_.forward(work.row.data(), half_row(work, row - first));
      }
      rows_.store(work.half_rows.data(), 2 * field, false, first, end);
      rows_.store(work.half_rows.data(), 2 * field + 1, true, first, end);
    }
  });
  multiply(both_parts(fields), terms, both_parts(results), threads, watch);
  for_rows(threads, watch, [&](std::size_t first, std::size_t end, Workspace& work) {
    for (std::size_t result = 0; result < results; ++result) {
      rows_.load(2 * result, false, first, end, work.half_rows.data());
      rows_.load(2 * result + 1, true, first, end, work.half_rows.data());
      for (std::size_t row = first; row < end; ++row) {
        theta_fft_.backward(half_row(work, row - first), work.row.data());
        take(static_cast<int>(row), result, work.row.data());
      }
    }
  });
}

void SpectralProduct::apply_mirrored(const std::vector<bool>& odd, const Fill& fill,
                                     const std::vector<SpectralTerm>& terms, std::size_t results, const Take& take,
                                     int threads, Watch& watch) const {
  Parts operands;
  for (std::size_t field = 0; field < odd.size(); ++field) operands.push_back({.field = field, .odd = odd[field]});
  Parts sums(results);
  for (const SpectralTerm& term : terms) {
    sums[term.result] = {.field = term.result, .odd = odd[term.operand] != term.odd};
  }
  reserve(std::max(odd.size(), results), threads);
  const int length = period_.theta_nodes;
  const std::vector<FieldPair> given = paired(operands);
  const std::vector<FieldPair> wanted = paired(sums);
  for_rows(threads, watch, [&](std::size_t first, std::size_t end, Workspace& work) {
    for (const auto& [even_field, odd_field] : given) {
      for (std::size_t row = first; row < end; ++row) {
        std::fill_n(work.row.begin(), columns_, 0.0);
        std::ranges::fill(work.odd_row, 0.0);
        if (even_field) fill(static_cast<int>(row), *even_field, work.row.data());
        if (odd_field) fill(static_cast<int>(row), *odd_field, work.odd_row.data());
        mirror(work.row.data(), work.odd_row.data(), length);
        theta_fft_.forward(work.row.data(), half_row(work, row - first));
      }
      if (even_field) rows_.store(work.half_rows.data(), *even_field, false, first, end);
      if (odd_field) rows_.store(work.half_rows.data(), *odd_field, true, first, end);
    }
  });
  multiply(operands, terms, sums, threads, watch);
  for_rows(threads, watch, [&](std::size_t first, std::size_t end, Workspace& work) {
    for (const auto& [even_result, odd_result] : wanted) {
      if (!even_result || !odd_result) std::ranges::fill(work.half_rows, cplx());
      if (even_result) rows_.load(*even_result, false, first, end, work.half_rows.data());
      if (odd_result) rows_.load(*odd_result, true, first, end, work.half_rows.data());
      for (std::size_t row = first; row < end; ++row) {
        theta_fft_.backward(half_row(work, row - first), work.row.data());
        if (odd_result) split(work.row.data(), work.odd_row.data(), length);
        if (even_result) take(static_cast<int>(row), *even_result, work.row.data());
        if (odd_result) take(static_cast<int>(row), *odd_result, work.odd_row.data());
      }
    }
  });
}

void SpectralProduct::multiply(const Parts& operands, const std::vector<SpectralTerm>& terms, const Parts& results,
                               int threads, Watch& watch) const {
  const std::size_t rows = unsigned_size(window_.phi_nodes);
  const std::size_t size = kColumns * column_stride_;
  parallel_for(ColumnBlocks::count(columns_), useful_threads(threads), watch, "solving the contact equations",
               [&](std::size_t block, const Worker& worker) {
                 Workspace& work = workspaces_[worker.number];
                 const std::size_t count = std::min(kColumns, columns_ - block * kColumns);
                 const RealFft::Lines lines{
                     .count = count, .real_stride = line_stride_, .spectrum_stride = column_stride_};
                 for (std::size_t part = 0; part < operands.size(); ++part) {
                   rows_.gather(part, block, work.lines.data(), line_stride_);
                   for (std::size_t c = 0; c < count; ++c) {
                     double* line = work.lines.data() + c * line_stride_;
                     std::fill(line + rows, line + line_stride_, 0.0);
                   }
                   phi_fft_.forward(work.lines.data(), work.columns.data() + part * size, lines, work.scratch.data());
                 }
                 for (std::size_t part = 0; part < results.size(); ++part) {
                   std::ranges::fill(work.sums, cplx());
                   for (std::size_t operand = 0; operand < operands.size(); ++operand) {
                     const bool odd = operands[operand].odd;
                     for (const SpectralTerm& term : terms) {
                       if (term.result != results[part].field || term.operand != operands[operand].field) continue;
                       if ((odd != term.odd) != results[part].odd) continue;
                       // Odd parts and spectra are stored without their factor -i, and (-i)^2 = -1.
                       const double sign = odd && term.odd ? -term.sign : term.sign;
                       add_signed_product(sign, as_pairs(term.spectrum->data() + block * size),
                                          as_pairs(work.columns.data() + operand * size), count * column_stride_,
                                          as_pairs(work.sums.data()));
                     }
                   }
                   phi_fft_.backward(work.sums.data(), work.lines.data(), lines, work.scratch.data());
                   rows_.scatter(work.lines.data(), line_stride_, part, block);
                 }
               });
}

}  // namespace viscoroll::detail

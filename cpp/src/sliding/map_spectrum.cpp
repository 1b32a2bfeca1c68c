#include "sliding/map_spectrum.hpp"

#include <algorithm>
#include <cstddef>

#include "influence/fft.hpp"

namespace viscoroll::detail {

MapSpectrum::MapSpectrum(const std::vector<double>& values, WindowShape shape) : shape_(shape) {
  const auto rows = static_cast<std::size_t>(shape.phi_nodes);
  const auto columns = static_cast<std::size_t>(shape.theta_nodes);
  const std::size_t half = columns / 2 + 1;
  const double normalization = 1.0 / static_cast<double>(shape.size());
  values_.resize(rows * half);
  const RealFft theta_fft(shape.theta_nodes);
  RealBuffer line(columns);
  ComplexBuffer half_row(half);
  for (std::size_t row = 0; row < rows; ++row) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(row * columns), columns, line.begin());
    theta_fft.forward(line.data(), half_row.data());
    std::ranges::copy(half_row, values_.begin() + static_cast<std::ptrdiff_t>(row * half));
  }
  const ComplexFft phi_fft(shape.phi_nodes);
  ComplexBuffer column(rows);
  for (std::size_t j = 0; j < half; ++j) {
    for (std::size_t row = 0; row < rows; ++row) column[row] = normalization * values_[row * half + j];
    phi_fft.forward(column.data());
    for (std::size_t row = 0; row < rows; ++row) values_[row * half + j] = column[row];
  }
}

}  // namespace viscoroll::detail

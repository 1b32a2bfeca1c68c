/// @file
/// @brief Fourier coefficients of a periodic map.
#pragma once

#include <complex>
#include <vector>

#include "influence/spectral_product.hpp"

namespace viscoroll::detail {

/// @brief Fourier coefficients f_k of a map, sum f_k exp(i (k_x xi + k_z z)).
class MapSpectrum {
 public:
  /// @param[in] values values of the map, row by row
  /// @param[in] shape nodes of one period
  MapSpectrum(const std::vector<double>& values, WindowShape shape);

  /// @brief Call function(i, j, coefficient, weight) for the waves with j >= 0. A sum over all waves of a quantity that
  /// is equal at opposite waves is the sum of weight times this quantity. The wave (0, 0) and the highest wave along xi
  /// of an even number of nodes, which has no direction, are left out.
  template <class Function>
  void for_waves(const Function& function) const {
    const int columns = shape_.theta_nodes;
    for (int row = 0; row < shape_.phi_nodes; ++row) {
      const int i = 2 * row <= shape_.phi_nodes ? row : row - shape_.phi_nodes;
      if (2 * i == shape_.phi_nodes) continue;
      for (int j = 0; 2 * j <= columns; ++j) {
        if (i == 0 && j == 0) continue;
        const double weight = j == 0 || 2 * j == columns ? 1.0 : 2.0;
        function(i, j, at(row, j), weight);
      }
    }
  }

  /// @return coefficient of the wave with the same numbers as in `for_waves`
  [[nodiscard]] std::complex<double> operator()(int i, int j) const { return at(i < 0 ? i + shape_.phi_nodes : i, j); }

 private:
  [[nodiscard]] std::complex<double> at(int row, int j) const {
    return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(shape_.theta_nodes / 2 + 1) +
                   static_cast<std::size_t>(j)];
  }

  WindowShape shape_;
  std::vector<std::complex<double>> values_;  // [row][j]
};

}  // namespace viscoroll::detail

/// @file
/// @brief Chebyshev series of smooth functions of one variable, on panels that are halved until each series is
/// resolved.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "base/dense_products.hpp"

namespace viscoroll::detail {

constexpr int kPanelNodes = 16;               ///< number of Chebyshev nodes and terms of a panel
constexpr double kLargestPanelRatio = 512.0;  ///< ratio of k^2 over a panel, over which a power law is resolved

/// @brief Series of several functions of x on [low, high], low > 0.
///
/// Row f contains the coefficients of function f in T_0 ... T_15 of a coordinate that runs from -1 to 1, linear in ln
/// x. Compliances decrease like powers of the order, so that they are smoothest in its logarithm. A panel with `low` =
/// 0 contains constants.
template <class Scalar>
struct Panel {
  double low;
  double high;
  Eigen::Matrix<Scalar, Eigen::Dynamic, kPanelNodes, Eigen::RowMajor> series;
};

/// @return Chebyshev nodes of the first kind in the logarithm of [low, high]
[[nodiscard]] inline std::vector<double> chebyshev_nodes(double low, double high, int count) {
  std::vector<double> nodes;
  for (int j = 0; j < count; ++j) {
    const double coordinate = std::cos(std::numbers::pi * (j + 0.5) / count);
    nodes.push_back(std::sqrt(low * high) * std::pow(high / low, 0.5 * coordinate));
  }
  return nodes;
}

/// @return matrix from values at `chebyshev_nodes` to coefficients; the values are the columns of the left factor
[[nodiscard]] inline Eigen::MatrixXd chebyshev_transform(int count) {
  Eigen::MatrixXd matrix(count, count);
  for (int node = 0; node < count; ++node) {
    for (int term = 0; term < count; ++term) {
      matrix(node, term) = (term == 0 ? 1.0 : 2.0) / count * std::cos(std::numbers::pi * (node + 0.5) * term / count);
    }
  }
  return matrix;
}

/// @return Chebyshev nodes of a panel
[[nodiscard]] inline std::array<double, kPanelNodes> panel_nodes(double low, double high) {
  std::array<double, kPanelNodes> nodes{};
  std::ranges::copy(chebyshev_nodes(low, high, kPanelNodes), nodes.begin());
  return nodes;
}

/// @return matrix from values at the nodes of a panel to coefficients; the values are the columns of the left factor
[[nodiscard]] inline const Eigen::Matrix<double, kPanelNodes, kPanelNodes, Eigen::RowMajor>& panel_transform() {
  static const Eigen::Matrix<double, kPanelNodes, kPanelNodes, Eigen::RowMajor> transform =
      chebyshev_transform(kPanelNodes);
  return transform;
}

/// @return coefficients of functions from their values at the nodes of a panel
template <class Scalar>
[[nodiscard]] Eigen::Matrix<Scalar, Eigen::Dynamic, kPanelNodes> to_series(
    const Eigen::Matrix<Scalar, Eigen::Dynamic, kPanelNodes>& values) {
  // Real and imaginary parts are adjacent in memory, so that one real product transforms both.
  constexpr Eigen::Index kParts = Eigen::NumTraits<Scalar>::IsComplex ? 2 : 1;
  const Eigen::Index rows = kParts * values.rows();
  Eigen::Matrix<Scalar, Eigen::Dynamic, kPanelNodes> series;
  series.setZero(values.rows(), kPanelNodes);
  add_product(Eigen::Map<const Eigen::MatrixXd>(reinterpret_cast<const double*>(values.data()), rows, kPanelNodes),
              panel_transform(),
              Eigen::Map<Eigen::MatrixXd>(reinterpret_cast<double*>(series.data()), rows, kPanelNodes));
  return series;
}

/// @brief Append a panel of constants on [0, high].
template <class Scalar>
void append_constants(double high, const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& values,
                      std::vector<Panel<Scalar>>& panels) {
  Panel<Scalar> panel{0.0, high, {}};
  panel.series.setZero(values.size(), kPanelNodes);
  panel.series.col(0) = values;
  panels.push_back(std::move(panel));
}

/// @brief Append panels that resolve functions on [low, high]. Panels of at most `kLargestPanelRatio` are halved until
/// they are resolved.
/// @param[in] low,high interval, low > 0
/// @param[in] sample returns the values of all functions at the nodes of a panel, one column for each node
/// @param[in] resolved returns whether the series of a panel is resolved
/// @param[out] panels receives the panels in ascending order
template <class Scalar, class Sample, class Resolved>
void append_panels(double low, double high, const Sample& sample, const Resolved& resolved,
                   std::vector<Panel<Scalar>>& panels) {
  constexpr double kSmallestRatio = 1.05;  // the remainder of a panel this narrow is round-off
  if (high / low <= kLargestPanelRatio) {
    const Eigen::Matrix<Scalar, Eigen::Dynamic, kPanelNodes> values = sample(panel_nodes(low, high));
    Panel<Scalar> panel{low, high, to_series(values)};
    if (high / low < kSmallestRatio || resolved(panel)) {
      panels.push_back(std::move(panel));
      return;
    }
  }
  const double middle = std::sqrt(low * high);
  append_panels(low, middle, sample, resolved, panels);
  append_panels(middle, high, sample, resolved, panels);
}

}  // namespace viscoroll::detail

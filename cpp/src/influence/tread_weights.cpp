#include "influence/tread_weights.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "influence/gauss_legendre.hpp"
#include "section/section_element.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

/// Add the weights of lines at position z, which lies in an element (between every other line), or too far from the
/// faces for them to have an effect.
void add_shares(const ArrayXd& lines, double z, double weight, Eigen::Ref<Eigen::VectorXd> shares) {
  const double place = std::min(std::abs(z), lines[lines.size() - 1]);
  if (place < lines[0]) return;
  Index first = 0;
  while (first + 4 < lines.size() && place > lines[first + 2]) first += 2;
  const auto values = quadratic_shares((place - lines[first + 1]) / (0.5 * (lines[first + 2] - lines[first])));
  for (std::size_t n = 0; n < 3; ++n) shares[first + static_cast<Index>(n)] += weight * values[n];
}

/// Positions between which the weights are polynomials, on both sides of the middle.
std::vector<double> pieces(const ArrayXd& lines, double from, double to) {
  std::vector<double> places{from, to};
  for (Index i = 0; i < lines.size(); i += 2) {
    for (const double z : {lines[i], -lines[i]}) {
      if (z > from && z < to) places.push_back(z);
    }
  }
  std::ranges::sort(places);
  return places;
}

/// +1, or -1 on the other side of the middle if odd.
double side(double z, bool odd) { return odd && z < 0.0 ? -1.0 : 1.0; }

}  // namespace

MatrixXd patch_mean_weights(const ArrayXd& lines, const TreadColumns& columns, Index count, bool odd) {
  MatrixXd shares = MatrixXd::Zero(lines.size(), count);
  const auto [abscissas, weights] = gauss_legendre(2);  // exact for polynomials of third degree
  const double face = lines[lines.size() - 1];
  for (Index k = 0; k < count; ++k) {
    const double middle = columns.spacing * static_cast<double>(columns.first + k);
    const double from = std::max(middle - 0.5 * columns.spacing, -face);
    const double to = std::min(middle + 0.5 * columns.spacing, face);
    if (!(from < to)) continue;  // beyond a face, where there is no pressure
    const std::vector<double> places = pieces(lines, from, to);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const double length = places[i + 1] - places[i];
      for (Index point = 0; point < abscissas.size(); ++point) {
        const double z = places[i] + 0.5 * length * (1.0 + abscissas[point]);
        add_shares(lines, z, side(z, odd) * 0.5 * weights[point] * length / (to - from), shares.col(k));
      }
    }
  }
  return shares;
}

MatrixXd node_weights(const ArrayXd& lines, const TreadColumns& columns, Index count, bool odd) {
  MatrixXd shares = MatrixXd::Zero(lines.size(), count);
  for (Index k = 0; k < count; ++k) {
    const double z = columns.spacing * static_cast<double>(columns.first + k);
    if (odd && z == 0.0) continue;
    add_shares(lines, z, side(z, odd), shares.col(k));
  }
  return shares;
}

}  // namespace viscoroll::detail

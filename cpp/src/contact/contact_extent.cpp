#include "contact/contact_extent.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ranges>

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Half length of the ellipse with the second moment of `weights` along `coordinate`, about their mean or a `center`.
double semi_axis(const Eigen::ArrayXd& coordinate, const Eigen::ArrayXd& weights, std::optional<double> center) {
  const double sum = std::max(weights.sum(), std::numeric_limits<double>::min());
  const double middle = center ? *center : (coordinate * weights).sum() / sum;
  return 2.0 * std::sqrt(((coordinate - middle).square() * weights).sum() / sum);
}

/// Distance between the outer sides of the outermost patches [m]; 0 without contact.
double width(const SurfaceGrid& grid, const Eigen::ArrayXd& z) {
  if (z.size() == 0) return 0.0;
  return z.maxCoeff() - z.minCoeff() + grid.radius * grid.theta_spacing;
}

constexpr Index kSkippedNodes = 2;  // at the edge, where the pressure alternates
constexpr Index kFittedNodes = 8;
constexpr Index kFewestFittedNodes = 5;  // one more than the coefficients
constexpr double kSideOfPatch = 0.5;     // distance from a node [spacings]

/// Least-squares fit of p^2 at distances d from the side of the outermost patch [spacings], A + B d + C d^2 + D / d.
/// A p^2 that is linear at the edge has A and B; C is its curvature. The outermost patches are loaded although the edge
/// does not lie at their side, which changes p^2 further inside by D / d (docs/theory/pressure-and-length.md).
/// @return matrix that maps the values at some nodes to A, B and C
Eigen::Matrix3Xd fit_at_edge(Index nodes) {
  const auto last = static_cast<double>(nodes - 1);
  const ArrayXd distance = ArrayXd::LinSpaced(nodes, 0.0, last) + static_cast<double>(kSkippedNodes) + kSideOfPatch;
  Eigen::MatrixX4d terms(nodes, 4);
  terms << ArrayXd::Ones(nodes), distance, distance.square(), distance.inverse();
  return terms.colPivHouseholderQr().solve(Eigen::MatrixXd::Identity(nodes, nodes)).topRows<3>();
}

/// Position of the edge of the contact beyond the outermost node of a row [spacings].
struct EdgePosition {
  double distance = kSideOfPatch;  ///< in [-1/2, 1]
  double uncertainty = kSideOfPatch;
};

/// @return zero of the fit to the squared pressures of some nodes, as distance from the outermost node [spacings];
/// infinite if p^2 does not fall to zero
double zero_of_fit(const ArrayXd& squares, Index nodes) {
  static const std::array<Eigen::Matrix3Xd, kFittedNodes - kFewestFittedNodes + 1> fits{fit_at_edge(5), fit_at_edge(6),
                                                                                        fit_at_edge(7), fit_at_edge(8)};
  const Eigen::Vector3d c =
      fits[static_cast<std::size_t>(nodes - kFewestFittedNodes)] * squares.segment(kSkippedNodes, nodes).matrix();
  const double discriminant = c[1] * c[1] - 4.0 * c[0] * c[2];
  if (!(c[1] > 0.0 && discriminant >= 0.0)) return std::numeric_limits<double>::infinity();
  return kSideOfPatch + 2.0 * c[0] / (c[1] + std::sqrt(discriminant));
}

/// @param[in] pressure of the outermost nodes, from the edge inwards; those at the other edge of a short row are not
/// fitted either
EdgePosition edge_position(const ArrayXd& pressure) {
  const Index nodes = std::min(pressure.size() - 2 * kSkippedNodes, kFittedNodes);
  if (nodes < kFewestFittedNodes || !(pressure.maxCoeff() > 0.0)) return {};
  const ArrayXd squares = (pressure / pressure.maxCoeff()).square();
  const double zero = zero_of_fit(squares, nodes);
  // A p^2 that vanishes beyond the first node out of contact belongs to a pressure that rises more steeply than a
  // square root, up to a jump, whose edge lies at the side of the outermost patch on average.
  constexpr double kNextNode = 1.0;
  if (zero > kNextNode) {
    const double excess = (zero - kSideOfPatch) / (kNextNode - kSideOfPatch);
    return {.distance = kSideOfPatch + (kNextNode - kSideOfPatch) / excess, .uncertainty = kSideOfPatch};
  }
  // A front of a few spacings bends p^2 within the fitted nodes, so that fewer nodes have another zero.
  const double closer = zero_of_fit(squares, kFewestFittedNodes);
  return {.distance = std::max(zero, -kSideOfPatch), .uncertainty = std::min(std::abs(zero - closer), kSideOfPatch)};
}

/// Positions, in a list of contact nodes, of the nodes of each row along the path.
std::vector<std::vector<Index>> rows_along_path(const std::vector<Index>& contact, Index rows) {
  std::vector<std::vector<Index>> found(static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < contact.size(); ++i) {
    found[static_cast<std::size_t>(contact[i] % rows)].push_back(static_cast<Index>(i));
  }
  return found;
}

/// Pressures of the outermost nodes of a row, as far as they are neighbors.
/// @param[in] row positions of nodes in the list of contact nodes, from the edge inwards
/// @param[in] numbers numbers of the contact nodes
/// @param[in] stride difference of the numbers of neighbors
ArrayXd pressure_at_edge(const auto& row, const std::vector<Index>& numbers, Index stride, const ArrayXd& pressure) {
  std::vector<Index> near;
  for (const Index i : row) {
    const auto number = [&](Index position) { return numbers[static_cast<std::size_t>(position)]; };
    if (!near.empty() && std::abs(number(i) - number(near.back())) != stride) break;
    near.push_back(i);
    if (near.size() == 2 * kSkippedNodes + kFittedNodes) break;
  }
  return pressure(near);
}

/// Length of a row along the path, and the uncertainty of its edges [m].
struct RowLength {
  double length = 0.0;
  double uncertainty = 0.0;
};

/// @return longest row along the path
RowLength longest_row(const SurfaceWindow& nodes, const std::vector<Index>& contact, const ArrayXd& pressure) {
  const ArrayXd x = nodes.x()(contact);
  const Index stride = nodes.shape().theta_nodes;
  const double spacing = nodes.grid().radius * nodes.grid().phi_spacing;
  RowLength longest;
  for (const std::vector<Index>& row : rows_along_path(contact, stride)) {
    if (row.empty()) continue;
    const double between_nodes = std::abs(x[row.front()] - x[row.back()]);
    if (between_nodes + 2.0 * spacing < longest.length) continue;
    const EdgePosition first = edge_position(pressure_at_edge(row, contact, stride, pressure));
    const EdgePosition last = edge_position(pressure_at_edge(std::views::reverse(row), contact, stride, pressure));
    const double length = between_nodes + spacing * (first.distance + last.distance);
    if (length > longest.length) longest = {length, spacing * (first.uncertainty + last.uncertainty)};
  }
  return longest;
}

}  // namespace

ContactExtent contact_extent(const SurfaceWindow& nodes, const std::vector<Eigen::Index>& contact,
                             const Eigen::ArrayXd& touching, const Eigen::ArrayXd& pressure,
                             std::optional<double> center_z) {
  const auto [length, uncertainty] = longest_row(nodes, contact, pressure);
  const double length_error = length > 0.0 ? uncertainty / length : 0.0;
  const double max_pressure = contact.empty() ? 0.0 : pressure.maxCoeff();
  if (nodes.window().is_line()) {
    return {.contact_area = length,
            .contact_length = length,
            .contact_length_error = length_error,
            .semi_axis_x = 0.5 * length,
            .semi_axis_z = std::nullopt,
            .contact_width = std::nullopt,
            .max_pressure = max_pressure};
  }
  const Eigen::ArrayXd z = nodes.z()(contact);
  return {.contact_area = touching.sum(),
          .contact_length = length,
          .contact_length_error = length_error,
          .semi_axis_x = semi_axis(nodes.x()(contact), touching, std::nullopt),
          .semi_axis_z = semi_axis(z, touching, center_z),
          .contact_width = width(nodes.grid(), z),
          .max_pressure = max_pressure};
}

}  // namespace viscoroll::detail

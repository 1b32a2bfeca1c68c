#include "influence/interpolated_orders.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/dense_products.hpp"
#include "modal/chebyshev_panels.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;

constexpr double kLowest = 8.0;          // order below which layers bend as a whole
constexpr double kMaxRangeRatio = 8.0;   // ratio of the orders at both ends of a range
constexpr double kOmittedTerms = 1e-15;  // size of the omitted terms of a polynomial
/// Orders per node above which interpolation costs less than the orders themselves.
constexpr double kOrdersPerNode = 1.5;

/// Distance in ln n of the zeros of the layers' determinants from the real axis. Those of a bonded layer lie at 70
/// degrees from the axis. Those of plates in bending lie at 45 degrees; their ranges turn out not to be resolved.
constexpr double kNearestZero = 1.2;

/// Number of nodes for a ratio of orders. Chebyshev terms decrease like powers of the sum of the semi-axes of the
/// ellipse around the range that reaches the zeros.
int node_count(double ratio) {
  const double reach = 2.0 * kNearestZero / std::log(ratio);  // relative to half the range
  return static_cast<int>(std::ceil(-std::log(kOmittedTerms) / std::asinh(reach))) + 1;
}

/// Indices of the first and of one past the last order of a band in [low, high).
std::pair<Index, Index> orders_within(const OrderBand& band, double low, double high) {
  const double* begin = band.orders.data();
  const double* end = begin + band.orders.size();
  const double* first = std::lower_bound(begin, end, low);
  return {first - begin, std::lower_bound(first, end, high) - begin};
}

Index count_within(const std::vector<OrderBand>& bands, double low, double high) {
  Index count = 0;
  for (const OrderBand& band : bands) {
    const auto [first, end] = orders_within(band, low, high);
    count += end - first;
  }
  return count;
}

void append(const Eigen::ArrayXd& more, Eigen::ArrayXd& all) {
  all.conservativeResize(all.size() + more.size());
  all.tail(more.size()) = more;
}

/// Chebyshev polynomials T_0, T_1, ... at the given places, one row each.
RowMajorMatrix chebyshev_terms(const Eigen::ArrayXd& places, Index count) {
  RowMajorMatrix terms(count, places.size());
  terms.row(0).setOnes();
  terms.row(1) = places.matrix().transpose();
  for (Index j = 2; j < count; ++j) {
    terms.row(j) = 2.0 * places.matrix().transpose().cwiseProduct(terms.row(j - 1)) - terms.row(j - 2);
  }
  return terms;
}

}  // namespace

InterpolatedOrders::InterpolatedOrders(const std::vector<OrderBand>& bands) : parts_(bands.size()) {
  double top = 0.0;
  for (const OrderBand& band : bands) top = std::max(top, band.orders[band.orders.size() - 1]);
  append_orders(-1.0, kLowest, bands);
  if (top <= kLowest) return;
  const auto count = static_cast<int>(std::ceil(std::log(top / kLowest) / std::log(kMaxRangeRatio)));
  const auto bound = [&](int i) { return kLowest * std::pow(top / kLowest, static_cast<double>(i) / count); };
  for (int i = 0; i < count; ++i) {
    const double high = i + 1 == count ? std::nextafter(top, std::numeric_limits<double>::infinity()) : bound(i + 1);
    const auto orders = static_cast<double>(count_within(bands, bound(i), high));
    const bool pays = orders > kOrdersPerNode * node_count(high / bound(i));
    pays ? append_polynomials(bound(i), high, bands) : append_orders(bound(i), high, bands);
  }
}

void InterpolatedOrders::append_polynomials(double low, double high, const std::vector<OrderBand>& bands) {
  const Index count = node_count(high / low);
  const Eigen::MatrixXd transform = chebyshev_transform(static_cast<int>(count)).colwise().reverse();
  const std::vector<double> descending = chebyshev_nodes(low, high, static_cast<int>(count));
  ranges_.push_back({.first = sampled_.size(),
                     .count = count,
                     .is_interpolated = true,
                     .last_terms = transform.transpose().bottomRows<2>()});
  append(Eigen::Map<const Eigen::ArrayXd>(descending.data(), count).reverse(), sampled_);
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const auto [first, end] = orders_within(bands[b], low, high);
    if (first == end) continue;
    const Eigen::ArrayXd orders = bands[b].orders.segment(first, end - first);
    const Eigen::ArrayXd places = (orders / std::sqrt(low * high)).log() * (2.0 / std::log(high / low));
    RowMajorMatrix basis = RowMajorMatrix::Zero(count, end - first);
    add_product(transform, chebyshev_terms(places, count), basis);
    parts_[b].push_back(
        {.range = ranges_.size() - 1, .first = first, .count = end - first, .basis = std::move(basis), .places = {}});
  }
}

void InterpolatedOrders::append_orders(double low, double high, const std::vector<OrderBand>& bands) {
  std::vector<std::tuple<double, std::size_t, Index>> orders;  // with band and index in the band
  for (std::size_t b = 0; b < bands.size(); ++b) {
    const auto [first, end] = orders_within(bands[b], low, high);
    for (Index i = first; i < end; ++i) orders.emplace_back(bands[b].orders[i], b, i);
    if (first == end) continue;
    parts_[b].push_back({.range = ranges_.size(), .first = first, .count = end - first, .basis = {}, .places = {}});
  }
  std::ranges::sort(orders);
  const Index before = sampled_.size();
  ranges_.push_back(
      {.first = before, .count = static_cast<Index>(orders.size()), .is_interpolated = false, .last_terms = {}});
  sampled_.conservativeResize(before + static_cast<Index>(orders.size()));
  for (Index place = before; const auto& [order, band, number] : orders) {
    sampled_[place] = order;
    parts_[band].back().places.push_back(place++);  // the orders of a band ascend
  }
}

void InterpolatedOrders::add_sums(std::size_t band, const RowMajorMatrix& terms, RowMajorMatrix& sums) const {
  for (const Part& part : parts_[band]) {
    const auto of_part = terms.middleRows(part.first, part.count);
    if (ranges_[part.range].is_interpolated) {
      const Range& range = ranges_[part.range];
      add_product(part.basis, of_part, sums.block(range.first, 0, range.count, terms.cols()));
      continue;
    }
    for (Index i = 0; i < part.count; ++i) {
      sums.row(part.places[static_cast<std::size_t>(i)]).head(terms.cols()) += of_part.row(i);
    }
  }
}

bool InterpolatedOrders::has_orders(std::size_t band, std::size_t range) const {
  return std::ranges::any_of(parts_[band], [range](const Part& part) { return part.range == range; });
}

}  // namespace viscoroll::detail

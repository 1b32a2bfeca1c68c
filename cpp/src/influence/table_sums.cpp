#include "influence/table_sums.hpp"

#include <algorithm>
#include <complex>
#include <numbers>
#include <span>
#include <utility>

#include "influence/waves.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using cplx = std::complex<double>;

double highest(const std::vector<OrderBand>& bands) {
  double highest = 0.0;
  for (const OrderBand& band : bands) highest = std::max(highest, band.orders[band.orders.size() - 1]);
  return highest;
}

std::vector<double> scaled(std::vector<double> orders, double factor) {
  for (double& order : orders) order *= factor;
  return orders;
}

/// Check the body before bands are made from it: arguments in braces are evaluated in order.
LayeredBody checked(LayeredBody body, double angular_speed) {
  require_layers_and_speed(body, angular_speed);
  return body;
}

OrderSum order_sum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh,
                   std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads,
                   Watch& watch, const LocalMetric& metric, double inertia_tolerance) {
  // If the wave number is m / sine, the speed Omega sine gives the frequency m Omega.
  const HarmonicBody harmonics(body, angular_speed * metric.sine, scaled(all_orders(phi_bands), 1.0 / metric.sine),
                               measured_order(mesh.rounded()) / metric.sine);
  auto spectrum = make_spectrum(harmonics, highest(theta_bands), threads, watch, inertia_tolerance);
  return {mesh, harmonics.radius(), std::move(phi_bands), theta_bands, std::move(spectrum), metric};
}

/// Forces along the line are not coupled to the others, so all other entries are 0.
cplx value(const Eigen::Matrix3cd& compliance, Entry entry) {
  switch (entry) {
    case Entry::rr:
      return compliance(0, 0);
    case Entry::rphi:
      return cplx(0.0, -1.0) * compliance(0, 1);
    case Entry::phiphi:
      return compliance(1, 1);
    case Entry::thetatheta:
      return compliance(2, 2);
    default:
      return 0.0;
  }
}

std::vector<Eigen::Matrix3cd> line_spectrum(const HarmonicBody& body, int threads, Watch& watch) {
  constexpr std::size_t kBlock = 16;  // orders that are solved together
  std::vector<IndexedOrder> orders;
  orders.reserve(body.orders().size());
  for (std::size_t i = 0; i < body.orders().size(); ++i) orders.push_back({.i = i, .n = 0.0});
  std::vector<Eigen::Matrix3cd> spectrum(orders.size());
  parallel_for((orders.size() + kBlock - 1) / kBlock, threads, watch, "solving layers",
               [&](std::size_t block, const Worker&) {
                 const std::size_t first = block * kBlock;
                 const std::size_t count = std::min(kBlock, orders.size() - first);
                 body.compliances(std::span(orders).subspan(first, count), std::span(spectrum).subspan(first, count));
               });
  return spectrum;
}

}  // namespace

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh, int threads, Watch& watch,
                       double inertia_tolerance)
    : CoatingSum{checked(body, angular_speed),
                 angular_speed,
                 mesh,
                 phi_bands(body, angular_speed, mesh.rounded()),
                 theta_bands(body, angular_speed, mesh.rounded(), 0.0, mesh.widest()),
                 threads,
                 watch,
                 {},
                 inertia_tolerance} {}

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh,
                       std::vector<OrderBand> phi_bands, const std::vector<OrderBand>& theta_bands, int threads,
                       Watch& watch, const LocalMetric& metric, double inertia_tolerance)
    : sum_(order_sum(body, angular_speed, mesh, std::move(phi_bands), theta_bands, threads, watch, metric,
                     inertia_tolerance)) {}

CoatingSum::CoatingSum(const LayeredBody& body, double angular_speed, const MeshOnBody& mesh, const LocalMetric& metric,
                       int threads, Watch& watch)
    : CoatingSum{checked(body, angular_speed),
                 angular_speed,
                 mesh,
                 phi_bands(body, angular_speed, mesh.rounded(), metric.exact_degree),
                 theta_bands(body, angular_speed, mesh.rounded(), metric.exact_degree),
                 threads,
                 watch,
                 metric} {}

LineSum::LineSum(std::vector<OrderBand> bands, const HarmonicBody& body, const MeshOnBody& mesh, int threads,
                 Watch& watch)
    : LineSum(std::move(bands), line_spectrum(body, threads, watch), body.radius(), mesh) {}

LineSum::LineSum(std::vector<OrderBand> bands, std::vector<Eigen::Matrix3cd> spectrum, double radius,
                 const MeshOnBody& mesh)
    : bands_(std::move(bands)), spectrum_(std::move(spectrum)), radius_(radius), mesh_(mesh) {}

std::vector<Table> LineSum::tables(const std::vector<TableRequest>& requests, int phi_reach, int /*theta_reach*/,
                                   int threads, Watch& watch) const {
  std::vector<Waves> waves;
  waves.reserve(bands_.size());
  for (const OrderBand& band : bands_) {
    waves.push_back(make_waves(band.orders, mesh_.phi_spacing(), std::min(band.reach, phi_reach)));
  }
  std::vector<Table> tables(requests.size(), Table(phi_reach, 0, false));
  parallel_for(requests.size(), threads, watch, "summing tables",
               [&](std::size_t i, const Worker&) { tables[i] = table(requests[i], phi_reach, waves); });
  return tables;
}

Table LineSum::table(const TableRequest& request, int phi_reach, const std::vector<Waves>& waves) const {
  const double scale = 1.0 / (2.0 * std::numbers::pi * radius_);
  const double spacing = mesh_.phi_spacing();
  Eigen::VectorXd even = Eigen::VectorXd::Zero(phi_reach + 1);
  Eigen::VectorXd odd = Eigen::VectorXd::Zero(phi_reach + 1);
  std::size_t order = 0;
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const OrderBand& band = bands_[b];
    Eigen::VectorXcd summand(band.orders.size());
    for (Index i = 0; i < band.orders.size(); ++i, ++order) {
      const double m = band.orders[i];
      const double patch = sinc(0.5 * m * spacing);
      const cplx received =
          request.power ? cplx(0.0, mesh_.turns() * m) * patch : std::polar(1.0, m * spacing * request.phi_shift);
      summand[i] = scale * band.weights[i] * patch * received * value(spectrum_[order], request.entry);
    }
    // Re[(cos + i sin)(a + i b)] = a cos - b sin
    even.head(waves[b].cosines.cols()) += waves[b].cosines.transpose() * summand.real();
    odd.head(waves[b].sines.cols()) -= waves[b].sines.transpose() * summand.imag();
  }
  Table table(phi_reach, 0, is_odd(request.entry));
  for (int j = 0; j <= phi_reach; ++j) {
    table.row(j)[0] = even[j] + odd[j];
    table.row(-j)[0] = even[j] - odd[j];
  }
  return table;
}

}  // namespace viscoroll::detail

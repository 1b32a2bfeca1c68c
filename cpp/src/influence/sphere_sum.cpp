#include "influence/sphere_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "influence/sampled_angles.hpp"
#include "influence/table_sums.hpp"
#include "influence/waves.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

/// Coefficients [power, node] of the polynomials that are 1 at one of the nodes and 0 at the others.
MatrixXd lagrange_coefficients(const Eigen::ArrayXd& nodes) {
  const Index count = nodes.size();
  MatrixXd coefficients = MatrixXd::Zero(count, count);
  for (Index i = 0; i < count; ++i) {
    auto polynomial = coefficients.col(i);
    polynomial[0] = 1.0;
    for (Index j = 0; j < count; ++j) {
      if (j == i) continue;
      const Eigen::VectorXd before = polynomial;
      polynomial *= -nodes[j];
      polynomial.tail(count - 1) += before.head(count - 1);
      polynomial /= nodes[i] - nodes[j];
    }
  }
  return coefficients;
}

/// Sampled metrics between the lowest one and 1. Tables are analytic in the metric except at the pole of the distance,
/// and errors decrease with the half width of the range.
Eigen::ArrayXd sampled_metrics(double lowest) {
  constexpr double kTolerance = 1e-5;  // a tenth of the error of the local metric
  const double width = 0.25 * (1.0 - lowest);
  const int count = width < kTolerance ? 1 : static_cast<int>(std::ceil(std::log(kTolerance) / std::log(width)));
  return 0.5 * (1.0 + lowest) + 0.5 * (1.0 - lowest) * ChebyshevNodes(std::clamp(count, 1, 12)).points();
}

/// Tables, on a surface that is flat on the scale of a wave, from which those of the sphere are made.
std::vector<TableRequest> flat_requests(const SphereRequest& request) {
  constexpr std::array kAll{Entry::rr, Entry::rphi, Entry::rtheta, Entry::phiphi, Entry::phitheta, Entry::thetatheta};
  std::vector<TableRequest> requests;
  for (const Entry entry : kAll) {
    if (!request.tangential && entry != Entry::rr) continue;
    requests.push_back(
        {.entry = entry, .power = request.power, .phi_shift = request.power ? 0.0 : request.collocation});
  }
  return requests;
}

using HarmonicsOf = std::shared_ptr<const Harmonics> EveryOtherDegree::*;

void set(std::array<Harmonics, 2> harmonics, HarmonicsOf which, SphericalOrder& order) {
  for (std::size_t side = 0; side < order.size(); ++side) {
    order[side].*which = std::make_shared<const Harmonics>(std::move(harmonics[side]));
  }
}

void share(const SphericalOrder& from, HarmonicsOf which, HarmonicsOf as, SphericalOrder& order) {
  for (std::size_t side = 0; side < order.size(); ++side) order[side].*as = from[side].*which;
}

}  // namespace

SphereSum::SphereSum(LayeredBody sphere, double angular_speed, const MeshOnBody& mesh, double exact_degree)
    : sphere_(std::move(sphere)),
      angular_speed_(angular_speed),
      mesh_(mesh),
      exact_degree_(mesh.rounded().max_order ? std::numeric_limits<double>::infinity() : exact_degree),
      highest_degree_(mesh.rounded().max_order.value_or(static_cast<int>(std::ceil(exact_end(exact_degree))))) {}

double SphereSum::values(const SphereRequest& request, int phi_reach, int half_theta) const {
  const double degrees = 0.5 * (highest_degree_ + 1.0) * (highest_degree_ + 2.0);
  const double harmonics = 2.0 * (request.tangential ? 3.0 : 1.0) * degrees * (half_theta + 1.0);
  if (!std::isfinite(exact_degree_)) return harmonics;
  constexpr double kPerNode = 2.0 + 4.0;  // table for phi of both signs, and its spectrum on the padded period
  constexpr double kRequests = 2.0;       // for displacements and for dissipated power
  const double nodes = (phi_reach + 1.0) * (2.0 * half_theta + 1.0);
  const auto powers = static_cast<double>(sampled_metrics(std::cos(mesh_.theta_spacing() * half_theta)).size());
  return harmonics + kRequests * kPerNode * nodes * powers * static_cast<double>(flat_requests(request).size());
}

std::vector<SphereInfluence> SphereSum::influences(const std::vector<SphereRequest>& requests, int phi_reach,
                                                   int half_theta, int threads, Watch& watch) const {
  const Eigen::ArrayXd offsets =
      mesh_.theta_spacing() * Eigen::ArrayXd::LinSpaced(2 * half_theta + 1, -half_theta, half_theta);
  std::vector<SphereInfluence> influences;
  influences.reserve(requests.size());
  for (const SphereRequest& request : requests) {
    influences.push_back({.orders = std::vector<SphericalOrder>(static_cast<std::size_t>(highest_degree_ + 1)),
                          .tangential = request.tangential,
                          .phi_spacing = mesh_.phi_spacing(),
                          .phi_reach = phi_reach,
                          .local = {},
                          .powers = 0,
                          .root = offsets.cos().sqrt()});
  }
  add_degrees(requests, influences, threads, watch);
  if (std::isfinite(exact_degree_)) add_local(requests, influences, half_theta, threads, watch);
  return influences;
}

void SphereSum::add_degrees(const std::vector<SphereRequest>& requests, std::vector<SphereInfluence>& influences,
                            int threads, Watch& watch) const {
  const std::size_t count = influences.front().orders.size();
  const Eigen::ArrayXd orders = Eigen::ArrayXd::LinSpaced(static_cast<Index>(count), 0.0, highest_degree_);
  const HarmonicBody body(sphere_, angular_speed_, {orders.begin(), orders.end()}, measured_order(mesh_.rounded()));
  const auto spectrum = make_spectrum(body, highest_degree_ + 1.0, threads, watch);
  const int half_theta = influences.front().half_theta();
  const Eigen::ArrayXd thetas =
      0.5 * std::numbers::pi + mesh_.theta_spacing() * Eigen::ArrayXd::LinSpaced(half_theta + 1, 0.0, half_theta);
  std::vector<ThetaPatches> patches;
  patches.reserve(requests.size());
  for (const SphereRequest& request : requests) {
    patches.emplace_back(half_theta + 1, mesh_.theta_spacing(), request.patch_load, highest_degree_);
  }
  const double scale = 1.0 / (2.0 * std::numbers::pi * body.radius() * body.radius());

  parallel_for(count, threads, watch, "summing degrees", [&](std::size_t i, const Worker& worker) {
    const int m = static_cast<int>(i);
    const auto compliances = degree_compliances(body, *spectrum, i, highest_degree_);
    worker.checkpoint();
    const double patch = sinc(0.5 * m * mesh_.phi_spacing());
    for (std::size_t r = 0; r < requests.size(); ++r) {
      const SphereRequest& request = requests[r];
      // Derivatives are averages over patches; displacements are evaluated somewhat downstream of the nodes.
      const cplx received = request.power ? cplx(0.0, mesh_.turns() * m) * patch
                                          : std::polar(1.0, m * request.collocation * mesh_.phi_spacing());
      const cplx factor = scale * (m == 0 ? 1.0 : 2.0) * patch * received;
      SphericalOrder& order = influences[r].orders[i];
      for (std::size_t side = 0; side < order.size(); ++side) order[side] = every_other(compliances, m, side, factor);
      const bool is_known = r > 0 && request.has_same_loads_as(requests[r - 1]);
      if (is_known) {
        share(influences[r - 1].orders[i], &EveryOtherDegree::loaded, &EveryOtherDegree::loaded, order);
      } else {
        set(patches[r].harmonics(m, highest_degree_, request.tangential), &EveryOtherDegree::loaded, order);
      }
      worker.checkpoint();
      if (request.power) {
        share(order, &EveryOtherDegree::loaded, &EveryOtherDegree::displaced, order);
      } else {
        set(harmonics_at(m, highest_degree_, thetas, request.tangential), &EveryOtherDegree::displaced, order);
      }
      worker.checkpoint();
    }
  });
}

EveryOtherDegree SphereSum::every_other(const std::vector<DegreeCompliance>& compliances, int order, std::size_t first,
                                        cplx factor) const {
  const auto count = static_cast<Index>((compliances.size() + 1 - first) / 2);
  EveryOtherDegree result;
  for (Eigen::ArrayXcd* values : {&result.radial, &result.mixed, &result.along, &result.across}) values->resize(count);
  for (Index row = 0; row < count; ++row) {
    const Index l = 2 * row + static_cast<Index>(first);
    const DegreeCompliance& c = compliances[static_cast<std::size_t>(l)];
    const cplx weight = factor * exact_share(static_cast<double>(order + l) + 0.5, exact_degree_);
    result.radial[row] = weight * c.radial;
    result.mixed[row] = weight * c.mixed;
    result.along[row] = weight * c.along;
    result.across[row] = weight * c.across;
  }
  return result;
}

void SphereSum::add_local(const std::vector<SphereRequest>& requests, std::vector<SphereInfluence>& influences,
                          int half_theta, int threads, Watch& watch) const {
  const int phi_reach = influences.front().phi_reach;
  const Eigen::ArrayXd metrics = sampled_metrics(influences.front().root.square().minCoeff());
  const MatrixXd coefficients = lagrange_coefficients(metrics);

  std::vector<TableRequest> flat;
  for (const SphereRequest& request : requests) std::ranges::copy(flat_requests(request), std::back_inserter(flat));
  for (Index i = 0; i < metrics.size(); ++i) {
    const CoatingSum sum(sphere_, angular_speed_, mesh_, {.sine = metrics[i], .exact_degree = exact_degree_}, threads,
                         watch);
    const std::vector<Table> tables = sum.tables(flat, phi_reach, 2 * half_theta, threads, watch);
    auto table = tables.begin();
    for (std::size_t r = 0; r < requests.size(); ++r) {
      const auto count = static_cast<std::ptrdiff_t>(flat_requests(requests[r]).size());
      SphereInfluence& influence = influences[r];
      influence.powers = static_cast<std::size_t>(metrics.size());
      for (Index power = 0; power < metrics.size(); ++power) {
        if (i == 0) {
          std::transform(table, table + count, std::back_inserter(influence.local), [](const Table& like) {
            return Table(like.phi_reach(), like.theta_reach(), like.mirror() < 0.0);
          });
        }
        for (std::ptrdiff_t t = 0; t < count; ++t) {
          add(coefficients(power, i), table[t], influence.local[static_cast<std::size_t>(power * count + t)]);
        }
      }
      table += count;
    }
  }
}

SphereInfluence with_wide_patches(const SphereInfluence& fine, double downstream, bool power) {
  constexpr int kStride = 2;
  const int middle = fine.half_theta();
  const Index half = (middle - 1) / kStride;
  const Index nodes = 2 * half + 1;
  const std::array<double, 4> share = wide_patch_shares(downstream);
  const int last = downstream > 0.0 ? 2 : 1;
  SphereInfluence coarse{.orders = {},
                         .tangential = fine.tangential,
                         .phi_spacing = kStride * fine.phi_spacing,
                         .phi_reach = (fine.phi_reach - (power ? 1 : 0) - last) / kStride,
                         .local = {},
                         .powers = fine.powers,
                         .root = fine.root(Eigen::seqN(middle - kStride * half, nodes, Eigen::fix<kStride>))};
  for (std::size_t m = 0; m < fine.orders.size(); ++m) {
    const double turn = static_cast<double>(m) * fine.phi_spacing;
    cplx factor = power ? 0.5 + 0.5 * std::cos(turn) : 1.0;
    cplx wide = 0.0;
    for (int dj = -1; dj <= 2; ++dj) wide += share[static_cast<std::size_t>(dj + 1)] * std::polar(1.0, turn * dj);
    factor *= wide;
    coarse.orders.push_back(with_wide_patches(fine.orders[m], factor, power));
  }
  for (const Table& table : fine.local) {
    const Table once = power ? widened(table, 1) : table;
    coarse.local.push_back(widened(once, kStride, downstream));
  }
  return coarse;
}

std::vector<Table> tables_around_equator(const SphereInfluence& influence) {
  const int theta_reach = 2 * influence.half_theta();
  const int reach = influence.phi_reach;
  const auto orders = static_cast<Index>(influence.orders.size());
  const std::size_t count = influence.tangential ? kEntries : 1;
  const OrderPhases phases(static_cast<int>(orders), reach, influence.phi_spacing);
  std::vector<Table> tables;
  for (std::size_t entry = 0; entry < count; ++entry) {
    constexpr std::array<int, kEntries> kPairs{0, 1, 2, 4, 5, 8};  // 3 P + Q of each entry
    Table table(reach, theta_reach, is_odd(static_cast<Entry>(entry)));
    for (std::size_t power = 0; power < influence.powers; ++power)
      add(1.0, influence.local[power * count + entry], table);
    MatrixXd real(orders, theta_reach + 1);
    MatrixXd imaginary(orders, theta_reach + 1);
    for (Index m = 0; m < orders; ++m) {
      const Eigen::VectorXcd sum = sum_across_equator(influence.orders[static_cast<std::size_t>(m)], kPairs[entry] / 3,
                                                      kPairs[entry] % 3, theta_reach);
      real.row(m) = sum.real();
      imaginary.row(m) = sum.imag();
    }
    const OrderPhases::Sums sums = phases(real, imaginary);
    for (int j = -reach; j <= reach; ++j) {
      const double side = j < 0 ? -1.0 : 1.0;
      for (int l = 0; l <= theta_reach; ++l) {
        table.row(j)[static_cast<std::size_t>(l)] += sums.even(std::abs(j), l) + side * sums.odd(std::abs(j), l);
      }
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace viscoroll::detail

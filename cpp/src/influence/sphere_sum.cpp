#include "influence/sphere_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "influence/coating_sum.hpp"
#include "influence/gauss_legendre.hpp"
#include "influence/legendre.hpp"
#include "influence/patch.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;

/// Values of the three harmonics of one order at some thetas, or their means over patches; a row for each degree. The
/// components of Y, Psi and Phi along (r, phi, theta) are (P, 0, 0), (0, i E, D) and (0, D, -i E).
struct Harmonics {
  MatrixXd p;
  MatrixXd d;  // dP/dtheta / sqrt(L)
  MatrixXd e;  // m P / (sin(theta) sqrt(L))
};

Harmonics harmonics_at(int order, int highest, const Eigen::ArrayXd& theta) {
  LegendreFunctions functions(order, highest, theta);
  Harmonics harmonics{.p = std::move(functions.value), .d = std::move(functions.slope), .e = {}};
  const Index count = harmonics.p.rows();
  Eigen::ArrayXd scale(count);
  for (Index row = 0; row < count; ++row) {
    const auto degree = static_cast<double>(order + row);
    scale[row] = degree > 0.0 ? 1.0 / std::sqrt(degree * (degree + 1.0)) : 0.0;
  }
  harmonics.d.array().colwise() *= scale;
  harmonics.e = (harmonics.p.array().colwise() * (scale * order)).rowwise() / theta.sin().transpose();
  return harmonics;
}

/// Points and weights of the patches of all nodes, with weights that sum to 1 on each.
struct Patches {
  Index points;  // of each patch
  Eigen::ArrayXd theta;
  Eigen::ArrayXd weight;

  Patches(const Eigen::ArrayXd& nodes, double spacing, PatchLoad load, int highest)
      : points(8 + static_cast<Index>(0.25 * spacing * highest)) {
    const auto [abscissas, weights] = gauss_legendre(static_cast<int>(points));
    theta.resize(nodes.size() * points);
    weight.resize(theta.size());
    for (Index k = 0; k < nodes.size(); ++k) {
      theta.segment(k * points, points) = nodes[k] + 0.5 * spacing * abscissas;
      auto share = weight.segment(k * points, points);
      // A force of 1 on the patch: what a traction gives is weighted by sin(theta).
      share = weights;
      if (load == PatchLoad::flat) share *= theta.segment(k * points, points).sin();
      share /= share.sum();
    }
  }

  [[nodiscard]] MatrixXd means(const MatrixXd& values) const {
    MatrixXd result(values.rows(), values.cols() / points);
    for (Index k = 0; k < result.cols(); ++k) {
      result.col(k) = values.middleCols(k * points, points) * weight.segment(k * points, points).matrix();
    }
    return result;
  }
  [[nodiscard]] Harmonics harmonics(int order, int highest) const {
    const Harmonics all = harmonics_at(order, highest, theta);
    return {.p = means(all.p), .d = means(all.d), .e = means(all.e)};
  }
};

/// What displaces along P under a load along Q, at one order m: the sum over the degrees, [k, k'].
class OrderTables {
 public:
  OrderTables(const Harmonics& seen, const Harmonics& loaded, const std::vector<DegreeCompliance>& compliances,
              const Eigen::ArrayXd& degree_weights)
      : seen_(seen), loaded_(loaded) {
    const auto count = static_cast<Index>(compliances.size());
    for (Eigen::ArrayXcd* values : {&radial_, &mixed_, &along_, &across_}) values->resize(count);
    for (Index l = 0; l < count; ++l) {
      const DegreeCompliance& c = compliances[static_cast<std::size_t>(l)];
      radial_[l] = degree_weights[l] * c.radial;
      mixed_[l] = degree_weights[l] * c.mixed;
      along_[l] = degree_weights[l] * c.along;
      across_[l] = degree_weights[l] * c.across;
    }
  }

  [[nodiscard]] Eigen::MatrixXcd operator()(int p, int q) const {
    const cplx i(0.0, 1.0);
    switch (3 * p + q) {
      case 0:
        return sum(seen_.p, radial_, loaded_.p);
      case 1:
        return -i * sum(seen_.p, mixed_, loaded_.e);
      case 2:
        return sum(seen_.p, mixed_, loaded_.d);
      case 3:
        return i * sum(seen_.e, mixed_, loaded_.p);
      case 4:
        return sum(seen_.e, along_, loaded_.e) + sum(seen_.d, across_, loaded_.d);
      case 5:
        return i * (sum(seen_.e, along_, loaded_.d) + sum(seen_.d, across_, loaded_.e));
      case 6:
        return sum(seen_.d, mixed_, loaded_.p);
      case 7:
        return -i * (sum(seen_.d, along_, loaded_.e) + sum(seen_.e, across_, loaded_.d));
      default:
        return sum(seen_.d, along_, loaded_.d) + sum(seen_.e, across_, loaded_.e);
    }
  }

 private:
  static Eigen::MatrixXcd sum(const MatrixXd& left, const Eigen::ArrayXcd& middle, const MatrixXd& right) {
    Eigen::MatrixXcd result(left.cols(), right.cols());
    result.real() = left.transpose() * (middle.real().matrix().asDiagonal() * right);
    result.imag() = left.transpose() * (middle.imag().matrix().asDiagonal() * right);
    return result;
  }

  const Harmonics& seen_;
  const Harmonics& loaded_;
  Eigen::ArrayXcd radial_, mixed_, along_, across_;
};

Eigen::ArrayXd node_thetas(int nodes, double spacing) {
  const int half = (nodes - 1) / 2;
  return 0.5 * std::numbers::pi + spacing * Eigen::ArrayXd::LinSpaced(nodes, -half, half);
}

/// Chebyshev nodes of the metric's range, and the polynomial that is 1 at one of them and 0 at the others.
class MetricNodes {
 public:
  explicit MetricNodes(double lowest) : low_(lowest) {
    // Tables are analytic in the metric but for the pole of the distance: errors fall with the half width of the range.
    constexpr double kTolerance = 1e-5;  // a tenth of what the local metric leaves out
    const double width = 0.25 * (1.0 - lowest);
    const int count = width < kTolerance ? 1 : static_cast<int>(std::ceil(std::log(kTolerance) / std::log(width)));
    for (int i = 0; i < std::clamp(count, 1, 12); ++i) {
      const double x = std::cos(std::numbers::pi * (i + 0.5) / std::clamp(count, 1, 12));
      nodes_.push_back(0.5 * (1.0 + low_) + 0.5 * (1.0 - low_) * x);
    }
  }
  [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }
  [[nodiscard]] double share(std::size_t i, double metric) const {
    double product = 1.0;
    for (std::size_t j = 0; j < nodes_.size(); ++j) {
      if (j != i) product *= (metric - nodes_[j]) / (nodes_[i] - nodes_[j]);
    }
    return product;
  }

 private:
  double low_;
  std::vector<double> nodes_;
};

/// Of a surface that is flat to a wave, all that the tables of the sphere are joined from.
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

}  // namespace

SphereSum::SphereSum(CoatedSphere sphere, double angular_speed, const Mesh& mesh, double exact_degree)
    : sphere_(std::move(sphere)),
      angular_speed_(angular_speed),
      mesh_(mesh),
      exact_degree_(mesh.max_order ? std::numeric_limits<double>::infinity() : exact_degree),
      highest_degree_(mesh.max_order ? *mesh.max_order : static_cast<int>(std::ceil(exact_end(exact_degree)))) {}

std::vector<std::vector<SphereTable>> SphereSum::tables(const std::vector<SphereRequest>& requests, int phi_reach,
                                                        int half_theta, int threads, Watch& watch) const {
  std::vector<std::vector<SphereTable>> sets;
  for (const SphereRequest& request : requests) {
    sets.emplace_back(static_cast<std::size_t>(request.count()), SphereTable(phi_reach, 2 * half_theta + 1));
    add_degrees(request, sets.back(), threads, watch);
  }
  if (std::isfinite(exact_degree_)) add_local(requests, sets, threads, watch);
  return sets;
}

void SphereSum::add_degrees(const SphereRequest& request, std::vector<SphereTable>& tables, int threads,
                            Watch& watch) const {
  std::vector<double> orders(static_cast<std::size_t>(highest_degree_ + 1));
  for (std::size_t m = 0; m < orders.size(); ++m) orders[m] = static_cast<double>(m);
  const HarmonicCoating coating(sphere_, angular_speed_, orders, measured_order(mesh_), Curvature::sphere);
  const auto spectrum = make_spectrum(coating, highest_degree_ + 1.0, threads, watch);
  const int nodes = tables.front().theta_nodes();
  const Eigen::ArrayXd thetas = node_thetas(nodes, theta_spacing(mesh_));
  const Patches patches(thetas, theta_spacing(mesh_), request.patch_load, highest_degree_);
  const double scale = 1.0 / (2.0 * std::numbers::pi * coating.outer_radius() * coating.outer_radius());

  // [table][m], then summed along phi row by row.
  std::vector<std::vector<Eigen::MatrixXcd>> sums(tables.size(), std::vector<Eigen::MatrixXcd>(orders.size()));
  parallel_for(orders.size(), threads, watch, "summing degrees", [&](std::size_t i, const Worker& worker) {
    const int m = static_cast<int>(i);
    const auto compliances = degree_compliances(coating, *spectrum, i, highest_degree_);
    worker.checkpoint();
    const Harmonics loaded = patches.harmonics(m, highest_degree_);
    const Harmonics seen = request.power ? loaded : harmonics_at(m, highest_degree_, thetas);
    Eigen::ArrayXd weights(highest_degree_ - m + 1);
    for (Index l = 0; l < weights.size(); ++l) {
      weights[l] = exact_share(static_cast<double>(m + l) + 0.5, exact_degree_);
    }
    const OrderTables order(seen, loaded, compliances, weights);
    const double patch = sinc(0.5 * m * phi_spacing(mesh_));
    // Derivatives are averages over patches, displacements are taken somewhat downstream of the nodes.
    const cplx seen_from =
        request.power ? cplx(0.0, m) * patch : std::polar(1.0, m * request.collocation * phi_spacing(mesh_));
    const cplx factor = scale * (m == 0 ? 1.0 : 2.0) * patch * seen_from;
    for (std::size_t t = 0; t < tables.size(); ++t) {
      sums[t][i] = factor * order(static_cast<int>(t / 3), static_cast<int>(t % 3));
      worker.checkpoint();
    }
  });

  // Re[(cos + i sin)(a + i b)] of all orders, at offsets of either sign, for one loaded theta after another.
  const int reach = tables.front().phi_reach();
  const Eigen::ArrayXd offsets = Eigen::ArrayXd::LinSpaced(reach + 1, 0.0, reach) * phi_spacing(mesh_);
  const Eigen::Map<const Eigen::VectorXd> m(orders.data(), static_cast<Index>(orders.size()));
  const MatrixXd phase = offsets.matrix() * m.transpose();
  const MatrixXd cosines = phase.array().cos();
  const MatrixXd sines = phase.array().sin();
  parallel_for(static_cast<std::size_t>(nodes), threads, watch, "summing orders",
               [&](std::size_t from, const Worker& worker) {
                 const auto column = static_cast<Index>(from);
                 MatrixXd real(m.size(), nodes);
                 MatrixXd imaginary(m.size(), nodes);
                 for (std::size_t t = 0; t < tables.size(); ++t) {
                   for (Index i = 0; i < m.size(); ++i) {
                     const auto sum = sums[t][static_cast<std::size_t>(i)].col(column);
                     real.row(i) = sum.real();
                     imaginary.row(i) = sum.imag();
                   }
                   const MatrixXd even = cosines * real;
                   const MatrixXd odd = sines * imaginary;
                   worker.checkpoint();
                   for (int j = 0; j <= reach; ++j) {
                     tables[t].slice(j).col(column) += (even.row(j) - odd.row(j)).transpose();
                     if (j > 0) tables[t].slice(-j).col(column) += (even.row(j) + odd.row(j)).transpose();
                   }
                 }
               });
}

void SphereSum::add_local(const std::vector<SphereRequest>& requests, std::vector<std::vector<SphereTable>>& sets,
                          int threads, Watch& watch) const {
  const int nodes = sets.front().front().theta_nodes();
  const int reach = sets.front().front().phi_reach();
  const Eigen::ArrayXd sines = node_thetas(nodes, theta_spacing(mesh_)).sin();
  const MetricNodes metrics(sines.minCoeff());

  std::vector<TableRequest> flat;
  for (const SphereRequest& request : requests) std::ranges::copy(flat_requests(request), std::back_inserter(flat));
  for (std::size_t i = 0; i < metrics.nodes().size(); ++i) {
    const CoatingSum sum(sphere_, angular_speed_, mesh_, {.sine = metrics.nodes()[i], .exact_degree = exact_degree_},
                         threads, watch);
    const std::vector<Table> local = sum.tables(flat, reach, nodes - 1, threads, watch);
    // Of the table of this metric, at every pair of thetas.
    MatrixXd share(nodes, nodes);
    for (int from = 0; from < nodes; ++from) {
      for (int to = 0; to < nodes; ++to) {
        const double metric = std::sqrt(sines[from] * sines[to]);
        share(to, from) = metrics.share(i, metric) / metric;
      }
    }
    parallel_for(
        static_cast<std::size_t>(2 * reach + 1), threads, watch, "joining tables", [&](std::size_t row, const Worker&) {
          const int j = static_cast<int>(row) - reach;
          std::size_t first = 0;
          for (std::size_t s = 0; s < requests.size(); ++s) {
            for (std::size_t t = 0; t < sets[s].size(); ++t) {
              const SignedEntry source = entry_of(t / 3, t % 3);
              const Table& table = local[first + (requests[s].tangential ? static_cast<std::size_t>(source.entry) : 0)];
              const Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(
                  2 * nodes - 1, [&](Index k) { return source.sign * table(j, static_cast<int>(k) - nodes + 1); });
              MatrixXd& slice = sets[s][t].slice(j);
              for (int from = 0; from < nodes; ++from) {
                slice.col(from) += share.col(from).cwiseProduct(values.segment(nodes - 1 - from, nodes));
              }
            }
            first += flat_requests(requests[s]).size();
          }
        });
  }
}

}  // namespace viscoroll::detail

#include "influence/sphere_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "dense_products.hpp"
#include "influence/coating_sum.hpp"
#include "influence/gauss_legendre.hpp"
#include "influence/legendre.hpp"
#include "influence/patch.hpp"
#include "influence/sampled_angles.hpp"

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
///
/// Thetas lie in pairs about the equator, where harmonics of every other degree are even and the rest are odd. So sums
/// over either, between the thetas of one side, are enough for all.
class OrderTables {
 public:
  /// @param[in] seen,loaded at the first of `thetas` thetas, up to the equator
  OrderTables(const Harmonics& seen, const Harmonics& loaded, const std::vector<DegreeCompliance>& compliances,
              const Eigen::ArrayXd& degree_weights, Index thetas)
      : thetas_(thetas) {
    for (Index parity = 0; parity < 2; ++parity) {
      Degrees& own = degrees_[static_cast<std::size_t>(parity)];
      own = {.seen = every_other(seen, parity), .loaded = every_other(loaded, parity)};
      const Index count = own.seen.p.rows();
      for (Eigen::ArrayXcd* values : {&own.radial, &own.mixed, &own.along, &own.across}) values->resize(count);
      for (Index row = 0; row < count; ++row) {
        const Index l = 2 * row + parity;
        const DegreeCompliance& c = compliances[static_cast<std::size_t>(l)];
        own.radial[row] = degree_weights[l] * c.radial;
        own.mixed[row] = degree_weights[l] * c.mixed;
        own.along[row] = degree_weights[l] * c.along;
        own.across[row] = degree_weights[l] * c.across;
      }
    }
  }

  [[nodiscard]] Eigen::MatrixXcd operator()(int p, int q) const {
    const cplx i(0.0, 1.0);
    constexpr auto kP = &Harmonics::p;
    constexpr auto kD = &Harmonics::d;
    constexpr auto kE = &Harmonics::e;
    switch (3 * p + q) {
      case 0:
        return sum(kP, &Degrees::radial, kP);
      case 1:
        return -i * sum(kP, &Degrees::mixed, kE);
      case 2:
        return sum(kP, &Degrees::mixed, kD);
      case 3:
        return i * sum(kE, &Degrees::mixed, kP);
      case 4:
        return sum(kE, &Degrees::along, kE) + sum(kD, &Degrees::across, kD);
      case 5:
        return i * (sum(kE, &Degrees::along, kD) + sum(kD, &Degrees::across, kE));
      case 6:
        return sum(kD, &Degrees::mixed, kP);
      case 7:
        return -i * (sum(kD, &Degrees::along, kE) + sum(kE, &Degrees::across, kD));
      default:
        return sum(kD, &Degrees::along, kD) + sum(kE, &Degrees::across, kE);
    }
  }

 private:
  /// Every other degree.
  struct Degrees {
    Harmonics seen;
    Harmonics loaded;
    Eigen::ArrayXcd radial = {}, mixed = {}, along = {}, across = {};
  };

  static Harmonics every_other(const Harmonics& all, Index first) {
    const auto rows = Eigen::seq(first, Eigen::last, Eigen::fix<2>);
    return {.p = all.p(rows, Eigen::all), .d = all.d(rows, Eigen::all), .e = all.e(rows, Eigen::all)};
  }

  using Harmonic = MatrixXd Harmonics::*;

  [[nodiscard]] Eigen::MatrixXcd sum(Harmonic seen, Eigen::ArrayXcd Degrees::* middle, Harmonic loaded) const {
    std::array<Eigen::MatrixXcd, 2> sums;
    for (std::size_t parity = 0; parity < 2; ++parity) {
      const Degrees& own = degrees_[parity];
      const Eigen::ArrayXcd& factor = own.*middle;
      const MatrixXd& right = own.loaded.*loaded;
      const MatrixXd& left = own.seen.*seen;
      sums[parity].resize(left.cols(), right.cols());
      const MatrixXd real = factor.real().matrix().asDiagonal() * right;
      const MatrixXd imaginary = factor.imag().matrix().asDiagonal() * right;
      sums[parity].real() = product(left.transpose(), real);
      sums[parity].imag() = product(left.transpose(), imaginary);
    }
    // Of the first degrees, P and E are even about the equator and D is odd.
    const auto sign = [](Harmonic harmonic) { return harmonic == &Harmonics::d ? -1.0 : 1.0; };
    return unfolded(sums[0] + sums[1], sums[0] - sums[1], sign(seen), sign(loaded));
  }

  /// From between thetas on one side, `same`, and between those and the other side, to all.
  [[nodiscard]] Eigen::MatrixXcd unfolded(const Eigen::MatrixXcd& same, const Eigen::MatrixXcd& opposite,
                                          double seen_sign, double loaded_sign) const {
    const Index half = same.rows();
    const Index rest = thetas_ - half;
    Eigen::MatrixXcd all(thetas_, thetas_);
    all.topLeftCorner(half, half) = same;
    all.topRightCorner(half, rest) = loaded_sign * opposite.leftCols(rest).rowwise().reverse();
    all.bottomLeftCorner(rest, half) = seen_sign * opposite.topRows(rest).colwise().reverse();
    all.bottomRightCorner(rest, rest) = seen_sign * loaded_sign * same.topLeftCorner(rest, rest).reverse();
    return all;
  }

  Index thetas_;
  std::array<Degrees, 2> degrees_;
};

Eigen::ArrayXd node_thetas(int nodes, double spacing) {
  const int half = (nodes - 1) / 2;
  return 0.5 * std::numbers::pi + spacing * Eigen::ArrayXd::LinSpaced(nodes, -half, half);
}

/// Coefficients [power, node] of the polynomials that are 1 at one of some nodes and 0 at the others.
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

/// Metrics that hold all between the lowest one and 1: tables are analytic in the metric but for the pole of the
/// distance, errors fall with the half width of the range.
Eigen::ArrayXd sampled_metrics(double lowest) {
  constexpr double kTolerance = 1e-5;  // a tenth of what the local metric leaves out
  const double width = 0.25 * (1.0 - lowest);
  const int count = width < kTolerance ? 1 : static_cast<int>(std::ceil(std::log(kTolerance) / std::log(width)));
  return 0.5 * (1.0 + lowest) + 0.5 * (1.0 - lowest) * ChebyshevNodes(std::clamp(count, 1, 12)).places();
}

/// Averages over a quarter, a half and a quarter of three offsets, at every `stride`-th of them.
SphereTable widened(const SphereTable& fine, int stride, double downstream) {
  const std::array<double, 4> share = wide_patch_shares(downstream);
  const int last = downstream > 0.0 ? 2 : 1;
  SphereTable coarse((fine.phi_reach() - last) / stride, fine.thetas());
  for (int j = -coarse.phi_reach(); j <= coarse.phi_reach(); ++j) {
    for (int dj = -1; dj <= last; ++dj) {
      coarse.slice(j) += share[static_cast<std::size_t>(dj + 1)] * fine.slice(stride * j + dj);
    }
  }
  return coarse;
}

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
      highest_degree_(mesh.max_order ? *mesh.max_order : highest_degree(exact_degree)) {}

int highest_degree(double exact_degree) { return static_cast<int>(std::ceil(exact_end(exact_degree))); }

int SphereSum::thetas(int half_theta) const {
  return std::min(2 * half_theta + 1, sampled_angles(half_theta * theta_spacing(mesh_), highest_degree_));
}

std::vector<SphereInfluence> SphereSum::influences(const std::vector<SphereRequest>& requests, int phi_reach,
                                                   int half_theta, int threads, Watch& watch) const {
  const int nodes = 2 * half_theta + 1;
  const int count = thetas(half_theta);
  const Eigen::ArrayXd all = node_thetas(nodes, theta_spacing(mesh_));
  Eigen::ArrayXd few = all;
  MatrixXd basis = MatrixXd::Identity(nodes, nodes);
  if (count < nodes) {
    const ChebyshevNodes places(count);
    few = 0.5 * std::numbers::pi + half_theta * theta_spacing(mesh_) * places.places();
    basis = places.interpolation(Eigen::ArrayXd::LinSpaced(nodes, -1.0, 1.0));
  }
  std::vector<SphereInfluence> influences;
  for (const SphereRequest& request : requests) {
    std::vector<SphereTable> degrees;
    degrees.reserve(static_cast<std::size_t>(request.count()));
    for (int table = 0; table < request.count(); ++table) degrees.emplace_back(phi_reach, count);
    add_degrees(request, few, degrees, threads, watch);
    influences.push_back({.degrees = std::move(degrees),
                          .displaced = basis,
                          .loaded = basis,
                          .local = {},
                          .powers = 0,
                          .root = all.sin().sqrt()});
  }
  if (std::isfinite(exact_degree_)) add_local(requests, influences, half_theta, threads, watch);
  return influences;
}

void SphereSum::add_degrees(const SphereRequest& request, const Eigen::ArrayXd& thetas,
                            std::vector<SphereTable>& tables, int threads, Watch& watch) const {
  std::vector<double> orders(static_cast<std::size_t>(highest_degree_ + 1));
  for (std::size_t m = 0; m < orders.size(); ++m) orders[m] = static_cast<double>(m);
  const HarmonicCoating coating(sphere_, angular_speed_, orders, measured_order(mesh_), Curvature::sphere);
  const auto spectrum = make_spectrum(coating, highest_degree_ + 1.0, threads, watch);
  const Eigen::ArrayXd to_equator = thetas.head((thetas.size() + 1) / 2);
  const Patches patches(to_equator, theta_spacing(mesh_), request.patch_load, highest_degree_);
  const double scale = 1.0 / (2.0 * std::numbers::pi * coating.outer_radius() * coating.outer_radius());

  // [table][m], then summed along phi row by row.
  std::vector<std::vector<Eigen::MatrixXcd>> sums(tables.size(), std::vector<Eigen::MatrixXcd>(orders.size()));
  parallel_for(orders.size(), threads, watch, "summing degrees", [&](std::size_t i, const Worker& worker) {
    const int m = static_cast<int>(i);
    const auto compliances = degree_compliances(coating, *spectrum, i, highest_degree_);
    worker.checkpoint();
    const Harmonics loaded = patches.harmonics(m, highest_degree_);
    const Harmonics seen = request.power ? loaded : harmonics_at(m, highest_degree_, to_equator);
    Eigen::ArrayXd weights(highest_degree_ - m + 1);
    for (Index l = 0; l < weights.size(); ++l) {
      weights[l] = exact_share(static_cast<double>(m + l) + 0.5, exact_degree_);
    }
    const OrderTables order(seen, loaded, compliances, weights, thetas.size());
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
  const SampledOffsets offsets(reach, phi_spacing(mesh_), highest_degree_);
  const Eigen::Map<const Eigen::VectorXd> m(orders.data(), static_cast<Index>(orders.size()));
  const MatrixXd phase = offsets.sampled.matrix() * m.transpose();
  const MatrixXd cosines = phase.array().cos();
  const MatrixXd sines = phase.array().sin();
  parallel_for(static_cast<std::size_t>(thetas.size()), threads, watch, "summing orders",
               [&](std::size_t from, const Worker& worker) {
                 const auto column = static_cast<Index>(from);
                 MatrixXd real(m.size(), thetas.size());
                 MatrixXd imaginary(m.size(), thetas.size());
                 for (std::size_t t = 0; t < tables.size(); ++t) {
                   for (Index i = 0; i < m.size(); ++i) {
                     const auto sum = sums[t][static_cast<std::size_t>(i)].col(column);
                     real.row(i) = sum.real();
                     imaginary.row(i) = sum.imag();
                   }
                   const MatrixXd even = product(offsets.even, product(cosines, real));
                   const MatrixXd odd = product(offsets.odd, product(sines, imaginary));
                   worker.checkpoint();
                   for (int j = 0; j <= reach; ++j) {
                     tables[t].slice(j).col(column) += (even.row(j) - odd.row(j)).transpose();
                     if (j > 0) tables[t].slice(-j).col(column) += (even.row(j) + odd.row(j)).transpose();
                   }
                 }
               });
}

void SphereSum::add_local(const std::vector<SphereRequest>& requests, std::vector<SphereInfluence>& influences,
                          int half_theta, int threads, Watch& watch) const {
  const int phi_reach = influences.front().phi_reach();
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
  const Index middle = fine.half_theta();
  const Index half = (middle - 1) / kStride;
  const auto places = [&](const MatrixXd& basis, bool wide) {
    MatrixXd result(2 * half + 1, basis.cols());
    for (Index k = -half; k <= half; ++k) {
      const Index node = middle + kStride * k;
      result.row(k + half) = basis.row(node);
      if (wide) result.row(k + half) = 0.25 * basis.row(node - 1) + 0.5 * basis.row(node) + 0.25 * basis.row(node + 1);
    }
    return result;
  };
  SphereInfluence coarse{.degrees = {},
                         .displaced = places(fine.displaced, power),
                         .loaded = places(fine.loaded, true),
                         .local = {},
                         .powers = fine.powers,
                         .root = places(fine.root, false).array()};
  for (const SphereTable& table : fine.degrees) {
    const SphereTable once = power ? widened(table, 1, 0.0) : table;
    coarse.degrees.push_back(widened(once, kStride, downstream));
  }
  for (const Table& table : fine.local) {
    const Table once = power ? widened(table, 1) : table;
    coarse.local.push_back(widened(once, kStride, downstream));
  }
  return coarse;
}

std::vector<Table> tables_around_equator(const SphereInfluence& influence) {
  const int middle = influence.half_theta();
  const std::size_t count = influence.degrees.size() == 1 ? 1 : kEntries;
  std::vector<Table> tables;
  for (std::size_t entry = 0; entry < count; ++entry) {
    constexpr std::array<std::size_t, kEntries> kPairs{0, 1, 2, 4, 5, 8};  // 3 P + Q of each entry
    const std::size_t pair = kPairs[entry];
    Table table(influence.phi_reach(), 2 * middle, is_odd(static_cast<Entry>(entry)));
    for (std::size_t power = 0; power < influence.powers; ++power)
      add(1.0, influence.local[power * count + entry], table);
    for (int j = -table.phi_reach(); j <= table.phi_reach(); ++j) {
      const MatrixXd above = influence.displaced.bottomRows(middle + 1) * influence.degrees[pair].slice(j);
      for (int l = 0; l <= table.theta_reach(); ++l) {
        table.row(j)[static_cast<std::size_t>(l)] += above.row((l + 1) / 2).dot(influence.loaded.row(middle - l / 2));
      }
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace viscoroll::detail

#include "influence/synthesis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "base/dense_products.hpp"
#include "influence/interpolated_orders.hpp"
#include "influence/sampled_angles.hpp"
#include "influence/waves.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using RowMajor = RowMajorMatrix;

/// Weights of a kernel along phi, with the scale of the whole sum.
Eigen::ArrayXcd phi_weights(const Kernel& kernel, const OrderBand& band, const MeshOnBody& mesh, double radius) {
  const double spacing = mesh.phi_spacing();
  const double circumference = 2.0 * std::numbers::pi * radius;
  const cplx scale = kernel.phase / (circumference * circumference);
  return band.weights * band.orders.unaryExpr([&](double m) {
    const double patch = sinc(0.5 * m * spacing);
    const cplx shift = std::polar(1.0, m * spacing * kernel.request.phi_shift);
    return scale * (kernel.request.power ? cplx(0.0, mesh.turns() * m) * patch * patch : patch * shift);
  });
}

/// Weights of the kernels at the orders of all bands, [kernel].
std::vector<Eigen::ArrayXcd> weights_along_phi(const std::vector<Kernel>& kernels, const std::vector<OrderBand>& bands,
                                               const MeshOnBody& mesh, double radius) {
  std::vector<Eigen::ArrayXcd> all;
  for (const Kernel& kernel : kernels) {
    Eigen::ArrayXcd& weights = all.emplace_back(static_cast<Index>(all_orders(bands).size()));
    Index first = 0;
    for (const OrderBand& band : bands) {
      weights.segment(first, band.orders.size()) = phi_weights(kernel, band, mesh, radius);
      first += band.orders.size();
    }
  }
  return all;
}

/// Sums of a set of requests over all orders: along theta for every order m, then along phi.
class Synthesis {
 public:
  Synthesis(const std::vector<TableRequest>& requests, const std::vector<OrderBand>& phi_bands,
            const std::vector<OrderBand>& theta_bands, const Spectrum& spectrum, const LocalMetric& metric,
            const MeshOnBody& mesh, double radius, int phi_reach, int theta_reach, int threads, Watch& watch)
      : phi_bands_(phi_bands),
        theta_reach_(theta_reach),
        phi_waves_(phi_bands, mesh.phi_spacing(), phi_reach),
        kernels_(requests.begin(), requests.end()),
        phi_weights_(weights_along_phi(kernels_, phi_bands, mesh, radius)),
        theta_sums_(kernels_, phi_weights_,
                    {.spectrum = spectrum,
                     .bands = theta_bands,
                     .orders = all_orders(phi_bands),
                     .metric = metric,
                     .spacing = mesh.theta_spacing(),
                     .reach = theta_reach},
                    threads, watch) {}

  /// Number of columns of the tables (offsets in theta) whose sums along phi are computed together.
  static constexpr int kStripe = 64;
  /// Number of orders that are summed together, so that the data of a stripe stay in the cache.
  static constexpr Index kOrders = 128;
  [[nodiscard]] std::size_t stripes() const { return static_cast<std::size_t>(theta_reach_ / kStripe + 1); }

  void sum_along_phi(std::size_t k, std::size_t stripe, Table& table, const Worker& worker) const {
    const Index start = static_cast<Index>(stripe) * kStripe;
    const Index width = std::min<Index>(kStripe, theta_reach_ + 1 - start);
    // Re[(cos + i sin)(a + i b)] = a cos - b sin
    const RowMajor even = sum_of_bands(k, start, width, false, table.phi_reach(), worker);
    const RowMajor odd = sum_of_bands(k, start, width, true, table.phi_reach(), worker);
    for (int j = 0; j <= table.phi_reach(); ++j) {
      Eigen::Map<Eigen::RowVectorXd>(table.row(j).data() + start, width) = even.row(j) - odd.row(j);
      Eigen::Map<Eigen::RowVectorXd>(table.row(-j).data() + start, width) = even.row(j) + odd.row(j);
    }
  }

  [[nodiscard]] bool is_odd_in_theta(std::size_t k) const { return kernels_[k].odd; }

 private:
  /// Sums over m, at all offsets in phi and some in theta: cosines times real parts, or sines times imaginary parts.
  [[nodiscard]] RowMajor sum_of_bands(std::size_t k, Index start, Index width, bool odd, int phi_reach,
                                      const Worker& worker) const {
    RowMajor sum = RowMajor::Zero(phi_reach + 1, width);
    RowMajor at_sampled = RowMajor::Zero(phi_waves_.sampled_offsets(), width);
    Index first = 0;
    for (std::size_t band = 0; band < phi_bands_.size(); ++band) {
      const RowMajor& waves = phi_waves_(band, odd);
      for (Index done = 0; done < waves.rows(); done += kOrders) {
        const auto some = waves.middleRows(done, std::min(kOrders, waves.rows() - done));
        RowMajor sums(some.rows(), width);
        theta_sums_.fill(k, odd ? ThetaSums::Part::imaginary : ThetaSums::Part::real, first + done, start, sums);
        if (band < phi_waves_.long_bands()) {
          add_product(some.transpose(), sums, at_sampled);
        } else {
          add_product(some.transpose(), sums, sum.topRows(waves.cols()));
        }
        worker.checkpoint();
      }
      first += waves.rows();
    }
    if (phi_waves_.long_bands() > 0) add_product(phi_waves_.polynomials(odd), at_sampled, sum);
    return sum;
  }

  const std::vector<OrderBand>& phi_bands_;
  int theta_reach_;
  BandWaves phi_waves_;
  std::vector<Kernel> kernels_;
  std::vector<Eigen::ArrayXcd> phi_weights_;  // [kernel]
  ThetaSums theta_sums_;
};

}  // namespace

std::vector<Table> OrderSum::tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                    int threads, Watch& watch) const {
  const Synthesis synthesis(requests, phi_bands_, theta_bands_, *spectrum_, metric_, mesh_, radius_, phi_reach,
                            theta_reach, threads, watch);
  std::vector<Table> tables;
  tables.reserve(requests.size());
  for (std::size_t k = 0; k < requests.size(); ++k) {
    tables.emplace_back(phi_reach, theta_reach, synthesis.is_odd_in_theta(k));
  }
  const std::size_t stripes = synthesis.stripes();
  parallel_for(requests.size() * stripes, threads, watch, "summing tables", [&](std::size_t i, const Worker& worker) {
    synthesis.sum_along_phi(i / stripes, i % stripes, tables[i / stripes], worker);
  });
  return tables;
}

}  // namespace viscoroll::detail

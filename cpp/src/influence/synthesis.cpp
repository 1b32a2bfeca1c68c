#include "influence/synthesis.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <numbers>
#include <optional>

#include "dense_products.hpp"
#include "influence/patch.hpp"
#include "influence/sampled_angles.hpp"
#include "influence/waves.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using RowMajor = RowMajorMatrix;

/// A request with what its summands are multiplied by. A coefficient is even or odd in n, by its entry and its patches.
struct Kernel {
  TableRequest request;
  bool odd;
  cplx phase;  // i^(receiver degree - source degree), and i of the sine where odd
  [[nodiscard]] int receiver_shape() const { return request.power ? request.receiver_shape : 0; }
};

Kernel make_kernel(const TableRequest& request) {
  Kernel kernel{.request = request, .odd = false, .phase = 1.0};
  kernel.odd = is_odd(request.entry) != ((request.source_shape + kernel.receiver_shape()) % 2 == 1);
  constexpr std::array<cplx, 4> kPowersOfI{cplx(1, 0), cplx(0, 1), cplx(-1, 0), cplx(0, -1)};
  const int power = kernel.receiver_shape() - request.source_shape + (kernel.odd ? 1 : 0);
  kernel.phase = kPowersOfI[static_cast<std::size_t>(power + 4) % 4];
  return kernel;
}

/// Weights of a kernel along theta.
Eigen::ArrayXd theta_weights(const Kernel& kernel, const OrderBand& band, double spacing) {
  return band.weights * band.orders.unaryExpr([&](double n) {
    const double source = spherical_bessel(kernel.request.source_shape, 0.5 * n * spacing);
    return kernel.request.power ? source * spherical_bessel(kernel.receiver_shape(), 0.5 * n * spacing) : source;
  });
}

/// Weights of a kernel along phi, and the scale of the whole sum.
Eigen::ArrayXcd phi_weights(const Kernel& kernel, const OrderBand& band, const Patches& patches, double radius) {
  const double circumference = 2.0 * std::numbers::pi * radius;
  const cplx scale = kernel.phase / (circumference * circumference);
  return band.weights * band.orders.unaryExpr([&](double m) {
    const double patch = sinc(0.5 * m * patches.phi);
    const cplx shift = std::polar(1.0, m * patches.phi * kernel.request.phi_shift);
    return scale * (kernel.request.power ? cplx(0.0, patches.turns * m) * patch * patch : patch * shift);
  });
}

/// Share of the orders that is not summed by degrees.
Eigen::ArrayXd local_share(double m, const Eigen::ArrayXd& n, const LocalMetric& metric) {
  if (metric.exact_degree == 0.0) return Eigen::ArrayXd::Ones(n.size());
  return 1.0 - (m * m + n.square()).sqrt().unaryExpr([&](double k) { return exact_share(k, metric.exact_degree); });
}

/// Every other row: the real or the imaginary parts.
Eigen::Map<const RowMajor, Eigen::Unaligned, Eigen::OuterStride<>> every_other_row(const RowMajor& sums, Index first,
                                                                                   Index count, Index start,
                                                                                   Index width) {
  return {&sums(first, start), count, width, Eigen::OuterStride<>(2 * sums.outerStride())};
}

/// The waves of all bands along one direction, at the offsets of a mesh. The first bands are of long waves, which few
/// offsets do for.
class BandWaves {
 public:
  BandWaves(const std::vector<OrderBand>& bands, double spacing, int reach) : long_(count_long(bands, spacing, reach)) {
    if (long_ > 0) offsets_.emplace(reach, spacing, end_of(bands[long_ - 1]));
    for (const OrderBand& band : bands) {
      const bool is_long = waves_.size() < long_;
      waves_.push_back(is_long ? make_waves(band.orders, offsets_->sampled)
                               : make_waves(band.orders, spacing, std::min(band.reach, reach)));
    }
  }

  [[nodiscard]] const RowMajor& operator()(std::size_t band, bool odd) const {
    return odd ? waves_[band].sines : waves_[band].cosines;
  }
  /// @return number of bands that are summed at few offsets
  [[nodiscard]] std::size_t long_bands() const { return long_; }
  /// @return number of these offsets
  [[nodiscard]] Index few() const { return offsets_ ? offsets_->sampled.size() : 0; }
  /// @return what sums there are at all offsets, [offset, few]
  [[nodiscard]] const Eigen::MatrixXd& polynomials(bool odd) const { return odd ? offsets_->odd : offsets_->even; }

 private:
  /// As many as save most multiplications. A band that does not reach as far is not smooth over all of it, nor is the
  /// last one where it is cut off.
  static std::size_t count_long(const std::vector<OrderBand>& bands, double spacing, int reach) {
    std::size_t best = 0;
    double most_saved = 0.0;
    double orders = 0.0;
    for (std::size_t i = 0; i + 1 < bands.size() && bands[i].reach >= reach; ++i) {
      orders += static_cast<double>(bands[i].orders.size());
      const double few = SampledOffsets::count(reach, spacing, end_of(bands[i]));
      const double saved = orders * (reach + 1.0 - few) - few * (reach + 1.0);
      if (saved <= most_saved) continue;
      most_saved = saved;
      best = i + 1;
    }
    return best;
  }

  static double end_of(const OrderBand& band) { return band.orders[band.orders.size() - 1]; }

  std::size_t long_;
  std::optional<SampledOffsets> offsets_;
  std::vector<Waves> waves_;  // [band]
};

class Synthesis {
 public:
  Synthesis(const std::vector<TableRequest>& requests, const std::vector<OrderBand>& phi_bands,
            const std::vector<OrderBand>& theta_bands, const LocalMetric& metric, const Patches& patches, double radius,
            int phi_reach, int theta_reach)
      : phi_bands_(phi_bands),
        theta_bands_(theta_bands),
        metric_(metric),
        theta_reach_(theta_reach),
        orders_(all_orders(phi_bands)),
        theta_waves_(theta_bands, patches.theta, theta_reach),
        phi_waves_(phi_bands, patches.phi, phi_reach) {
    const auto count = static_cast<Index>(orders_.size());
    for (const TableRequest& request : requests) {
      kernels_.push_back(make_kernel(request));
      Eigen::ArrayXcd weights(count);
      Index first = 0;
      for (const OrderBand& band : phi_bands) {
        weights.segment(first, band.orders.size()) = phi_weights(kernels_.back(), band, patches, radius);
        first += band.orders.size();
      }
      phi_weights_.push_back(std::move(weights));
      theta_weights_.emplace_back();
      for (const OrderBand& band : theta_bands) {
        theta_weights_.back().push_back(theta_weights(kernels_.back(), band, patches.theta));
      }
      sums_.emplace_back(2 * count, theta_reach + 1);
    }
  }

  /// Orders m that are summed along theta together.
  static constexpr Index kBlock = 16;
  [[nodiscard]] std::size_t blocks() const { return (orders_.size() + kBlock - 1) / kBlock; }

  void sum_along_theta(std::size_t block, const Spectrum& spectrum, const Worker& worker) {
    const Index first = static_cast<Index>(block) * kBlock;
    const Index count = std::min(kBlock, static_cast<Index>(orders_.size()) - first);
    std::vector<OrderSeries> series(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < series.size(); ++i) {
      spectrum.series(static_cast<std::size_t>(first) + i, series[i]);
      worker.checkpoint();
    }
    for (RowMajor& sums : sums_) sums.middleRows(2 * first, 2 * count).setZero();
    std::vector<RowMajor> at_few(kernels_.size(), RowMajor::Zero(2 * count, theta_waves_.few()));
    for (std::size_t band = 0; band < theta_bands_.size(); ++band) {
      const std::vector<RowMajor> summands = evaluate(first, series, band, worker);
      for (std::size_t k = 0; k < kernels_.size(); ++k) {
        const RowMajor& wave = theta_waves_(band, kernels_[k].odd);
        if (band < theta_waves_.long_bands()) {
          add_product(summands[k], wave, at_few[k]);
        } else {
          add_product(summands[k], wave, sums_[k].block(2 * first, 0, 2 * count, wave.cols()));
        }
        worker.checkpoint();
      }
    }
    if (theta_waves_.long_bands() == 0) return;
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      add_product(at_few[k], theta_waves_.polynomials(kernels_[k].odd).transpose(),
                  sums_[k].middleRows(2 * first, 2 * count));
      worker.checkpoint();
    }
  }

  /// Offsets in theta that are summed along phi together.
  static constexpr int kStripe = 64;
  [[nodiscard]] std::size_t stripes() const { return static_cast<std::size_t>(theta_reach_ / kStripe + 1); }

  void sum_along_phi(std::size_t k, std::size_t stripe, Table& table, const Worker& worker) const {
    const Index start = static_cast<Index>(stripe) * kStripe;
    const Index width = std::min<Index>(kStripe, theta_reach_ + 1 - start);
    // Re[(cos + i sin)(a + i b)]
    const RowMajor even = sum_of_bands(k, start, width, false, table.phi_reach(), worker);
    const RowMajor odd = sum_of_bands(k, start, width, true, table.phi_reach(), worker);
    for (int j = 0; j <= table.phi_reach(); ++j) {
      Eigen::Map<Eigen::RowVectorXd>(table.row(j).data() + start, width) = even.row(j) - odd.row(j);
      Eigen::Map<Eigen::RowVectorXd>(table.row(-j).data() + start, width) = even.row(j) + odd.row(j);
    }
  }

  [[nodiscard]] bool is_odd_in_theta(std::size_t k) const { return kernels_[k].odd; }

 private:
  /// Sums over m, at all offsets in phi and some in theta: of cosines and real parts, or of sines and imaginary ones.
  [[nodiscard]] RowMajor sum_of_bands(std::size_t k, Index start, Index width, bool odd, int phi_reach,
                                      const Worker& worker) const {
    RowMajor sum = RowMajor::Zero(phi_reach + 1, width);
    RowMajor at_few = RowMajor::Zero(phi_waves_.few(), width);
    Index first = 0;
    for (std::size_t band = 0; band < phi_bands_.size(); ++band) {
      const Index count = phi_bands_[band].orders.size();
      const RowMajor& wave = phi_waves_(band, odd);
      const auto sums = every_other_row(sums_[k], 2 * first + (odd ? 1 : 0), count, start, width);
      if (band < phi_waves_.long_bands()) {
        add_product(wave.transpose(), sums, at_few);
      } else {
        add_product(wave.transpose(), sums, sum.topRows(wave.cols()));
      }
      first += count;
      worker.checkpoint();
    }
    if (phi_waves_.long_bands() > 0) add_product(phi_waves_.polynomials(odd), at_few, sum);
    return sum;
  }

  /// Weighted compliances of a block of orders m, at the orders n of a band, for each kernel: two rows for each m, of
  /// the real parts and of the imaginary ones.
  [[nodiscard]] std::vector<RowMajor> evaluate(Index first, const std::vector<OrderSeries>& series, std::size_t band,
                                               const Worker& worker) const {
    const Eigen::ArrayXd& n = theta_bands_[band].orders;
    const auto count = static_cast<Index>(series.size());
    std::vector<RowMajor> summands(kernels_.size(), RowMajor(2 * count, n.size()));
    std::array<Eigen::ArrayXcd, kEntries> values;
    for (Index i = 0; i < count; ++i) {
      const double m = orders_[static_cast<std::size_t>(first + i)] / metric_.sine;
      const OrderValues order(m, n, series[static_cast<std::size_t>(i)]);
      const Eigen::ArrayXd share = local_share(m, n, metric_);
      std::array<bool, kEntries> evaluated{};
      for (std::size_t k = 0; k < kernels_.size(); ++k) {
        const auto entry = static_cast<std::size_t>(kernels_[k].request.entry);
        if (!evaluated[entry]) order.evaluate(kernels_[k].request.entry, values[entry]);
        evaluated[entry] = true;
        const Eigen::ArrayXcd weighted = phi_weights_[k][first + i] * values[entry] * theta_weights_[k][band] * share;
        summands[k].row(2 * i) = weighted.real().matrix().transpose();
        summands[k].row(2 * i + 1) = weighted.imag().matrix().transpose();
      }
      worker.checkpoint();
    }
    return summands;
  }

  const std::vector<OrderBand>& phi_bands_;
  const std::vector<OrderBand>& theta_bands_;
  LocalMetric metric_;
  int theta_reach_;
  std::vector<double> orders_;  // m of all bands
  BandWaves theta_waves_;
  BandWaves phi_waves_;
  std::vector<Kernel> kernels_;
  std::vector<Eigen::ArrayXcd> phi_weights_;                // [kernel]
  std::vector<std::vector<Eigen::ArrayXd>> theta_weights_;  // [kernel][band]
  std::vector<RowMajor> sums_;  // [kernel], over n: two rows for each m, real and imaginary, and the offsets in theta
};

}  // namespace

std::vector<Table> OrderSum::tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                    int threads, Watch& watch) const {
  Synthesis synthesis(requests, phi_bands_, theta_bands_, metric_, patches_, radius_, phi_reach, theta_reach);
  parallel_for(synthesis.blocks(), threads, watch, "summing orders",
               [&](std::size_t block, const Worker& worker) { synthesis.sum_along_theta(block, *spectrum_, worker); });

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

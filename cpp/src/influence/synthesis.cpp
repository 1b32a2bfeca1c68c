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

/// A requested table, and the parity in n and the constant factor of the terms of its sum. The parity follows from the
/// entry and from the Legendre degrees of the patches.
struct Kernel {
  TableRequest request;
  bool odd;
  cplx phase;  // i^(receiver degree - source degree); if odd, also times i, since e^(i n theta) sums to i sin(n theta)
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

/// Weight of each order (m, n) in this sum. The rest of the weight is in the sum over the degrees of a sphere
/// (`sphere_sum.hpp`).
Eigen::ArrayXd local_weights(double m, const Eigen::ArrayXd& n, const LocalMetric& metric) {
  if (metric.exact_degree == 0.0) return Eigen::ArrayXd::Ones(n.size());
  return 1.0 - (m * m + n.square()).sqrt().unaryExpr([&](double k) { return exact_share(k, metric.exact_degree); });
}

/// Every other row: the real or the imaginary parts.
Eigen::Map<const RowMajor, Eigen::Unaligned, Eigen::OuterStride<>> every_other_row(const RowMajor& sums, Index first,
                                                                                   Index count, Index start,
                                                                                   Index width) {
  return {&sums(first, start), count, width, Eigen::OuterStride<>(2 * sums.outerStride())};
}

/// Waves of all bands along one direction, at the offsets of a mesh. The first bands contain long waves, whose sums are
/// interpolated from a few sampled offsets.
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
  /// @return number of bands that are summed at the sampled offsets only
  [[nodiscard]] std::size_t long_bands() const { return long_; }
  /// @return number of sampled offsets
  [[nodiscard]] Index sampled_offsets() const { return offsets_ ? offsets_->sampled.size() : 0; }
  /// @return interpolation from the sampled to all offsets, [offset, sampled offset]
  [[nodiscard]] const Eigen::MatrixXd& polynomials(bool odd) const { return odd ? offsets_->odd : offsets_->even; }

 private:
  /// Number of long bands that saves most multiplications. The last band, which may be truncated, and bands that do not
  /// reach all offsets are excluded: their sums are not smooth over all offsets.
  static std::size_t count_long(const std::vector<OrderBand>& bands, double spacing, int reach) {
    std::size_t best = 0;
    double max_saved = 0.0;
    double orders = 0.0;
    for (std::size_t i = 0; i + 1 < bands.size() && bands[i].reach >= reach; ++i) {
      orders += static_cast<double>(bands[i].orders.size());
      const double few = SampledOffsets::count(reach, spacing, end_of(bands[i]));
      const double saved = orders * (reach + 1.0 - few) - few * (reach + 1.0);
      if (saved <= max_saved) continue;
      max_saved = saved;
      best = i + 1;
    }
    return best;
  }

  static double end_of(const OrderBand& band) { return band.orders[band.orders.size() - 1]; }

  std::size_t long_;
  std::optional<SampledOffsets> offsets_;
  std::vector<Waves> waves_;  // [band]
};

/// Terms of the entries, see `Spectrum::terms`; null if an entry is not needed.
using SharedTerms = std::array<std::shared_ptr<const EntryTerms>, kEntries>;

/// Entries needed by some kernels, at a list of orders n.
class EntryValues {
 public:
  EntryValues(double m, const Eigen::ArrayXd& n, const OrderSeries& series, const std::vector<Kernel>& kernels) {
    const OrderValues order(m, n, series);
    for (const Kernel& kernel : kernels) {
      const auto entry = static_cast<std::size_t>(kernel.request.entry);
      if (values_[entry].size() == 0) order.evaluate(kernel.request.entry, values_[entry]);
    }
  }

  /// Values from terms that speeds share.
  /// @param[in] i index of the order m
  EntryValues(const Spectrum& spectrum, const SharedTerms& shared, std::size_t i) {
    for (std::size_t entry = 0; entry < values_.size(); ++entry) {
      if (!shared[entry]) continue;
      Eigen::ArrayXcd& values = values_[entry];
      values.setZero(shared[entry]->front().cols());
      for (std::size_t j = 0; j < shared[entry]->size(); ++j) {
        const cplx factor = spectrum.factor(static_cast<Entry>(entry), i, j);
        values += factor * (*shared[entry])[j].row(static_cast<Index>(i)).transpose().array();
      }
    }
  }

  [[nodiscard]] bool has(Entry entry) const { return (*this)[entry].size() > 0; }
  [[nodiscard]] const Eigen::ArrayXcd& operator[](Entry entry) const {
    return values_[static_cast<std::size_t>(entry)];
  }

 private:
  std::array<Eigen::ArrayXcd, kEntries> values_;
};

/// Store real and imaginary parts as the two rows of an order.
template <class Values>
void put(const Values& values, Index order, RowMajor& rows) {
  const Eigen::ArrayXcd evaluated = values;
  rows.row(2 * order) = evaluated.real().matrix().transpose();
  rows.row(2 * order + 1) = evaluated.imag().matrix().transpose();
}

/// If the last terms of the polynomial in n exceed this fraction of the entry, the sampled orders do not resolve the
/// entry. The fraction is ten times the tolerance of the series from which the compliances are evaluated.
constexpr double kUnresolved = 10.0 * kSeriesTolerance;

/// The sums of a kernel along theta are linear in its values at the sampled orders; these are the factors of the
/// values.
struct SumFactors {
  TableRequest representative;  // a request with these weights, with the entry rr and without shift along phi
  bool odd;
  RowMajor at_sampled;  // [sampled order, sampled offset]
  RowMajor at_all;      // [sampled order, offset]
};

/// Sums of a set of requests over all orders: along theta for every order m, then along phi.
class Synthesis {
 public:
  Synthesis(const std::vector<TableRequest>& requests, const std::vector<OrderBand>& phi_bands,
            const std::vector<OrderBand>& theta_bands, const Spectrum& spectrum, const LocalMetric& metric,
            const MeshOnBody& mesh, double radius, int phi_reach, int theta_reach)
      : spectrum_(spectrum),
        phi_bands_(phi_bands),
        theta_bands_(theta_bands),
        metric_(metric),
        theta_reach_(theta_reach),
        orders_(all_orders(phi_bands)),
        theta_waves_(theta_bands, mesh.theta_spacing(), theta_reach),
        phi_waves_(phi_bands, mesh.phi_spacing(), phi_reach) {
    const auto count = static_cast<Index>(orders_.size());
    for (const TableRequest& request : requests) {
      kernels_.push_back(make_kernel(request));
      Eigen::ArrayXcd weights(count);
      Index first = 0;
      for (const OrderBand& band : phi_bands) {
        weights.segment(first, band.orders.size()) = phi_weights(kernels_.back(), band, mesh, radius);
        first += band.orders.size();
      }
      phi_weights_.push_back(std::move(weights));
      theta_weights_.emplace_back();
      for (const OrderBand& band : theta_bands) {
        theta_weights_.back().push_back(theta_weights(kernels_.back(), band, mesh.theta_spacing()));
      }
      sums_.emplace_back(2 * count, theta_reach + 1);
    }
    // With a local metric, the terms contain the weights `local_weights`, which polynomials in n do not represent. All
    // orders are then summed one by one.
    if (metric.exact_degree > 0.0) return;
    interpolation_.emplace(theta_bands);
    for (std::size_t k = 0; k < kernels_.size(); ++k) find_factors(k);
  }

  /// Find the terms that speeds share, if there are any.
  void find_terms(int threads, Watch& watch) {
    if (!interpolation_) return;
    for (const Kernel& kernel : kernels_) {
      auto& terms = terms_[static_cast<std::size_t>(kernel.request.entry)];
      if (!terms) terms = spectrum_.terms(kernel.request.entry, interpolation_->sampled(), threads, watch);
      has_terms_ = terms != nullptr;
    }
  }

  /// Number of orders m that are summed along theta together.
  static constexpr Index kBlock = 16;
  [[nodiscard]] std::size_t blocks() const { return (orders_.size() + kBlock - 1) / kBlock; }

  void sum_along_theta(std::size_t block, const Worker& worker) {
    const Index first = static_cast<Index>(block) * kBlock;
    const Index count = std::min(kBlock, static_cast<Index>(orders_.size()) - first);
    std::vector<OrderSeries> series(static_cast<std::size_t>(count));
    const auto find_series = [&] {
      for (std::size_t i = 0; i < series.size(); ++i) {
        spectrum_.series(static_cast<std::size_t>(first) + i, series[i]);
        worker.checkpoint();
      }
    };
    if (!has_terms_) find_series();
    for (RowMajor& sums : sums_) sums.middleRows(2 * first, 2 * count).setZero();
    std::vector<RowMajor> at_sampled(kernels_.size(), RowMajor::Zero(2 * count, theta_waves_.sampled_offsets()));
    if (!interpolation_ || !sum_interpolated(first, series, at_sampled, worker)) {
      if (has_terms_) find_series();
      sum_one_by_one(first, series, at_sampled, worker);
    }
    if (theta_waves_.long_bands() == 0) return;
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      add_product(at_sampled[k], theta_waves_.polynomials(kernels_[k].odd).transpose(),
                  sums_[k].middleRows(2 * first, 2 * count));
      worker.checkpoint();
    }
  }

  /// Number of columns of the tables (offsets in theta) whose sums along phi are computed together.
  static constexpr int kStripe = 64;
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
  /// Compute the factors for a kernel, or reuse those of a kernel with the same weights and parity.
  void find_factors(std::size_t k) {
    const Kernel& kernel = kernels_[k];
    TableRequest representative = kernel.request;
    representative.entry = Entry::rr;
    representative.phi_shift = 0.0;
    const auto found = std::ranges::find_if(factors_, [&](const SumFactors& factors) {
      return factors.representative == representative && factors.odd == kernel.odd;
    });
    factors_of_kernel_.push_back(static_cast<std::size_t>(found - factors_.begin()));
    if (found != factors_.end()) return;
    const Index count = interpolation_->sampled().size();
    SumFactors factors{.representative = representative,
                       .odd = kernel.odd,
                       .at_sampled = RowMajor::Zero(count, theta_waves_.sampled_offsets()),
                       .at_all = RowMajor::Zero(count, theta_reach_ + 1)};
    for (std::size_t band = 0; band < theta_bands_.size(); ++band) {
      const RowMajor terms = theta_weights_[k][band].matrix().asDiagonal() * theta_waves_(band, kernel.odd);
      interpolation_->add_sums(band, terms, band < theta_waves_.long_bands() ? factors.at_sampled : factors.at_all);
    }
    factors_.push_back(std::move(factors));
  }

  /// Sum over n for a block of orders m, from the values at the sampled orders n.
  /// @return whether the sampled orders resolve all others
  bool sum_interpolated(Index first, const std::vector<OrderSeries>& series, std::vector<RowMajor>& at_sampled,
                        const Worker& worker) {
    const auto count = static_cast<Index>(series.size());
    std::vector<RowMajor> values(kernels_.size(), RowMajor(2 * count, interpolation_->sampled().size()));
    for (Index i = 0; i < count; ++i) {
      const double m = orders_[static_cast<std::size_t>(first + i)] / metric_.sine;
      const EntryValues entry_values =
          has_terms_ ? EntryValues(spectrum_, terms_, static_cast<std::size_t>(first + i))
                     : EntryValues(m, interpolation_->sampled(), series[static_cast<std::size_t>(i)], kernels_);
      if (!is_resolved(entry_values)) return false;
      for (std::size_t k = 0; k < kernels_.size(); ++k) {
        put(phi_weights_[k][first + i] * entry_values[kernels_[k].request.entry], i, values[k]);
      }
      worker.checkpoint();
    }
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      const SumFactors& factors = factors_[factors_of_kernel_[k]];
      add_product(values[k], factors.at_sampled, at_sampled[k]);
      for (std::size_t r = 0; r < interpolation_->ranges().size(); ++r) {
        const InterpolatedOrders::Range& range = interpolation_->ranges()[r];
        const Index width = width_of(r);
        if (range.count == 0 || width == 0) continue;
        add_product(values[k].middleCols(range.first, range.count),
                    factors.at_all.block(range.first, 0, range.count, width),
                    sums_[k].block(2 * first, 0, 2 * count, width));
      }
      worker.checkpoint();
    }
    return true;
  }

  /// Number of offsets that the bands of a range reach, without the bands summed at sampled offsets.
  [[nodiscard]] Index width_of(std::size_t range) const {
    Index width = 0;
    for (std::size_t band = theta_waves_.long_bands(); band < theta_bands_.size(); ++band) {
      if (interpolation_->has_orders(band, range)) width = std::max(width, theta_waves_(band, false).cols());
    }
    return width;
  }

  /// Whether the last terms of the polynomials are negligible compared with the entries.
  [[nodiscard]] bool is_resolved(const EntryValues& values) const {
    for (const InterpolatedOrders::Range& range : interpolation_->ranges()) {
      if (!range.is_interpolated) continue;
      const auto largest = [&](Entry entry) {
        return values.has(entry) ? std::sqrt(values[entry].segment(range.first, range.count).abs2().maxCoeff()) : 0.0;
      };
      // The values already contain the factors m and n of mixed entries, so there is nothing to divide by. Without the
      // entry of phi by phi, the mixed entries are compared with that of r by r, which is about as large.
      const Entry along = values.has(Entry::phiphi) ? Entry::phiphi : Entry::rr;
      const auto sizes = entry_sizes(largest(Entry::rr), largest(along), 1.0, 1.0);
      for (int e = 0; e < kEntries; ++e) {
        const auto entry = static_cast<Entry>(e);
        if (!values.has(entry)) continue;
        const Eigen::Vector2cd last = range.last_terms * values[entry].segment(range.first, range.count).matrix();
        const double size = std::max(sizes[static_cast<std::size_t>(e)], largest(entry));
        if (last.cwiseAbs2().maxCoeff() > std::pow(kUnresolved * size, 2)) return false;
      }
    }
    return true;
  }

  /// Sum over n from all orders n.
  void sum_one_by_one(Index first, const std::vector<OrderSeries>& series, std::vector<RowMajor>& at_sampled,
                      const Worker& worker) {
    const auto count = static_cast<Index>(series.size());
    for (std::size_t band = 0; band < theta_bands_.size(); ++band) {
      const std::vector<RowMajor> summands = evaluate(first, series, band, worker);
      for (std::size_t k = 0; k < kernels_.size(); ++k) {
        const RowMajor& wave = theta_waves_(band, kernels_[k].odd);
        if (band < theta_waves_.long_bands()) {
          add_product(summands[k], wave, at_sampled[k]);
        } else {
          add_product(summands[k], wave, sums_[k].block(2 * first, 0, 2 * count, wave.cols()));
        }
        worker.checkpoint();
      }
    }
  }

  /// Sums over m, at all offsets in phi and some in theta: cosines times real parts, or sines times imaginary parts.
  [[nodiscard]] RowMajor sum_of_bands(std::size_t k, Index start, Index width, bool odd, int phi_reach,
                                      const Worker& worker) const {
    RowMajor sum = RowMajor::Zero(phi_reach + 1, width);
    RowMajor at_sampled = RowMajor::Zero(phi_waves_.sampled_offsets(), width);
    Index first = 0;
    for (std::size_t band = 0; band < phi_bands_.size(); ++band) {
      const Index count = phi_bands_[band].orders.size();
      const RowMajor& wave = phi_waves_(band, odd);
      const auto sums = every_other_row(sums_[k], 2 * first + (odd ? 1 : 0), count, start, width);
      if (band < phi_waves_.long_bands()) {
        add_product(wave.transpose(), sums, at_sampled);
      } else {
        add_product(wave.transpose(), sums, sum.topRows(wave.cols()));
      }
      first += count;
      worker.checkpoint();
    }
    if (phi_waves_.long_bands() > 0) add_product(phi_waves_.polynomials(odd), at_sampled, sum);
    return sum;
  }

  /// Weighted compliances of a block of orders m at the orders n of a band, for each kernel. Each m has two rows, real
  /// and imaginary parts.
  [[nodiscard]] std::vector<RowMajor> evaluate(Index first, const std::vector<OrderSeries>& series, std::size_t band,
                                               const Worker& worker) const {
    const Eigen::ArrayXd& n = theta_bands_[band].orders;
    const auto count = static_cast<Index>(series.size());
    std::vector<RowMajor> summands(kernels_.size(), RowMajor(2 * count, n.size()));
    for (Index i = 0; i < count; ++i) {
      const double m = orders_[static_cast<std::size_t>(first + i)] / metric_.sine;
      const EntryValues values(m, n, series[static_cast<std::size_t>(i)], kernels_);
      const Eigen::ArrayXd local = local_weights(m, n, metric_);
      for (std::size_t k = 0; k < kernels_.size(); ++k) {
        put(phi_weights_[k][first + i] * values[kernels_[k].request.entry] * theta_weights_[k][band] * local, i,
            summands[k]);
      }
      worker.checkpoint();
    }
    return summands;
  }

  const Spectrum& spectrum_;
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
  std::optional<InterpolatedOrders> interpolation_;
  SharedTerms terms_;  // at the sampled orders n
  bool has_terms_ = false;
  std::vector<SumFactors> factors_;
  std::vector<std::size_t> factors_of_kernel_;  // [kernel], index in `factors_`
  /// [kernel], sums over n: two rows per m (real, imaginary) and one column per offset in theta.
  std::vector<RowMajor> sums_;
};

}  // namespace

std::vector<Table> OrderSum::tables(const std::vector<TableRequest>& requests, int phi_reach, int theta_reach,
                                    int threads, Watch& watch) const {
  Synthesis synthesis(requests, phi_bands_, theta_bands_, *spectrum_, metric_, mesh_, radius_, phi_reach, theta_reach);
  synthesis.find_terms(threads, watch);
  parallel_for(synthesis.blocks(), threads, watch, "summing orders",
               [&](std::size_t block, const Worker& worker) { synthesis.sum_along_theta(block, worker); });

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

#include "influence/theta_sums.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "base/recent_cache.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::Index;
using RowMajor = RowMajorMatrix;

/// Number of orders m that are summed together.
constexpr Index kBlock = 16;

/// If the last terms of the polynomial in n exceed this fraction of the entry, the sampled orders do not resolve the
/// entry. The fraction is ten times the tolerance of the series from which the compliances are evaluated.
constexpr double kUnresolved = 10.0 * kSeriesTolerance;

/// Largest number of values per term for which the sums of terms are kept, 1 MB, and of all values that are kept, 64
/// MB. Larger windows are rarely solved at many speeds. With inertia there may be more than two terms, so that
/// the sums of the terms take longer than those of a single speed.
constexpr std::size_t kMaxNumbersPerTerm = 131072;
constexpr std::size_t kMaxNumbers = 8388608;

/// Weights of a kernel along theta.
Eigen::ArrayXd theta_weights(const Kernel& kernel, const OrderBand& band, double spacing) {
  return band.weights * band.orders.unaryExpr([&](double n) {
    const double source = spherical_bessel(kernel.request.source_shape, 0.5 * n * spacing);
    return kernel.request.power ? source * spherical_bessel(kernel.receiver_shape(), 0.5 * n * spacing) : source;
  });
}

/// Weight of each order (m, n) in this sum. The rest of the weight is in the sum over the degrees of a sphere
/// (`sphere_sum.hpp`).
Eigen::ArrayXd local_weights(double m, const Eigen::ArrayXd& n, const LocalMetric& metric) {
  if (metric.exact_degree == 0.0) return Eigen::ArrayXd::Ones(n.size());
  return 1.0 - (m * m + n.square()).sqrt().unaryExpr([&](double k) { return exact_share(k, metric.exact_degree); });
}

/// Store real and imaginary parts as the two rows of an order.
template <class Values>
void put(const Values& values, Index order, RowMajor& rows) {
  const Eigen::ArrayXcd evaluated = values;
  rows.row(2 * order) = evaluated.real().matrix().transpose();
  rows.row(2 * order + 1) = evaluated.imag().matrix().transpose();
}

}  // namespace

Kernel::Kernel(const TableRequest& requested)
    : request(requested), odd(is_odd(request.entry) != ((request.source_shape + receiver_shape()) % 2 == 1)) {
  constexpr std::array<cplx, 4> kPowersOfI{cplx(1, 0), cplx(0, 1), cplx(-1, 0), cplx(0, -1)};
  const int power = receiver_shape() - request.source_shape + (odd ? 1 : 0);
  phase = kPowersOfI[static_cast<std::size_t>(power + 4) % 4];
}

class ThetaSums::EntryValues {
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
  EntryValues(const Spectrum& spectrum, const SharedTerms& terms, Index i) {
    for (std::size_t entry = 0; entry < values_.size(); ++entry) {
      if (!terms[entry]) continue;
      Eigen::ArrayXcd& values = values_[entry];
      values.setZero(terms[entry]->front().cols());
      for (std::size_t j = 0; j < terms[entry]->size(); ++j) {
        const cplx factor = spectrum.factor(static_cast<Entry>(entry), static_cast<std::size_t>(i), j);
        values += factor * (*terms[entry])[j].row(i).transpose().array();
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

class ThetaSums::TermValues {
 public:
  TermValues(const SharedTerms& terms, Index order, std::size_t term) : terms_(&terms), order_(order), term_(term) {}

  [[nodiscard]] bool has(Entry entry) const { return (*terms_)[static_cast<std::size_t>(entry)] != nullptr; }
  [[nodiscard]] auto operator[](Entry entry) const {
    return (*(*terms_)[static_cast<std::size_t>(entry)])[term_].row(order_).transpose().array();
  }

 private:
  const SharedTerms* terms_;
  Index order_;
  std::size_t term_;
};

ThetaSums::ThetaSums(const std::vector<Kernel>& kernels, const std::vector<Eigen::ArrayXcd>& phi_weights,
                     ThetaSumInput input, int threads, Watch& watch)
    : kernels_(kernels), phi_weights_(phi_weights), input_(std::move(input)) {
  // With a local metric, the terms contain the weights `local_weights`, which polynomials in n do not represent. All
  // orders are then summed one by one.
  const bool has_terms = !kernels.empty() && input_.metric.exact_degree == 0.0 && !input_.spectrum.terms_key().empty();
  const std::size_t numbers = kernels.size() * input_.orders.size() * static_cast<std::size_t>(input_.reach + 1);
  if (has_terms && numbers <= kMaxNumbersPerTerm) term_sums_ = find_term_sums(threads, watch);
  if (term_sums_) return;
  prepare_waves();
  if (has_terms) find_terms(threads, watch);
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    sums_.emplace_back(2 * static_cast<Index>(input_.orders.size()), input_.reach + 1);
  }
  parallel_for(blocks(), threads, watch, "summing orders",
               [&](std::size_t block, const Worker& worker) { sum(block, worker); });
}

void ThetaSums::fill(std::size_t kernel, Part part, Index first, Index start, RowMajor& sums) const {
  const bool is_real = part == Part::real;
  if (!term_sums_) {
    for (Index i = 0; i < sums.rows(); ++i) {
      sums.row(i) = sums_[kernel].row(2 * (first + i) + (is_real ? 0 : 1)).segment(start, sums.cols());
    }
    return;
  }
  const std::vector<RowMajor>& sums_of_terms = (*term_sums_)[kernel];
  const Entry entry = kernels_[kernel].request.entry;
  for (Index i = 0; i < sums.rows(); ++i) {
    const Index order = first + i;
    for (std::size_t j = 0; j < sums_of_terms.size(); ++j) {
      const cplx factor =
          phi_weights_[kernel][order] * input_.spectrum.factor(entry, static_cast<std::size_t>(order), j);
      const double share = is_real ? factor.real() : factor.imag();
      const auto sum = sums_of_terms[j].row(order).segment(start, sums.cols());
      if (j == 0) {
        sums.row(i) = share * sum;
      } else {
        sums.row(i) += share * sum;
      }
    }
  }
}

std::size_t ThetaSums::blocks() const { return (input_.orders.size() + kBlock - 1) / kBlock; }

ThetaSums::Block ThetaSums::block_of(std::size_t number) const {
  const Index first = static_cast<Index>(number) * kBlock;
  return {.first = first, .count = std::min(kBlock, static_cast<Index>(input_.orders.size()) - first)};
}

double ThetaSums::wave_number(Index order) const {
  return input_.orders[static_cast<std::size_t>(order)] / input_.metric.sine;
}

void ThetaSums::sum(std::size_t number, const Worker& worker) {
  const Block block = block_of(number);
  std::vector<OrderSeries> series;
  const auto find_series = [&] {
    series.resize(static_cast<std::size_t>(block.count));
    for (std::size_t i = 0; i < series.size(); ++i) {
      input_.spectrum.series(static_cast<std::size_t>(block.first) + i, series[i]);
      worker.checkpoint();
    }
  };
  const bool has_terms = std::ranges::any_of(terms_, [](const auto& terms) { return terms != nullptr; });
  if (!has_terms) find_series();
  for (RowMajor& sums : sums_) sums.middleRows(2 * block.first, 2 * block.count).setZero();
  if (interpolation_ && sum_interpolated(block, series, worker)) return;
  if (has_terms) find_series();
  sum_one_by_one(block, series, worker);
}

void ThetaSums::find_terms(int threads, Watch& watch) {
  for (const Kernel& kernel : kernels_) {
    auto& terms = terms_[static_cast<std::size_t>(kernel.request.entry)];
    if (!terms) terms = input_.spectrum.terms(kernel.request.entry, interpolation_->sampled(), threads, watch);
  }
}

/// Compute the waves and, if orders are interpolated, the factors of the values at the sampled orders.
void ThetaSums::prepare_waves() {
  if (waves_) return;
  waves_.emplace(input_.bands, input_.spacing, input_.reach);
  for (const Kernel& kernel : kernels_) {
    weights_.emplace_back();
    for (const OrderBand& band : input_.bands) weights_.back().push_back(theta_weights(kernel, band, input_.spacing));
  }
  if (input_.metric.exact_degree > 0.0) return;
  if (!interpolation_) interpolation_.emplace(input_.bands);
  for (std::size_t k = 0; k < kernels_.size(); ++k) find_factors(k);
}

/// Compute the factors for a kernel, or reuse those of a kernel with the same weights and parity.
void ThetaSums::find_factors(std::size_t k) {
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
                     .at_sampled = RowMajor::Zero(count, waves_->sampled_offsets()),
                     .at_all = RowMajor::Zero(count, input_.reach + 1)};
  for (std::size_t band = 0; band < input_.bands.size(); ++band) {
    const RowMajor terms = weights_[k][band].matrix().asDiagonal() * (*waves_)(band, kernel.odd);
    interpolation_->add_sums(band, terms, band < waves_->long_bands() ? factors.at_sampled : factors.at_all);
  }
  factors_.push_back(std::move(factors));
}

/// Add the sums of rows of values at the sampled orders n.
/// @param[in] values [row, sampled order]
/// @param[in,out] sums [row, offset]
void ThetaSums::add_sums(std::size_t k, const Eigen::Ref<const RowMajor>& values, Eigen::Ref<RowMajor> sums) const {
  const SumFactors& factors = factors_[factors_of_kernel_[k]];
  for (std::size_t r = 0; r < interpolation_->ranges().size(); ++r) {
    const InterpolatedOrders::Range& range = interpolation_->ranges()[r];
    const Index width = width_of(r);
    if (range.count == 0 || width == 0) continue;
    add_product(values.middleCols(range.first, range.count), factors.at_all.block(range.first, 0, range.count, width),
                sums.leftCols(width));
  }
  if (waves_->long_bands() == 0) return;
  RowMajor at_sampled = RowMajor::Zero(values.rows(), waves_->sampled_offsets());
  add_product(values, factors.at_sampled, at_sampled);
  add_product(at_sampled, waves_->polynomials(kernels_[k].odd).transpose(), sums);
}

/// Number of offsets that the bands of a range reach, without the bands summed at sampled offsets.
Index ThetaSums::width_of(std::size_t range) const {
  Index width = 0;
  for (std::size_t band = waves_->long_bands(); band < input_.bands.size(); ++band) {
    if (interpolation_->has_orders(band, range)) width = std::max(width, (*waves_)(band, false).cols());
  }
  return width;
}

/// Whether the last terms of the polynomials are negligible.
/// @param[in] summands values at the sampled orders, one element per term; the first term sets the scale
template <class Values>
bool ThetaSums::is_resolved(const std::vector<Values>& summands) const {
  const Values& sizes = summands.front();
  for (const InterpolatedOrders::Range& range : interpolation_->ranges()) {
    if (!range.is_interpolated) continue;
    const auto largest = [&](Entry entry) {
      return sizes.has(entry) ? std::sqrt(sizes[entry].segment(range.first, range.count).abs2().maxCoeff()) : 0.0;
    };
    // The values already contain the factors m and n of mixed entries, so there is nothing to divide by. Without the
    // entry of phi by phi, the mixed entries are compared with that of r by r, which is about as large.
    const Entry along = sizes.has(Entry::phiphi) ? Entry::phiphi : Entry::rr;
    const auto entries = entry_sizes(largest(Entry::rr), largest(along), 1.0, 1.0);
    for (int e = 0; e < kEntries; ++e) {
      const auto entry = static_cast<Entry>(e);
      if (!sizes.has(entry)) continue;
      const double size = std::max(entries[static_cast<std::size_t>(e)], largest(entry));
      for (const Values& values : summands) {
        const auto last = (range.last_terms * values[entry].segment(range.first, range.count).matrix()).eval();
        if (last.cwiseAbs2().maxCoeff() > std::pow(kUnresolved * size, 2)) return false;
      }
    }
  }
  return true;
}

/// All numbers that determine the sums of the terms.
std::vector<double> ThetaSums::key_of_term_sums() const {
  std::vector<double> key = input_.spectrum.terms_key();
  key.push_back(static_cast<double>(kernels_.size()));
  for (const Kernel& kernel : kernels_) {
    const TableRequest& request = kernel.request;
    for (const int number :
         {static_cast<int>(request.entry), request.source_shape, request.power ? 1 : 0, kernel.receiver_shape()}) {
      key.push_back(number);
    }
  }
  for (const OrderBand& band : input_.bands) {
    key.push_back(band.reach);
    key.push_back(static_cast<double>(band.orders.size()));
    key.insert(key.end(), band.orders.begin(), band.orders.end());
    key.insert(key.end(), band.weights.begin(), band.weights.end());
  }
  key.push_back(std::log(input_.spacing));
  key.push_back(input_.reach);
  return key;
}

/// Return the sums of the terms that speeds share; null if the sampled orders do not resolve them.
std::shared_ptr<const ThetaSums::TermSums> ThetaSums::find_term_sums(int threads, Watch& watch) {
  static RecentCache<TermSums> cache(64, kMaxNumbers);
  std::vector<double> key = key_of_term_sums();
  std::shared_ptr<const TermSums> found = cache.find(key);
  if (!found) {
    prepare_waves();
    find_terms(threads, watch);
    found = std::make_shared<const TermSums>(sum_terms(threads, watch));
    std::size_t numbers = 0;
    for (const auto& sums : *found) numbers += sums.size() * static_cast<std::size_t>(sums.front().size());
    cache.add(std::move(key), found, numbers);
  }
  return found->empty() ? nullptr : found;
}

ThetaSums::TermSums ThetaSums::sum_terms(int threads, Watch& watch) const {
  const auto count = static_cast<Index>(input_.orders.size());
  const auto terms_of = [&](std::size_t k) -> const EntryTerms& {
    return *terms_[static_cast<std::size_t>(kernels_[k].request.entry)];
  };
  TermSums sums(kernels_.size());
  for (std::size_t k = 0; k < sums.size(); ++k) {
    for (std::size_t j = 0; j < terms_of(k).size(); ++j) sums[k].emplace_back(count, input_.reach + 1);
  }
  std::atomic<bool> all_resolved{true};
  parallel_for(blocks(), threads, watch, "summing orders", [&](std::size_t number, const Worker& worker) {
    const auto [first, size] = block_of(number);
    for (Index i = first; i < first + size && all_resolved; ++i) {
      std::vector<TermValues> summands;
      summands.reserve(terms_of(0).size());
      for (std::size_t j = 0; j < terms_of(0).size(); ++j) summands.emplace_back(terms_, i, j);
      if (!is_resolved(summands)) all_resolved = false;
    }
    if (!all_resolved) return;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const EntryTerms& entry = terms_of(k);
      const Index rows = size * static_cast<Index>(entry.size());
      RowMajor values(rows, entry.front().cols());
      RowMajor summed = RowMajor::Zero(rows, input_.reach + 1);
      for (std::size_t j = 0; j < entry.size(); ++j) {
        values.middleRows(static_cast<Index>(j) * size, size) = entry[j].middleRows(first, size);
      }
      add_sums(k, values, summed);
      for (std::size_t j = 0; j < entry.size(); ++j) {
        sums[k][j].middleRows(first, size) = summed.middleRows(static_cast<Index>(j) * size, size);
      }
      worker.checkpoint();
    }
  });
  return all_resolved ? std::move(sums) : TermSums{};
}

/// Sum over n for a block of orders m, from the values at the sampled orders n.
/// @param[in] series series of the orders; empty if the terms are known
/// @return whether the sampled orders resolve all others
bool ThetaSums::sum_interpolated(const Block& block, const std::vector<OrderSeries>& series, const Worker& worker) {
  std::vector<RowMajor> values(kernels_.size(), RowMajor(2 * block.count, interpolation_->sampled().size()));
  for (Index i = 0; i < block.count; ++i) {
    const EntryValues entry_values = series.empty()
                                         ? EntryValues(input_.spectrum, terms_, block.first + i)
                                         : EntryValues(wave_number(block.first + i), interpolation_->sampled(),
                                                       series[static_cast<std::size_t>(i)], kernels_);
    if (!is_resolved(std::vector{entry_values})) return false;
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      put(phi_weights_[k][block.first + i] * entry_values[kernels_[k].request.entry], i, values[k]);
    }
    worker.checkpoint();
  }
  for (std::size_t k = 0; k < kernels_.size(); ++k) {
    add_sums(k, values[k], sums_[k].middleRows(2 * block.first, 2 * block.count));
    worker.checkpoint();
  }
  return true;
}

/// Sum over n from all orders n.
void ThetaSums::sum_one_by_one(const Block& block, const std::vector<OrderSeries>& series, const Worker& worker) {
  std::vector<RowMajor> at_sampled(kernels_.size(), RowMajor::Zero(2 * block.count, waves_->sampled_offsets()));
  for (std::size_t band = 0; band < input_.bands.size(); ++band) {
    const std::vector<RowMajor> summands = evaluate(block, series, band, worker);
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      const RowMajor& wave = (*waves_)(band, kernels_[k].odd);
      if (band < waves_->long_bands()) {
        add_product(summands[k], wave, at_sampled[k]);
      } else {
        add_product(summands[k], wave, sums_[k].block(2 * block.first, 0, 2 * block.count, wave.cols()));
      }
      worker.checkpoint();
    }
  }
  if (waves_->long_bands() == 0) return;
  for (std::size_t k = 0; k < kernels_.size(); ++k) {
    add_product(at_sampled[k], waves_->polynomials(kernels_[k].odd).transpose(),
                sums_[k].middleRows(2 * block.first, 2 * block.count));
    worker.checkpoint();
  }
}

/// Weighted compliances of a block of orders m at the orders n of a band, for each kernel. Each m has two rows, real
/// and imaginary parts.
std::vector<RowMajor> ThetaSums::evaluate(const Block& block, const std::vector<OrderSeries>& series, std::size_t band,
                                          const Worker& worker) const {
  const Eigen::ArrayXd& n = input_.bands[band].orders;
  std::vector<RowMajor> summands(kernels_.size(), RowMajor(2 * block.count, n.size()));
  for (Index i = 0; i < block.count; ++i) {
    const double m = wave_number(block.first + i);
    const EntryValues values(m, n, series[static_cast<std::size_t>(i)], kernels_);
    const Eigen::ArrayXd local = local_weights(m, n, input_.metric);
    for (std::size_t k = 0; k < kernels_.size(); ++k) {
      put(phi_weights_[k][block.first + i] * values[kernels_[k].request.entry] * weights_[k][band] * local, i,
          summands[k]);
    }
    worker.checkpoint();
  }
  return summands;
}

}  // namespace viscoroll::detail

/// @file
/// @brief Sums of the compliance over the orders n, for every order m and at all offsets in theta.
///
/// If all layers share one relaxation function, the compliance is a sum of a few real functions with factors that
/// depend on the speed (`Spectrum::terms`). The sums of these functions are kept for further speeds.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/dense_products.hpp"
#include "base/parallel.hpp"
#include "influence/band_waves.hpp"
#include "influence/interpolated_orders.hpp"
#include "influence/order_bands.hpp"
#include "influence/table.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief How orders are summed at a latitude of a sphere: the metric of the latitude, and the degree up to which
/// `sphere_sum.hpp` replaces this sum.
struct LocalMetric {
  double sine = 1.0;  ///< sin(theta); order m has the wave number m / sine along phi
  /// degree in the middle of the smooth step from the sum over degrees to this sum; 0: this sum contains all orders
  double exact_degree = 0.0;
};

/// @brief A requested table, and the parity in n and the constant factor of the terms of its sum. The parity follows
/// from the entry and from the Legendre degrees of the patches.
struct Kernel {
  TableRequest request;
  bool odd;
  /// i^(receiver degree - source degree); if odd, also times i, since e^(i n theta) sums to i sin(n theta)
  std::complex<double> phase = 1.0;

  explicit Kernel(const TableRequest& request);
  [[nodiscard]] int receiver_shape() const { return request.power ? request.receiver_shape : 0; }
};

/// @brief Orders and offsets of sums along theta.
struct ThetaSumInput {
  const Spectrum& spectrum;
  const std::vector<OrderBand>& bands;  ///< orders n
  std::vector<double> orders;           ///< orders m
  LocalMetric metric;
  double spacing;  ///< spacing of the offsets [rad]
  int reach;       ///< largest offset [spacings]
};

/// @brief Weighted sums over n of some kernels.
class ThetaSums {
 public:
  /// @param[in] kernels,phi_weights kernels, and a weight of every order m for each kernel; must outlive this object
  /// @param[in] input orders and offsets
  /// @param[in] threads,watch threads, progress and cancellation
  ThetaSums(const std::vector<Kernel>& kernels, const std::vector<Eigen::ArrayXcd>& phi_weights, ThetaSumInput input,
            int threads, Watch& watch);
  // A copy in another object would refer to the kernels and weights of the first one.
  ThetaSums(const ThetaSums&) = delete;
  ThetaSums& operator=(const ThetaSums&) = delete;
  ~ThetaSums() = default;

  /// @brief Part of the complex sums.
  enum class Part { real, imaginary };
  /// @brief Compute one part of the sums of some orders at some offsets.
  /// @param[in] kernel number of the kernel
  /// @param[in] part real or imaginary parts
  /// @param[in] first index of the first order m
  /// @param[in] start first offset
  /// @param[out] sums [order, offset], with the numbers of orders and offsets to be filled
  void fill(std::size_t kernel, Part part, Eigen::Index first, Eigen::Index start, RowMajorMatrix& sums) const;

 private:
  /// Terms of the entries, see `Spectrum::terms`; null if an entry is not needed.
  using SharedTerms = std::array<std::shared_ptr<const EntryTerms>, kEntries>;
  /// [kernel][term], sums of the terms, [order m, offset]; empty if the sampled orders do not resolve them.
  using TermSums = std::vector<std::vector<RowMajorMatrix>>;
  /// Entries needed by the kernels, at a list of orders n.
  class EntryValues;
  /// A term of these entries for an order m.
  class TermValues;
  /// Orders m of a block.
  struct Block {
    Eigen::Index first;
    Eigen::Index count;
  };

  /// The sums of a kernel along theta are linear in its values at the sampled orders; these are the factors of the
  /// values.
  struct SumFactors {
    TableRequest representative;  // a request with these weights, with the entry rr and without shift along phi
    bool odd;
    RowMajorMatrix at_sampled;  // [sampled order, sampled offset]
    RowMajorMatrix at_all;      // [sampled order, offset]
  };

  [[nodiscard]] Block block_of(std::size_t number) const;
  [[nodiscard]] double wave_number(Eigen::Index order) const;
  void prepare_waves();
  void find_factors(std::size_t k);
  [[nodiscard]] std::vector<double> key_of_term_sums() const;
  [[nodiscard]] std::shared_ptr<const TermSums> find_term_sums(int threads, Watch& watch);
  void find_terms(int threads, Watch& watch);
  [[nodiscard]] TermSums sum_terms(int threads, Watch& watch) const;
  template <class Values>
  [[nodiscard]] bool is_resolved(const std::vector<Values>& summands) const;
  [[nodiscard]] Eigen::Index width_of(std::size_t range) const;
  void add_sums(std::size_t k, const Eigen::Ref<const RowMajorMatrix>& values, Eigen::Ref<RowMajorMatrix> sums) const;
  [[nodiscard]] std::size_t blocks() const;
  void sum(std::size_t block, const Worker& worker);
  bool sum_interpolated(const Block& block, const std::vector<OrderSeries>& series, const Worker& worker);
  void sum_one_by_one(const Block& block, const std::vector<OrderSeries>& series, const Worker& worker);
  [[nodiscard]] std::vector<RowMajorMatrix> evaluate(const Block& block, const std::vector<OrderSeries>& series,
                                                     std::size_t band, const Worker& worker) const;

  const std::vector<Kernel>& kernels_;
  const std::vector<Eigen::ArrayXcd>& phi_weights_;
  ThetaSumInput input_;
  std::shared_ptr<const TermSums> term_sums_;  // null if they are not kept
  // The members below are empty if the sums of terms came from the cache.
  std::vector<RowMajorMatrix> sums_;  // [kernel], two rows per m (real, imaginary) and one column per offset
  SharedTerms terms_;                 // at the sampled orders n
  std::optional<BandWaves> waves_;
  std::vector<std::vector<Eigen::ArrayXd>> weights_;  // [kernel][band]
  std::optional<InterpolatedOrders> interpolation_;
  std::vector<SumFactors> factors_;
  std::vector<std::size_t> factors_of_kernel_;  // [kernel], index in `factors_`
};

}  // namespace viscoroll::detail

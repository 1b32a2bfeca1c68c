/// @file
/// @brief Spectrum of any body: sampled in m and n where the moduli are smooth, else along n for every order m.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "modal/harmonic_body.hpp"
#include "modal/spectrum.hpp"

namespace viscoroll::detail {

/// @brief Measured moduli of layers on a run of orders without kinks, as polynomials in ln m.
///
/// The polynomials interpolate the moduli at some of the orders. These are Leja points: each one maximizes the product
/// of the distances to the previous ones, which makes the interpolation well conditioned. Points are added until the
/// polynomials agree with the moduli at all orders of the run. Between the orders the polynomials supply moduli without
/// an evaluation of the user's function.
class MeasuredModuli {
 public:
  /// @brief Moduli of no layer.
  MeasuredModuli() = default;

  /// @brief Interpolate the moduli of a run.
  /// @param[in] body layers at the orders m
  /// @param[in] orders indices of the orders of the run, at least one, with m > 0 ascending
  /// @param[in] max_terms largest number of terms of a polynomial
  /// @return polynomials; none if `max_terms` terms do not agree with the moduli at every order of the run
  [[nodiscard]] static std::optional<MeasuredModuli> try_make(const HarmonicBody& body,
                                                              std::span<const std::size_t> orders, int max_terms);

  /// @brief Evaluate the polynomials.
  /// @param[in] orders orders m within the run
  /// @return moduli [Pa], a row for each order and a column for each of `measured_layers`
  [[nodiscard]] Eigen::ArrayXXcd at(std::span<const double> orders) const;

 private:
  [[nodiscard]] double coordinate(double m) const;

  double lowest_m_ = 1.0;
  double highest_m_ = 1.0;
  // Newton's form: sum_j coefficients_[j] prod_{i < j} 2 (x - nodes_[i]), x from -1 to 1
  std::vector<double> nodes_;
  std::vector<Eigen::ArrayXcd> coefficients_;  // for each term, one number for each layer
  Eigen::Index layers_ = 0;
};

/// @brief Spectrum that solves the layers at the Chebyshev nodes of every order m: about thirty solutions in place of
/// N_t.
class OrderByOrderSpectrum final : public Spectrum {
 public:
  OrderByOrderSpectrum(std::shared_ptr<const HarmonicBody> body, double highest_n)
      : body_(std::move(body)), highest_n_(highest_n) {}

  void series(std::size_t i, OrderSeries& series) const override;

 private:
  std::shared_ptr<const HarmonicBody> body_;
  double highest_n_;
};

/// @brief Chebyshev series in two variables, ln m and ln(k^2 / m^2), with k^2 = m^2 + n^2.
///
/// Multiplied by m and by the modulus of the outer layer, the compliance is as smooth in ln m as in ln k: a modulus has
/// its poles and branch cuts where ln m is pi/2 off the real axis. About 24 solutions therefore represent all orders m
/// in three octaves. Measured moduli have kinks; 6 to 24 solutions represent the orders between two kinks. Runs with
/// fewer orders are solved order by order.
class OrderPanels final : public Spectrum {
 public:
  /// @param[in] body layers at the orders m
  /// @param[in] highest_n largest order n that is evaluated
  /// @param[in] threads number of threads, 0 for all cores
  /// @param[in] watch progress and cancellation
  OrderPanels(std::shared_ptr<const HarmonicBody> body, double highest_n, int threads, Watch& watch);

  void series(std::size_t i, OrderSeries& series) const override;

  /// @brief Consecutive orders over which the moduli are smooth.
  struct SmoothRun {
    double lowest_m = 0.0;
    double highest_m = 0.0;
    std::size_t count = 0;
    MeasuredModuli measured;
    int nodes = 0;  ///< estimated number of Chebyshev nodes in ln m that resolve the compliance
  };

  /// @brief Series on a range of m and a range of k^2 / m^2.
  struct Cell {
    double lowest_m;
    double highest_m;
    double lowest_ratio;
    double highest_ratio;
    /// Row i contains the coefficients of T_i in ln m: kPanelNodes coefficients in ln(k^2 / m^2) for each entry.
    Eigen::Matrix<std::complex<double>, Eigen::Dynamic, kEntries * kPanelNodes, Eigen::RowMajor> series;
  };

 private:
  struct Range {
    SmoothRun run;
    /// Cells of each part, in ascending order of k^2 / m^2 at every m. Parts are shared with other spectra.
    std::vector<std::shared_ptr<const std::vector<Cell>>> parts;
  };

  void find_ranges();
  [[nodiscard]] const Range* range_of(double m) const;

  std::shared_ptr<const HarmonicBody> body_;
  double highest_n_;
  OrderByOrderSpectrum one_by_one_;
  std::vector<Range> ranges_;
};

}  // namespace viscoroll::detail

#include "modal/self_similar.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/dense_solvers.hpp"
#include "base/recent_cache.hpp"
#include "modal/compliance_recursion.hpp"
#include "modal/harmonic_body.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

constexpr double kInertiaGrowth = 8.0;  // upper bound of |f_{j+1}| / |f_j| for layers on a rigid core
constexpr int kMaxInertiaOrder = 3;

std::size_t softest_layer(const HarmonicBody& body) {
  std::size_t softest = 0;
  for (std::size_t l = 1; l < body.body().layers.size(); ++l) {
    if (std::abs(body.modulus(l, 0)) < std::abs(body.modulus(softest, 0))) softest = l;
  }
  return softest;
}

/// Layers with their inertia multiplied by a factor.
LayerStack<double> with_inertia(LayerStack<double> layers, double factor) {
  for (Medium<double>& medium : layers.media) medium.inertia *= factor;
  return layers;
}

/// Ratio of successive terms of the inertia series per eta, estimated from the change of the compliance by inertia. It
/// is largest for a thin shell without a core, which is soft in bending.
/// @param[in] layers layers in units of g, with the inertia of eta = 1
/// @param[in] includes_zero whether to include order (0, 0), whose growth is large around a small core. It is at rest,
/// so that its eta is the largest one, at which the series is exact if this is the unit of eta.
double inertia_growth(const LayerStack<double>& layers, double highest_eta, bool includes_zero) {
  const std::array at_rest_and_fast{with_inertia(layers, 0.0), with_inertia(layers, highest_eta)};
  constexpr double kHighestOrder = 2000.0;
  std::vector<OrderInLayers<double>> orders;
  for (const LayerStack<double>& turning : at_rest_and_fast) {
    if (includes_zero) orders.push_back({.layers = turning, .m = 0.0, .n = 0.0});
    for (const double share : {1.0, 0.5, 0.1}) {  // m^2 / k^2
      for (double k = 1.0; k < kHighestOrder; k *= 1.25) {
        orders.push_back({.layers = turning, .m = k * std::sqrt(share), .n = k * std::sqrt(1.0 - share)});
      }
    }
  }
  std::vector<Matrix3<double>> solved(orders.size());
  surface_compliances<double>(orders, solved);
  double growth = kInertiaGrowth;
  const std::size_t half = orders.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const Eigen::Vector3d size = solved[i].diagonal().cwiseSqrt();
    const Matrix3<double> change = (solved[half + i] - solved[i]).cwiseQuotient(size * size.transpose());
    growth = std::max(growth, 1.5 * change.cwiseAbs().maxCoeff() / highest_eta);
  }
  return growth;
}

/// Smallest order of the inertia series whose omitted terms are below the tolerance; none above kMaxInertiaOrder.
/// @param[in] ratio ratio of successive terms
std::optional<int> inertia_order(double ratio, double tolerance) {
  double remainder = ratio;
  for (int order = 0; order <= kMaxInertiaOrder; ++order, remainder *= ratio) {
    if (remainder <= tolerance) return order;
  }
  return std::nullopt;
}

/// Entries in the order of `Entry`, divided by their leading powers of m and n: rr, rphi/m, rtheta/n, phiphi,
/// phitheta/(m n), thetatheta.
using Entries = std::array<double, kEntries>;

/// Highest power of m^2 in the coefficient of eta^j of an entry.
int highest_power(Eigen::Index entry, int j) {
  const bool mixes_directions =
      entry == static_cast<int>(Entry::phiphi) || entry == static_cast<int>(Entry::thetatheta);
  return j + (mixes_directions ? 1 : 0);
}

/// Coefficients of eta^j m^(2i) of F at a given k^2, from samples on a grid in eta and t = m^2 / k^2.
class InertiaSeries {
 public:
  /// @param[in] layers layers in units of g, with the inertia of eta = 1
  /// @param[in] highest_eta largest eta of the series, the unit of eta
  /// @param[in] order largest power of eta
  InertiaSeries(const LayerStack<double>& layers, double highest_eta, int order) : order_(order) {
    constexpr std::array<double, kMaxInertiaOrder + 1> kEtas{0.0, 1.0, -1.0, 0.5};
    etas_ = Eigen::Map<const Eigen::VectorXd>(kEtas.data(), order + 1);
    for (const double eta : etas_) layers_.push_back(with_inertia(layers, eta * highest_eta));
    angles_.resize(order + 2);
    for (Eigen::Index i = 0; i < angles_.size(); ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(angles_.size());
      angles_[i] = 0.5 - 0.5 * std::cos(std::numbers::pi * share);
    }
    from_etas_ = dense_inverse(vandermonde(etas_));
    from_angles_ = dense_inverse(vandermonde(angles_));
  }

  /// Row of a panel that contains the coefficient of eta^j m^(2i) of an entry.
  [[nodiscard]] static Eigen::Index row_of(Eigen::Index entry, int j, int i, int order) {
    return (entry * (order + 1) + j) * (order + 2) + i;
  }

  /// Coefficients at the nodes of a panel, one column for each node.
  [[nodiscard]] Eigen::MatrixXd sample(const std::array<double, kPanelNodes>& k2) const {
    std::vector<OrderInLayers<double>> orders;
    orders.reserve(k2.size() * (1 + (layers_.size() - 1) * static_cast<std::size_t>(angles_.size())));
    for (const double square : k2) orders.push_back({.layers = layers_.front(), .m = std::sqrt(square), .n = 0.0});
    for (std::size_t j = 1; j < layers_.size(); ++j) {
      for (const double t : angles_) {
        for (const double square : k2) {
          orders.push_back({.layers = layers_[j], .m = std::sqrt(t * square), .n = std::sqrt((1.0 - t) * square)});
        }
      }
    }
    std::vector<Matrix3<double>> solved(orders.size());
    surface_compliances<double>(orders, solved);

    Eigen::MatrixXd coefficients(row_of(kEntries, 0, 0, order_), kPanelNodes);
    for (std::size_t node = 0; node < k2.size(); ++node) {
      coefficients.col(static_cast<Eigen::Index>(node)) = fit(k2[node], [&](Eigen::Index j, Eigen::Index i) {
        if (j == 0) return rotated(solved[node], k2[node], angles_[i]);
        const auto index = static_cast<std::size_t>(1 + (j - 1) * angles_.size() + i) * k2.size() + node;
        return free_of_powers(solved[index], orders[index].m, orders[index].n);
      });
    }
    return coefficients;
  }

  /// Coefficients of order (0, 0).
  [[nodiscard]] Eigen::VectorXd sample_zero_order() const {
    return fit(0.0, [&](Eigen::Index j, Eigen::Index) -> Entries {
      const Matrix3<double> y = surface_compliance(layers_[static_cast<std::size_t>(j)], 0.0, 0.0);
      return {y(0, 0), 0.0, 0.0, y(1, 1), 0.0, y(2, 2)};
    });
  }

  /// Whether the last terms of all coefficients are negligible relative to their entry.
  [[nodiscard]] bool is_resolved(const Panel<double>& panel) const {
    const auto largest = [&](Entry entry) {
      return panel.series.row(row_of(static_cast<int>(entry), 0, 0, order_)).cwiseAbs().maxCoeff();
    };
    const auto sizes =
        entry_sizes(largest(Entry::rr), largest(Entry::phiphi), std::sqrt(panel.high), std::sqrt(panel.high));
    for (Eigen::Index e = 0; e < kEntries; ++e) {
      for (int j = 0; j <= order_; ++j) {
        for (int i = 0; i <= highest_power(e, j); ++i) {
          // The fit of the coefficients multiplies the round-off of the samples.
          const double noise = from_etas_.row(j).lpNorm<1>() * from_angles_.row(i).lpNorm<1>();
          const double limit = kSeriesTolerance * noise * sizes[static_cast<std::size_t>(e)];
          const double last = panel.series.row(row_of(e, j, i, order_)).tail<2>().cwiseAbs().maxCoeff();
          if (last * std::pow(panel.high, i) > limit) return false;
        }
      }
    }
    return true;
  }

 private:
  static Eigen::MatrixXd vandermonde(const Eigen::VectorXd& points) {
    Eigen::MatrixXd matrix(points.size(), points.size());
    for (Eigen::Index power = 0; power < points.size(); ++power) {
      matrix.col(power) = points.array().pow(static_cast<double>(power));
    }
    return matrix;
  }

  /// Coefficients from the entries at the grid points. At k = 0, where m = 0, only those of m^0 are set.
  /// @param[in] entries_at returns the entries at the indices of eta and t
  template <class EntriesAt>
  [[nodiscard]] Eigen::VectorXd fit(double k2, const EntriesAt& entries_at) const {
    std::array<Eigen::MatrixXd, kEntries> grid;
    grid.fill(Eigen::MatrixXd(etas_.size(), angles_.size()));
    for (Eigen::Index j = 0; j < etas_.size(); ++j) {
      for (Eigen::Index i = 0; i < angles_.size(); ++i) {
        const Entries entries = entries_at(j, i);
        for (std::size_t e = 0; e < kEntries; ++e) grid[e](j, i) = entries[e];
      }
    }
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(row_of(kEntries, 0, 0, order_));
    for (Eigen::Index e = 0; e < kEntries; ++e) {
      const Eigen::MatrixXd powers = from_etas_ * grid[static_cast<std::size_t>(e)] * from_angles_.transpose();
      for (int j = 0; j <= order_; ++j) {
        for (int i = 0; i <= (k2 > 0.0 ? highest_power(e, j) : 0); ++i) {
          coefficients[row_of(e, j, i, order_)] = powers(j, i) / std::pow(k2, i);
        }
      }
    }
    return coefficients;
  }

  /// Entries without inertia at t, from the compliance along and across k.
  static Entries rotated(const Matrix3<double>& y, double k2, double t) {
    const double along = y(1, 1);
    const double across = y(2, 2);
    const double mixed = y(0, 1) / std::sqrt(k2);
    return {
        y(0, 0), mixed, mixed, t * along + (1.0 - t) * across, (along - across) / k2, (1.0 - t) * along + t * across};
  }

  static Entries free_of_powers(const Matrix3<double>& y, double m, double n) {
    return {y(0, 0), y(0, 1) / m, y(0, 2) / n, y(1, 1), y(1, 2) / (m * n), y(2, 2)};
  }

  std::vector<LayerStack<double>> layers_;  // for each eta
  int order_;
  Eigen::VectorXd etas_;  // the first is 0
  Eigen::VectorXd angles_;
  Eigen::MatrixXd from_etas_;
  Eigen::MatrixXd from_angles_;
};

using Response = SelfSimilarSpectrum::Response;
using ResponseCache = RecentCache<Response>;

/// Responses of the bodies that were solved last, for further speeds, loads and meshes.
ResponseCache& recent_responses() {
  constexpr std::size_t kMaxNumbers = 2097152;  // 16 MB
  static ResponseCache cache(64, kMaxNumbers);
  return cache;
}

/// Values of the terms that were evaluated last, for further speeds and loads.
RecentCache<EntryTerms>& recent_terms() {
  constexpr std::size_t kMaxNumbers = 8388608;  // 64 MB
  static RecentCache<EntryTerms> cache(64, kMaxNumbers);
  return cache;
}

/// Compute the response of layers.
/// @param[in] layers layers in units of g, with the inertia of eta = 1
/// @param[in] unit unit of eta, at least the largest eta
/// @param[in] is_shared whether the unit also serves smaller eta of order (0, 0)
/// @param[in] bounds bounds of k^2 of the parts
Response make_response(const LayerStack<double>& layers, double unit, bool is_shared, double inertia_tolerance,
                       const std::vector<double>& bounds, int threads, Watch& watch) {
  Response response;
  const double growth = unit > 0.0 ? inertia_growth(layers, unit, is_shared) : 0.0;
  response.inertia_order = inertia_order(growth * unit, inertia_tolerance);
  if (!response.inertia_order) return response;
  const InertiaSeries inertia_series(layers, unit, *response.inertia_order);
  if (layers.metric.is_sphere()) {
    append_constants(kZeroOrder, inertia_series.sample_zero_order(), response.panels);
  }
  std::vector<std::vector<Panel<double>>> parts(bounds.size() - 1);
  parallel_for(parts.size(), threads, watch, "solving layers", [&](std::size_t p, const Worker& worker) {
    append_panels(
        bounds[p], bounds[p + 1],
        [&](const auto& nodes) {
          worker.checkpoint();
          return inertia_series.sample(nodes);
        },
        [&](const Panel<double>& panel) { return inertia_series.is_resolved(panel); }, parts[p]);
  });
  for (auto& part : parts) std::ranges::move(part, std::back_inserter(response.panels));
  return response;
}

/// Bounds of k^2 of parts that contain all orders. They hardly depend on the orders, so that meshes share responses.
std::vector<double> bounds_of_parts(bool is_sphere, double lowest, double highest) {
  constexpr double kPartRatio = 64.0;
  if (is_sphere && highest <= kLowOrders) return {kZeroOrder, kLowOrders};
  std::vector<double> bounds;
  if (is_sphere) bounds.push_back(kZeroOrder);
  const double part = std::floor(std::log(lowest / kLowOrders) / std::log(kPartRatio));
  bounds.push_back(is_sphere ? kLowOrders : kLowOrders * std::pow(kPartRatio, part));
  while (bounds.back() < highest) bounds.push_back(kPartRatio * bounds.back());
  return bounds;
}

bool has_factor_m(Entry entry) { return entry == Entry::rphi || entry == Entry::phitheta; }

using TermSeries = Eigen::Array<double, 1, kPanelNodes>;

/// Series of a term of an entry at an order m, with its factor m.
TermSeries series_of_term(const Panel<double>& panel, Entry entry, int term, double m, int inertia_order) {
  TermSeries series = TermSeries::Zero();
  const auto e = static_cast<Eigen::Index>(entry);
  double power = has_factor_m(entry) ? m : 1.0;
  for (int i = 0; i <= highest_power(e, term); ++i, power *= m * m) {
    series += power * panel.series.row(InertiaSeries::row_of(e, term, i, inertia_order)).array();
  }
  return series;
}

}  // namespace

std::unique_ptr<SelfSimilarSpectrum> SelfSimilarSpectrum::try_make(const HarmonicBody& body, double highest_n,
                                                                   double inertia_tolerance, int threads,
                                                                   Watch& watch) {
  if (body.metric().is_wheel()) return nullptr;  // not a function of m^2 + n^2
  const double density = std::ranges::max(body.body().layers, {}, &Layer::density).density;
  const std::size_t reference = softest_layer(body);
  const auto layers = layers_per_modulus(body, reference, density);
  if (!layers) return nullptr;

  std::unique_ptr<SelfSimilarSpectrum> spectrum(new SelfSimilarSpectrum);
  const double speed = body.angular_speed() * body.radius();
  double highest_eta = 0.0;
  for (std::size_t m = 0; m < body.orders().size(); ++m) {
    spectrum->per_modulus_.push_back(1.0 / body.modulus(reference, m));
    spectrum->inertia_.push_back(density * speed * speed * spectrum->per_modulus_.back());
    highest_eta = std::max(highest_eta, std::abs(spectrum->inertia_.back()));
  }
  const bool is_sphere = body.metric().is_sphere();
  if (highest_eta > 0.0 && !is_sphere) return nullptr;  // the growth of the terms is established for spheres only
  spectrum->orders_ = body.orders();
  spectrum->highest_n_ = highest_n;
  const auto [lowest_m, highest_m] = std::ranges::minmax(body.orders());
  const std::vector<double> bounds =
      bounds_of_parts(is_sphere, lowest_m * lowest_m, highest_m * highest_m + highest_n * highest_n);
  // Neighboring speeds share the unit of eta, unless the series needs the smallest one. A large tolerance omits terms
  // whose size depends on the unit; each speed then has its own.
  const double shared_unit = highest_eta > 0.0 ? std::exp2(2.0 * std::ceil(0.5 * std::log2(highest_eta))) : 0.0;
  for (const bool is_shared : {true, false}) {
    if (is_shared && inertia_tolerance > kInertiaTolerance) continue;
    const double unit = is_shared ? shared_unit : highest_eta;
    spectrum->properties_ = {unit > 0.0 ? std::log(unit) : 0.0, unit > 0.0 ? 1.0 : 0.0,  std::log(inertia_tolerance),
                             std::log(bounds.front()),          std::log(bounds.back()), is_shared ? 1.0 : 0.0};
    append_numbers(*layers, 1.0, spectrum->properties_);
    spectrum->response_ = recent_responses().find(spectrum->properties_);
    if (!spectrum->response_) {
      auto response = std::make_shared<const Response>(
          make_response(*layers, unit, is_shared, inertia_tolerance, bounds, threads, watch));
      std::size_t numbers = 0;
      for (const Panel<double>& panel : response->panels) numbers += static_cast<std::size_t>(panel.series.size());
      recent_responses().add(spectrum->properties_, response, numbers);
      spectrum->response_ = std::move(response);
    }
    if (!spectrum->response_->inertia_order) continue;
    for (cplx& eta : spectrum->inertia_) eta /= unit > 0.0 ? unit : 1.0;
    return spectrum;
  }
  return nullptr;
}

template <class Function>
void SelfSimilarSpectrum::for_panels(double m, const Function& function) const {
  for (const Panel<double>& panel : response_->panels) {
    if (panel.high >= m * m && panel.low <= m * m + highest_n_ * highest_n_) function(panel);
  }
}

void SelfSimilarSpectrum::series(std::size_t i, OrderSeries& series) const {
  const double m = orders_[i];
  const int inertia_order = *response_->inertia_order;
  std::size_t used = 0;
  for_panels(m, [&](const Panel<double>& panel) {
    if (used == series.size()) series.emplace_back();
    auto& target = series[used++];
    target.low = panel.low;
    target.high = panel.high;
    target.series.resize(kEntries, kPanelNodes);
    for (Eigen::Index e = 0; e < kEntries; ++e) {
      cplx eta_power = per_modulus_[i];
      TermSeries real = TermSeries::Zero();
      TermSeries imaginary = TermSeries::Zero();
      for (int j = 0; j <= inertia_order; ++j, eta_power *= inertia_[i]) {
        const TermSeries term = series_of_term(panel, static_cast<Entry>(e), j, m, inertia_order);
        real += eta_power.real() * term;
        imaginary += eta_power.imag() * term;
      }
      target.series.row(e).real() = real;
      target.series.row(e).imag() = imaginary;
    }
  });
  series.resize(used);
}

std::shared_ptr<const EntryTerms> SelfSimilarSpectrum::terms(Entry entry, const Eigen::ArrayXd& n, int threads,
                                                             Watch& watch) const {
  RecentCache<EntryTerms>::Key key = terms_key();
  key.push_back(static_cast<double>(entry));
  key.insert(key.end(), n.begin(), n.end());
  if (auto cached = recent_terms().find(key)) return cached;
  const int inertia_order = *response_->inertia_order;
  const auto rows = static_cast<Eigen::Index>(orders_.size());
  EntryTerms terms(static_cast<std::size_t>(inertia_order + 1), RowMajorMatrix(rows, n.size()));
  parallel_for(orders_.size(), threads, watch, "summing orders", [&](std::size_t i, const Worker&) {
    const double m = orders_[i];
    OrderSeries series;
    Eigen::ArrayXcd values;
    // The values are linear in the series, so that real and imaginary parts evaluate two terms at once.
    for (int j = 0; j <= inertia_order; j += 2) {
      const bool is_last = j == inertia_order;
      series.clear();
      for_panels(m, [&](const Panel<double>& panel) {
        series.push_back({.low = panel.low, .high = panel.high, .series = {}});
        series.back().series.setZero(kEntries, kPanelNodes);
        auto row = series.back().series.row(static_cast<int>(entry));
        row.real() = series_of_term(panel, entry, j, m, inertia_order);
        if (!is_last) row.imag() = series_of_term(panel, entry, j + 1, m, inertia_order);
      });
      OrderValues(m, n, series).evaluate(entry, values);
      values *= std::conj(phase_of(entry));
      const auto order = static_cast<Eigen::Index>(i);
      terms[static_cast<std::size_t>(j)].row(order) = values.real().matrix().transpose();
      if (!is_last) terms[static_cast<std::size_t>(j) + 1].row(order) = values.imag().matrix().transpose();
    }
  });
  auto shared = std::make_shared<const EntryTerms>(std::move(terms));
  recent_terms().add(std::move(key), shared, shared->size() * static_cast<std::size_t>(rows * n.size()));
  return shared;
}

std::vector<double> SelfSimilarSpectrum::terms_key() const {
  std::vector<double> key = properties_;
  key.push_back(static_cast<double>(orders_.size()));
  key.insert(key.end(), orders_.begin(), orders_.end());
  return key;
}

cplx SelfSimilarSpectrum::factor(Entry entry, std::size_t i, std::size_t term) const {
  cplx factor = phase_of(entry) * per_modulus_[i];
  for (std::size_t j = 0; j < term; ++j) factor *= inertia_[i];
  return factor;
}

}  // namespace viscoroll::detail

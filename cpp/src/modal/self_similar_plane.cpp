#include "modal/self_similar_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "modal/flat_layers.hpp"
#include "modal/medium.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;

/// Rows of a panel.
enum Row : Eigen::Index { kNormal, kMixed, kAlong, kAcross, kDifference, kRows };

/// Layers in units of the outermost one's modulus; nothing where they are not self-similar.
std::optional<std::vector<FlatMedium<double>>> scaled_media(const HarmonicPlane& plane) {
  std::vector<FlatMedium<double>> media;
  for (std::size_t l = 0; l < plane.layers().size(); ++l) {
    const Layer& layer = plane.layers()[l];
    if (layer.density != 0.0) return std::nullopt;
    if (!layer.poisson_ratio && !std::holds_alternative<Elastic>(layer.shear_modulus)) return std::nullopt;
    const cplx ratio = plane.modulus(l, 0) / plane.outer_modulus(0);
    for (std::size_t i = 0; i < plane.orders().size(); ++i) {
      const cplx expected = ratio * plane.outer_modulus(i);
      if (std::abs(plane.modulus(l, i) - expected) > 1e-14 * std::abs(expected)) return std::nullopt;
    }
    const double mu = plane.modulus(l, 0).real();
    media.push_back({.thickness = layer.thickness, .mu = ratio.real(), .b = shear_ratio(layer, mu), .inertia = 0.0});
  }
  return media;
}

bool is_resolved(const Panel<double>& panel) {
  const auto largest = [&](Row row) { return panel.series.row(row).cwiseAbs().maxCoeff(); };
  std::array<double, kRows> sizes{};
  sizes[kNormal] = largest(kNormal);
  sizes[kAlong] = largest(kAlong);
  sizes[kAcross] = largest(kAcross);
  // These two may be far smaller by cancellation.
  sizes[kMixed] = std::sqrt(sizes[kNormal] * sizes[kAlong] / panel.low);
  sizes[kDifference] = sizes[kAcross] / panel.low;
  for (Eigen::Index row = 0; row < kRows; ++row) {
    const double last = panel.series.row(row).tail<2>().cwiseAbs().maxCoeff();
    if (last > kSeriesTolerance * sizes[static_cast<std::size_t>(row)]) return false;
  }
  return true;
}

}  // namespace

std::unique_ptr<SelfSimilarPlane> SelfSimilarPlane::try_make(const HarmonicPlane& plane, double highest_n) {
  if (plane.orders().empty()) return nullptr;
  const auto media = scaled_media(plane);
  if (!media) return nullptr;
  std::unique_ptr<SelfSimilarPlane> spectrum(new SelfSimilarPlane());
  spectrum->orders_ = plane.orders();
  for (std::size_t i = 0; i < plane.orders().size(); ++i) spectrum->modulus_.push_back(plane.outer_modulus(i));
  const auto [lowest, highest] = std::ranges::minmax(plane.orders());
  const auto sample = [&](const std::array<double, kPanelNodes>& nodes) {
    Eigen::Matrix<double, kRows, kPanelNodes> values;
    for (Eigen::Index j = 0; j < kPanelNodes; ++j) {
      const double k2 = nodes[static_cast<std::size_t>(j)];
      const double k = std::sqrt(k2);
      const auto y = flat_compliance<double>(*media, k / plane.radius(), 1.0);
      values.col(j) << y.uu, y.uk / k, y.kk, y.pp, (y.kk - y.pp) / k2;
    }
    return values;
  };
  const double margin = 1.0 + 1e-12;  // for rounding in m^2 + n^2
  append_panels(lowest * lowest / margin, (highest * highest + highest_n * highest_n) * margin, sample, is_resolved,
                spectrum->panels_);
  return spectrum;
}

void SelfSimilarPlane::series(std::size_t i, OrderSeries& series) const {
  const double m = orders_[i];
  const cplx unit = 1.0 / modulus_[i];
  std::size_t used = 0;
  for (const Panel<double>& panel : panels_) {
    if (panel.high < m * m) continue;
    if (used == series.size()) series.emplace_back();
    auto& values = series[used++];
    values.low = panel.low;
    values.high = panel.high;
    values.series.resize(kEntries, kPanelNodes);
    const auto set = [&](Entry entry, const auto& row) {
      values.series.row(static_cast<int>(entry)) = unit * row.template cast<cplx>();
    };
    const auto& source = panel.series;
    set(Entry::rr, source.row(kNormal));
    set(Entry::rphi, m * source.row(kMixed));
    set(Entry::rtheta, source.row(kMixed));
    set(Entry::phiphi, source.row(kAcross) + m * m * source.row(kDifference));
    set(Entry::phitheta, m * source.row(kDifference));
    set(Entry::thetatheta, source.row(kAlong) - m * m * source.row(kDifference));
  }
  series.resize(used);
}

}  // namespace viscoroll::detail

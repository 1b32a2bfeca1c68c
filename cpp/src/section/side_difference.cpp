#include "section/side_difference.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/recent_cache.hpp"
#include "modal/layer_stack.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using cplx = std::complex<double>;

/// Ratio mu / (lambda + 2 mu) of incompressible layers in the elements. It changes compliances by 1e-6, multiplied by
/// the square of width over thickness. Elements with linear pressures do not lock.
constexpr double kMinShearRatio = 1e-6;

/// Phase by which the last sampled order changes along one element at the face [rad]. Its waves, 2 pi / 3.4 elements
/// long, are the shortest that the elements represent.
constexpr double kLastPhase = 3.4;

/// Largest ratio of successive sampled orders. In ln m, the sampled difference has poles at the distance pi/2 from the
/// real axis; steps of ln 1.3 = 0.26 are small compared with this distance.
constexpr double kMaxOrderRatio = 1.3;

/// Width of a flat tread, in thicknesses, above which its faces do not affect the middle. Their effect decays like
/// exp(-2.2 d/h) with the distance d from a face, to 2e-8 in the middle of this width.
constexpr double kWide = 16.0;

/// Least radius of the reference crown, in lengths of the half section that is straight along the path. The slopes of
/// the crown stay below the inverse of this number, so that its effect is linear in the curvature.
constexpr double kMinReferenceCrownRadius = 20.0;

/// Radius of a section that is straight along the path, in thicknesses. The relative effect of its curvature is the
/// inverse of this number.
constexpr double kStraightRadius = 1e4;

constexpr double kFlatCrownRadius = std::numeric_limits<double>::infinity();

CoatedWheel straight_across(CoatedWheel wheel) {
  wheel.crown_radius = kFlatCrownRadius;
  return wheel;
}

/// Wheel that is straight along the path, with layers that all follow a crown.
CoatedWheel straight_along(CoatedWheel wheel, double crown_radius) {
  wheel.core_radius = kStraightRadius * coating_thickness(wheel);
  wheel.crown_radius = crown_radius;
  wheel.hub = Hub::crowned;
  return wheel;
}

double length(const SectionMesh& mesh) { return mesh.z()[mesh.z().size() - 1]; }

/// Wheel whose width is reduced, if it is flat, to the part that its faces affect.
CoatedWheel affected_part(CoatedWheel wheel) {
  if (std::isinf(wheel.crown_radius)) wheel.width = std::min(wheel.width, kWide * coating_thickness(wheel));
  return wheel;
}

/// Materials with real moduli, if all moduli are real.
std::optional<std::vector<SectionMedium<double>>> real_media(const std::vector<SectionMedium<cplx>>& layers) {
  std::vector<SectionMedium<double>> real;
  constexpr double kRoundOff = 1e-13;
  for (const auto& [shear, lame] : layers) {
    if (std::abs(shear.imag()) > kRoundOff * shear.real() || std::abs(lame.imag()) > kRoundOff * std::abs(lame)) {
      return std::nullopt;
    }
    real.push_back({.shear = shear.real(), .lame = lame.real()});
  }
  return real;
}

/// Largest number of cached treads. A study that alternates among a few treads then finds all of them in the cache. A
/// tread takes a few megabytes, or about ten times as much if its layers have different relaxation functions.
constexpr std::size_t kMaxTreads = 8;
constexpr std::size_t kMaxCacheSize = 16777216;  // largest number of complex numbers in the cache, 256 MB

using Treads = RecentCache<std::vector<SampledDifference>>;
using Key = Treads::Key;

Key key_of(const CoatedWheel& wheel, bool tangential, const std::vector<double>& key_numbers) {
  Key key{tangential ? 1.0 : 0.0, wheel.core_radius, wheel.width, wheel.crown_radius,
          wheel.hub == Hub::crowned ? 1.0 : 0.0};
  for (const Layer& layer : wheel.layers) key.push_back(layer.thickness);
  key.insert(key.end(), key_numbers.begin(), key_numbers.end());
  return key;
}

/// Number of complex numbers in differences.
std::size_t size_of(const std::vector<SampledDifference>& differences) {
  Eigen::Index sum = 0;
  for (const SampledDifference& one : differences) {
    for (const Eigen::MatrixXcd& part : one.parts) sum += part.size();
  }
  return static_cast<std::size_t>(sum);
}

Treads& treads() {
  static Treads store(kMaxTreads, kMaxCacheSize);
  return store;
}

}  // namespace

ArrayXd sampled_orders(const CoatedWheel& wheel, const SectionFineness& fineness) {
  const double element = fineness.finest * std::min(coating_thickness(wheel), wheel.width);
  const double last = std::log(std::max(kLastPhase * outer_radius(wheel) / element, 2.0));
  const auto steps = static_cast<Index>(std::max(3.0, std::ceil(last / std::log(kMaxOrderRatio))));
  ArrayXd orders(steps + 2);
  orders << 0.0, ArrayXd::LinSpaced(steps + 1, 0.0, last).exp();
  return orders;
}

/// The stored matrix is for u_phi = i V and its load, in place of V and its load: the rows of phi are multiplied by i
/// and the columns by -i.
void SampledDifference::set(Parity part, Index order, Eigen::MatrixXcd matrix) {
  const Index lines = z.size();
  if (components > 1) {
    matrix.middleRows(lines, lines) *= cplx(0.0, 1.0);
    matrix.middleCols(lines, lines) *= cplx(0.0, -1.0);
  }
  parts[part].row(order) = matrix.reshaped().transpose();
}

template <class Scalar>
std::vector<SectionMedium<cplx>> section_media(const LayerStack<Scalar>& layers, const Scalar& unit) {
  std::vector<SectionMedium<cplx>> media;
  for (const Medium<Scalar>& medium : layers.media) {
    const cplx shear = medium.mu / unit;
    const cplx ratio = std::abs(medium.b) < kMinShearRatio ? kMinShearRatio : medium.b;
    media.push_back({.shear = shear, .lame = shear * (1.0 / ratio - 2.0)});
  }
  return media;
}

template std::vector<SectionMedium<cplx>> section_media(const LayerStack<double>&, const double&);
template std::vector<SectionMedium<cplx>> section_media(const LayerStack<cplx>&, const cplx&);

std::vector<SectionMedium<cplx>> section_media(const HarmonicBody& body, std::size_t order) {
  return section_media(body.layers_at(order), body.outer_modulus(order));
}

SectionCrown::SectionCrown(const CoatedWheel& wheel, bool tangential, const SectionFineness& fineness)
    : straight_(SectionMesh(straight_along(wheel, kFlatCrownRadius), SectionEnd::unbounded, fineness), tangential),
      crown_radius_(std::max(wheel.crown_radius, kMinReferenceCrownRadius * length(straight_.mesh()))),
      crowned_(SectionMesh(straight_along(wheel, crown_radius_), SectionEnd::unbounded, fineness), tangential),
      curvature_ratio_(crown_radius_ / wheel.crown_radius),
      radius_ratio_(outer_radius(straight_along(wheel, kFlatCrownRadius)) / outer_radius(wheel)) {}

template <class Scalar>
std::array<SectionCompliance::Matrix<Scalar>, 2> SectionCrown::at(double m,
                                                                  const std::vector<SectionMedium<Scalar>>& layers,
                                                                  std::span<const Parity> parts) const {
  auto change = crowned_.at(radius_ratio_ * m, layers, parts);
  const auto straight = straight_.at(radius_ratio_ * m, layers, parts);
  // A radian is longer than that of the wheel by the ratio of the radii. A load per radian is therefore distributed
  // over a longer arc, so displacements are multiplied by this ratio.
  for (const Parity part : parts) {
    change[part] = curvature_ratio_ * radius_ratio_ * (change[part] - straight[part]);
  }
  return change;
}

SideDifference::SideDifference(const CoatedWheel& wheel, bool tangential, const SectionFineness& fineness)
    : omitted_(0.5 * (wheel.width - affected_part(wheel).width)),
      face_(SectionMesh(affected_part(wheel), SectionEnd::face, fineness), tangential),
      unbounded_(SectionMesh(straight_across(affected_part(wheel)), SectionEnd::unbounded, fineness), tangential),
      tangential_(tangential) {
  if (std::isfinite(wheel.crown_radius)) crown_.emplace(wheel, tangential, fineness);
}

SampledDifference SideDifference::allocated(const ArrayXd& orders) const {
  SampledDifference result{.orders = orders,
                           .z = omitted_ + face_.mesh().z().head(static_cast<Index>(face_.mesh().loaded_lines())),
                           .components = tangential_ ? 3 : 1,
                           .parts = {}};
  const Index entries = result.amplitudes() * result.amplitudes();
  for (Eigen::MatrixXcd& part : result.parts) part.resize(orders.size(), entries);
  return result;
}

/// `SectionCompliance` is for a unit force on half of the section. The result is half of the difference, because the
/// unit force of `SampledDifference` acts half on a line and half on its mirror image.
std::array<Eigen::MatrixXcd, 2> SideDifference::at(double m, const std::vector<SectionMedium<cplx>>& layers,
                                                   std::span<const Parity> parts, const Worker& worker) const {
  const auto solved = [&](const auto& media) {
    const auto face = face_.at(m, media, parts);
    worker.checkpoint();
    auto unbounded = unbounded_.at(m, media, parts);
    if (crown_) {
      const auto crown = crown_->at(m, media, parts);
      for (const Parity part : parts) unbounded[part] += crown[part];
    }
    worker.checkpoint();
    std::array<Eigen::MatrixXcd, 2> difference;
    for (const Parity part : parts) {
      difference[part] = (0.5 * (face[part] - unbounded[part])).template cast<cplx>();
    }
    return difference;
  };
  const auto real = real_media(layers);
  return real ? solved(*real) : solved(layers);
}

SampledDifference SideDifference::sampled(const HarmonicBody& body, int threads, Watch& watch) const {
  const std::vector<double>& orders = body.orders();
  SampledDifference result = allocated(Eigen::Map<const ArrayXd>(orders.data(), static_cast<Index>(orders.size())));
  parallel_for(orders.size(), threads, watch, "solving the section", [&](std::size_t order, const Worker& worker) {
    const auto difference = at(orders[order], section_media(body, order), kBothParts, worker);
    for (const Parity part : kBothParts) result.set(part, static_cast<Index>(order), difference[part]);
  });
  return result;
}

std::shared_ptr<const std::vector<SampledDifference>> cached_differences(
    const CoatedWheel& wheel, bool tangential, const std::vector<double>& key_numbers,
    const std::function<std::vector<SampledDifference>()>& compute) {
  Key key = key_of(wheel, tangential, key_numbers);
  if (auto cached = treads().find(key)) return cached;
  // The computation does not hold the lock, so that other threads can use the cache meanwhile.
  auto differences = std::make_shared<const std::vector<SampledDifference>>(compute());
  treads().add(std::move(key), differences, size_of(*differences));
  return differences;
}

std::shared_ptr<const SampledDifference> cached_difference(const CoatedWheel& wheel, const HarmonicBody& body,
                                                           bool tangential, int threads, Watch& watch) {
  std::vector<double> moduli;
  for (std::size_t order = 0; order < body.orders().size(); ++order) {
    for (const auto& [shear, lame] : section_media(body, order)) {
      moduli.insert(moduli.end(), {shear.real(), shear.imag(), lame.real(), lame.imag()});
    }
  }
  const auto differences = cached_differences(wheel, tangential, moduli, [&] {
    return std::vector{SideDifference(wheel, tangential).sampled(body, threads, watch)};
  });
  return {differences, &differences->front()};
}

}  // namespace viscoroll::detail

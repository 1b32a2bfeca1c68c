#include "section/side_difference.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "modal/medium.hpp"

namespace viscoroll::detail {
namespace {

using cplx = std::complex<double>;
using Eigen::ArrayXd;
using Eigen::Index;

/// In place of none: so little changes compliances by 1e-6 of the square of width over thickness, and elements with
/// linear pressures do not lock.
constexpr double kLeastShearRatio = 1e-6;

/// Shortest waves that the elements at the face carry, 2 pi / 3.4 of them long, are the last that are asked for.
constexpr double kLastPhase = 3.4;

/// From order to order: the difference follows ln m like a rational function, whose poles lie pi/2 off the real axis.
constexpr double kLargestRatio = 1.3;

/// Width in thicknesses from which on the middle of a flat tread does not feel its faces: what they change falls like
/// e^(-2.2 e/h) with the distance e, to 2e-8 here.
constexpr double kWide = 16.0;

/// A flat tread of no more of the width than its faces change.
CoatedWheel felt_part(CoatedWheel wheel) {
  if (std::isinf(wheel.crown_radius)) wheel.width = std::min(wheel.width, kWide * coating_thickness(wheel));
  return wheel;
}

/// The layers, where none of them is complex.
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

/// Half of the difference, since forces on lines and on their mirror images are counted together, with the factors of
/// u_phi = i V.
template <class Scalar>
Eigen::MatrixXcd physical(const SectionCompliance::Matrix<Scalar>& face,
                          const SectionCompliance::Matrix<Scalar>& endless, Index lines) {
  Eigen::MatrixXcd difference = (0.5 * (face - endless)).template cast<cplx>();
  if (difference.rows() == lines) return difference;
  difference.middleRows(lines, lines) *= cplx(0.0, 1.0);
  difference.middleCols(lines, lines) *= cplx(0.0, -1.0);
  return difference;
}

}  // namespace

ArrayXd sampled_orders(const CoatedWheel& wheel, const SectionFineness& fineness) {
  const double element = fineness.finest * std::min(coating_thickness(wheel), wheel.width);
  const double last = std::log(std::max(kLastPhase * outer_radius(wheel) / element, 2.0));
  const auto steps = static_cast<Index>(std::max(3.0, std::ceil(last / std::log(kLargestRatio))));
  ArrayXd orders(steps + 2);
  orders << 0.0, ArrayXd::LinSpaced(steps + 1, 0.0, last).exp();
  return orders;
}

std::vector<SectionMedium<cplx>> section_media(const HarmonicBody& body, std::size_t order) {
  std::vector<SectionMedium<cplx>> layers;
  for (const Medium<cplx>& medium : body.layers_at(order).media) {
    const cplx shear = medium.mu / body.outer_modulus(order);
    const cplx ratio = std::abs(medium.b) < kLeastShearRatio ? kLeastShearRatio : medium.b;
    layers.push_back({.shear = shear, .lame = shear * (1.0 / ratio - 2.0)});
  }
  return layers;
}

SideDifference::SideDifference(const CoatedWheel& wheel, bool tangential, const SectionFineness& fineness)
    : left_out_(0.5 * (wheel.width - felt_part(wheel).width)),
      face_(SectionMesh(felt_part(wheel), SectionEnd::face, fineness), tangential),
      endless_(SectionMesh(felt_part(wheel), SectionEnd::endless, fineness), tangential),
      tangential_(tangential) {}

SampledDifference SideDifference::sampled(const HarmonicBody& body, int threads, Watch& watch) const {
  const auto lines = static_cast<Index>(face_.mesh().loaded_lines());
  const std::vector<double>& orders = body.orders();
  SampledDifference result{.orders = Eigen::Map<const ArrayXd>(orders.data(), static_cast<Index>(orders.size())),
                           .z = left_out_ + face_.mesh().z().head(lines),
                           .components = tangential_ ? 3 : 1,
                           .parts = {}};
  const Index entries = result.amplitudes() * result.amplitudes();
  for (Eigen::MatrixXcd& part : result.parts) part.resize(result.orders.size(), entries);
  parallel_for(orders.size(), threads, watch, "solving the section", [&](std::size_t order, const Worker& worker) {
    const auto row = static_cast<Index>(order);
    const auto store = [&](const auto& layers) {
      const auto face = face_.at(orders[order], layers);
      worker.checkpoint();
      const auto endless = endless_.at(orders[order], layers);
      for (std::size_t part = 0; part < 2; ++part) {
        result.parts[part].row(row) = physical(face[part], endless[part], lines).reshaped().transpose();
      }
      worker.checkpoint();
    };
    const auto layers = section_media(body, order);
    if (const auto real = real_media(layers)) {
      store(*real);
    } else {
      store(layers);
    }
  });
  return result;
}

}  // namespace viscoroll::detail

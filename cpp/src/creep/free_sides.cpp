#include "creep/free_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/dense_products.hpp"
#include "influence/side_influence.hpp"
#include "section/side_difference.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using WeighedContour = LayerSpectrum::WeighedContour;
using cplx = std::complex<double>;

/// -ln of the error of the sums. They leave 3e-5 of the difference at any frequency; the elements leave a thousandth.
constexpr double kLeft = 14.0;

/// Layers in a unit of stress in which the real part of every modulus is positive. At a point off the axis of real
/// times, all moduli lie on one side of that axis, within half a turn.
struct UprightMedia {
  cplx unit;  // [Pa]
  std::vector<SectionMedium<cplx>> layers;
};

template <class Scalar>
UprightMedia upright(const LayerStack<Scalar>& layers) {
  const double size = std::abs(layers.media.back().mu);
  double least = std::numbers::pi;
  double most = -std::numbers::pi;
  std::vector<SectionMedium<cplx>> media = section_media(layers, Scalar(size));
  for (const auto& [shear, lame] : media) {
    for (const cplx& modulus : {shear, lame + 2.0 / 3.0 * shear}) {
      least = std::min(least, std::arg(modulus));
      most = std::max(most, std::arg(modulus));
    }
  }
  const cplx turn = std::polar(1.0, 0.5 * (least + most));
  for (auto& [shear, lame] : media) {
    shear /= turn;
    lame /= turn;
  }
  return {.unit = size * turn, .layers = std::move(media)};
}

/// All quantities, besides the dimensions, on which the weights depend.
std::vector<double> numbers_of(const LayerSpectrum& layers, const WeighedContour& contour) {
  std::vector<double> numbers;
  const auto put = [&](const UprightMedia& media) {
    numbers.insert(numbers.end(), {media.unit.real(), media.unit.imag()});
    for (const auto& [shear, lame] : media.layers) {
      numbers.insert(numbers.end(), {shear.real(), shear.imag(), lame.real(), lame.imag()});
    }
  };
  put(upright(layers.layers_at_once()));
  for (const cplx& time : contour.times) put(upright(layers.layers_at(time)));
  for (const cplx& sum : contour.sums.reshaped()) numbers.insert(numbers.end(), {sum.real(), sum.imag()});
  return numbers;
}

std::vector<SampledDifference> found(const LayerSpectrum& layers, const WeighedContour& contour,
                                     const SideDifference& sections, const Eigen::ArrayXd& orders, int threads,
                                     Watch& watch) {
  constexpr std::array kEven{kEvenPart};
  SampledDifference room = sections.allocated(orders);
  room.parts[kOddPart].resize(0, 0);
  std::vector<SampledDifference> weights(layers.weights(), room);
  parallel_for(static_cast<std::size_t>(orders.size()), threads, watch, "solving the section",
               [&](std::size_t number, const Worker& worker) {
                 const auto order = static_cast<Index>(number);
                 const auto difference = [&](const auto& stack) -> Eigen::MatrixXcd {
                   const UprightMedia media = upright(stack);
                   return sections.at(orders[order], media.layers, kEven, worker)[kEvenPart] / media.unit;
                 };
                 const Eigen::MatrixXcd at_once = difference(layers.layers_at_once());
                 weights.front().set(kEvenPart, order, at_once);
                 std::vector<Eigen::MatrixXcd> sums(layers.weights() - 1,
                                                    Eigen::MatrixXcd::Zero(at_once.rows(), at_once.cols()));
                 for (std::size_t q = 0; q < contour.times.size(); ++q) {
                   const Eigen::MatrixXcd there = difference(layers.layers_at(contour.times[q]));
                   for (std::size_t j = 0; j < sums.size(); ++j) {
                     sums[j].real() += (contour.sums(static_cast<Index>(j), static_cast<Index>(q)) * there).real();
                   }
                 }
                 for (std::size_t j = 0; j < sums.size(); ++j) weights[j + 1].set(kEvenPart, order, sums[j]);
               });
  return weights;
}

}  // namespace

std::shared_ptr<const std::vector<SampledDifference>> side_weights(const LayerSpectrum& layers,
                                                                   const CoatedWheel& tread, bool tangential,
                                                                   int threads, Watch& watch) {
  const WeighedContour contour = layers.contour(kLeft);
  return cached_differences(tread, tangential, numbers_of(layers, contour), [&] {
    return found(layers, contour, SideDifference(tread, tangential), sampled_orders(tread), threads, watch);
  });
}

SideSum sum_of_side_weights(const std::shared_ptr<const std::vector<SampledDifference>>& weights,
                            const LayerSpectrum& layers, const MeshOnBody& mesh) {
  constexpr double kAnySpeed = 1.0;  // without inertia it has no effect
  std::vector<OrderBand> bands = phi_bands(layers.body_at_rest(), kAnySpeed, mesh.rounded());
  const auto count = static_cast<Index>(all_orders(bands).size());
  const std::shared_ptr<const SampledDifference> first{weights, &weights->front()};
  return {first, std::move(bands), Eigen::VectorXcd::Ones(count), mesh};  // already per Pa
}

HalfField side_influence(const SampledDifference& difference, const SideFactors& factors, const RowShape& shape,
                         double column_distance) {
  const TreadColumns columns{.first = 0, .spacing = column_distance};
  const Index lines = difference.z.size();
  const Index height = shape.components * shape.half_nodes;
  const Eigen::VectorXd weights = half_weights(shape.half_nodes);
  MatrixXd gathered = MatrixXd::Zero(difference.amplitudes(), height);
  MatrixXd read = gathered;
  for (Index p = 0; p < shape.components; ++p) {
    const auto of_component = [&](MatrixXd& shares) {
      return shares.block(p * lines, p * shape.half_nodes, lines, shape.half_nodes);
    };
    const bool odd = p == 2;
    of_component(gathered) = patch_mean_weights(difference.z, columns, shape.half_nodes, odd) * weights.asDiagonal();
    of_component(read) = node_weights(difference.z, columns, shape.half_nodes, odd) * weights.asDiagonal();
  }
  const Index offsets = factors.phi_reach + 1;
  const Eigen::MatrixXcd ahead = factors.values.bottomRows(offsets);
  const Eigen::MatrixXcd& samples = difference.parts[kEvenPart];
  const MatrixXd tables = product(MatrixXd(ahead.real()), MatrixXd(samples.real())) -
                          product(MatrixXd(ahead.imag()), MatrixXd(samples.imag()));
  HalfField influence(offsets * height, height);
  for (Index j = 0; j < offsets; ++j) {
    const MatrixXd of_lines = tables.row(j).reshaped(difference.amplitudes(), difference.amplitudes());
    influence.middleRows(j * height, height) = 0.5 * (product(read.transpose(), product(of_lines, gathered)) +
                                                      product(gathered.transpose(), product(of_lines, read)));
  }
  return influence;
}

}  // namespace viscoroll::detail

#include "influence/side_influence.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "base/dense_products.hpp"
#include "base/dense_solvers.hpp"
#include "influence/legendre.hpp"
#include "influence/table.hpp"
#include "influence/waves.hpp"
#include "section/section_compliance.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using cplx = std::complex<double>;

/// Second derivatives, at equidistant knots, of the cubic splines that are 1 at one knot and 0 at the others: [knot,
/// knot of the 1]. At the second knot the spline satisfies the not-a-knot condition. At the last knot its slope is that
/// of a function that decreases like 1/m from there on, because octaves are smooth.
MatrixXd spline_second_derivatives(Index knots, double distance) {
  MatrixXd smooth = MatrixXd::Zero(knots, knots);
  MatrixXd second_derivatives = MatrixXd::Zero(knots, knots);
  for (Index i = 1; i + 1 < knots; ++i) {
    smooth.row(i).segment(i - 1, 3) << 1.0, 4.0, 1.0;
    second_derivatives.row(i).segment(i - 1, 3) << 6.0, -12.0, 6.0;
  }
  smooth.row(0).head(3) << 1.0, -2.0, 1.0;
  smooth.row(knots - 1).tail(2) << 1.0, 2.0;
  second_derivatives.row(knots - 1).tail(2) << 6.0, -6.0 * (1.0 + distance);
  return dense_inverse(smooth) * second_derivatives / (distance * distance);
}

/// Add the weights of the lines in the value at position z. Each element of the section lies between every other line.
/// Positions nearer to the middle than the first line have zero weights, because the faces have no effect there.
void add_shares(const ArrayXd& lines, double z, double weight, Eigen::Ref<Eigen::VectorXd> shares) {
  const double place = std::min(std::abs(z), lines[lines.size() - 1]);
  if (place < lines[0]) return;
  Index first = 0;
  while (first + 4 < lines.size() && place > lines[first + 2]) first += 2;
  const auto values = quadratic_shares((place - lines[first + 1]) / (0.5 * (lines[first + 2] - lines[first])));
  for (std::size_t n = 0; n < 3; ++n) shares[first + static_cast<Index>(n)] += weight * values[n];
}

/// Positions between which the weights are polynomials, on both sides of the middle.
std::vector<double> pieces(const ArrayXd& lines, double from, double to) {
  std::vector<double> places{from, to};
  for (Index i = 0; i < lines.size(); i += 2) {
    for (const double z : {lines[i], -lines[i]}) {
      if (z > from && z < to) places.push_back(z);
    }
  }
  std::ranges::sort(places);
  return places;
}

/// +1, or -1 on the other side of the middle if odd.
double side(double z, bool odd) { return odd && z < 0.0 ? -1.0 : 1.0; }

/// Transforms of real lines, which are the columns: [frequency, column].
Eigen::MatrixXcd transformed(const RealFft& fft, int period, int reach, const Eigen::Ref<const MatrixXd>& columns) {
  RealBuffer line(static_cast<std::size_t>(period));
  ComplexBuffer half(static_cast<std::size_t>(period / 2 + 1));
  Eigen::MatrixXcd result(static_cast<Index>(half.size()), columns.cols());
  for (Index i = 0; i < columns.cols(); ++i) {
    std::ranges::fill(line, 0.0);
    for (int j = -reach; j <= reach; ++j) {
      line[static_cast<std::size_t>((j + period) % period)] = columns(j + reach, i) / period;
    }
    fft.forward(line.data(), half.data());
    result.col(i) = Eigen::Map<const Eigen::VectorXcd>(half.data(), result.rows());
  }
  return result;
}

}  // namespace

SideFactors widened(const SideFactors& fine, int stride, double downstream) {
  const std::array<double, 4> shares = wide_patch_shares(downstream);
  const int last = downstream > 0.0 ? 2 : 1;
  const int reach = (fine.phi_reach - last) / stride;
  SideFactors coarse{.phi_reach = reach, .values = Eigen::MatrixXcd::Zero(2 * reach + 1, fine.values.cols())};
  for (int j = -reach; j <= reach; ++j) {
    for (int offset = -1; offset <= last; ++offset) {
      coarse.values.row(j + reach) +=
          shares[static_cast<std::size_t>(offset + 1)] * fine.values.row(stride * j + offset + fine.phi_reach);
    }
  }
  return coarse;
}

MatrixXd shares_of_samples(const Eigen::ArrayXd& sampled, const Eigen::ArrayXd& orders) {
  const Index knots = sampled.size() - 1;
  const double last = std::log(sampled[knots]);
  const double distance = last / static_cast<double>(knots - 1);
  const MatrixXd second_derivatives = spline_second_derivatives(knots, distance);
  MatrixXd shares = MatrixXd::Zero(orders.size(), sampled.size());
  for (Index row = 0; row < orders.size(); ++row) {
    if (orders[row] == 0.0) {
      shares(row, 0) = 1.0;
      continue;
    }
    const double place = std::clamp(std::log(orders[row]), 0.0, last);
    const Index knot = std::min(static_cast<Index>(place / distance), knots - 2);
    const double right = place / distance - static_cast<double>(knot);
    const double left = 1.0 - right;
    auto share = shares.row(row).tail(knots);
    share = distance * distance / 6.0 *
            ((left * left - 1.0) * left * second_derivatives.row(knot) +
             (right * right - 1.0) * right * second_derivatives.row(knot + 1));
    share[knot] += left;
    share[knot + 1] += right;
    share *= std::min(1.0, sampled[knots] / orders[row]);
  }
  return shares;
}

Eigen::VectorXcd inverse_outer_modulus(const HarmonicBody& body) {
  Eigen::VectorXcd inverse_modulus(static_cast<Index>(body.orders().size()));
  for (Index i = 0; i < inverse_modulus.size(); ++i)
    inverse_modulus[i] = 1.0 / body.outer_modulus(static_cast<std::size_t>(i));
  return inverse_modulus;
}

SideSum::SideSum(std::shared_ptr<const SampledDifference> difference, std::vector<OrderBand> bands,
                 const Eigen::VectorXcd& inverse_modulus, const MeshOnBody& mesh)
    : difference_(std::move(difference)), bands_(std::move(bands)), mesh_(mesh) {
  Index first = 0;
  for (const OrderBand& band : bands_) {
    const Eigen::VectorXcd factors =
        inverse_modulus.segment(first, band.orders.size()).array() * (band.weights / (2.0 * std::numbers::pi));
    shares_.emplace_back(factors.asDiagonal() * shares_of_samples(difference_->orders, band.orders).cast<cplx>());
    first += band.orders.size();
  }
}

SideFactors SideSum::factors(const SideRequest& request) const {
  const int reach = request.phi_reach;
  const Index samples = difference_->orders.size();
  SideFactors factors{.phi_reach = reach, .values = Eigen::MatrixXcd::Zero(2 * reach + 1, samples)};
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const OrderBand& band = bands_[b];
    const int band_reach = std::min(reach, band.reach);
    Eigen::VectorXcd received(band.orders.size());
    for (Index i = 0; i < received.size(); ++i) {
      const double m = band.orders[i];
      const double patch = sinc(0.5 * m * mesh_.phi_spacing());
      received[i] = patch * (request.power ? cplx(0.0, mesh_.turns() * m * patch)
                                           : std::polar(1.0, m * mesh_.phi_spacing() * request.phi_shift));
    }
    const Eigen::MatrixXcd summand = received.asDiagonal() * shares_[b];
    const Waves waves = make_waves(band.orders, mesh_.phi_spacing(), band_reach);
    const Eigen::MatrixXcd even = waves.cosines.transpose().cast<cplx>() * summand;
    const Eigen::MatrixXcd odd = waves.sines.transpose().cast<cplx>() * (cplx(0.0, 1.0) * summand);
    factors.values.middleRows(reach, band_reach + 1) += even + odd;
    if (band_reach == 0) continue;
    factors.values.middleRows(reach - band_reach, band_reach) +=
        (even - odd).bottomRows(band_reach).colwise().reverse();
  }
  return factors;
}

MatrixXd patch_mean_weights(const ArrayXd& lines, const TreadColumns& columns, Index count, bool odd) {
  MatrixXd shares = MatrixXd::Zero(lines.size(), count);
  const auto [abscissas, weights] = gauss_legendre(2);  // exact for polynomials of third degree
  const double face = lines[lines.size() - 1];
  for (Index k = 0; k < count; ++k) {
    const double middle = columns.spacing * static_cast<double>(columns.first + k);
    const double from = std::max(middle - 0.5 * columns.spacing, -face);
    const double to = std::min(middle + 0.5 * columns.spacing, face);
    if (!(from < to)) continue;  // beyond a face, where there is no pressure
    const std::vector<double> places = pieces(lines, from, to);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const double length = places[i + 1] - places[i];
      for (Index point = 0; point < abscissas.size(); ++point) {
        const double z = places[i] + 0.5 * length * (1.0 + abscissas[point]);
        add_shares(lines, z, side(z, odd) * 0.5 * weights[point] * length / (to - from), shares.col(k));
      }
    }
  }
  return shares;
}

MatrixXd node_weights(const ArrayXd& lines, const TreadColumns& columns, Index count, bool odd) {
  MatrixXd shares = MatrixXd::Zero(lines.size(), count);
  for (Index k = 0; k < count; ++k) {
    const double z = columns.spacing * static_cast<double>(columns.first + k);
    if (odd && z == 0.0) continue;
    add_shares(lines, z, side(z, odd), shares.col(k));
  }
  return shares;
}

SideProduct::SideProduct(WindowShape shape, const TreadColumns& columns, const SampledDifference& difference,
                         const SideFactors& factors, bool average)
    : shape_(shape),
      components_(difference.components),
      lines_(difference.z.size()),
      period_(RealFft::fast_length(2 * shape.phi_nodes - 1)),
      fft_(period_) {
  const int reach = shape.phi_nodes - 1;
  const Eigen::MatrixXcd offsets = factors.values.middleRows(factors.phi_reach - reach, 2 * reach + 1);
  const Eigen::MatrixXcd real = transformed(fft_, period_, reach, offsets.real());
  const Eigen::MatrixXcd imaginary = transformed(fft_, period_, reach, offsets.imag());
  const Index amplitudes = difference.amplitudes();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    Part& part = parts_[p];
    for (Index component = 0; component < components_; ++component) {
      const bool odd = (component == 2) == (p == kEvenPart);
      part.gathered.push_back(patch_mean_weights(difference.z, columns, shape.theta_nodes, odd));
      part.read.push_back(average ? part.gathered.back() : node_weights(difference.z, columns, shape.theta_nodes, odd));
    }
    // Re(factors samples) is the sum of two products, each of which is real before the transform.
    const MatrixXd samples_real = difference.parts[p].real();
    const MatrixXd samples_imaginary = difference.parts[p].imag();
    const MatrixXd spectrum_real =
        product(MatrixXd(real.real()), samples_real) - product(MatrixXd(imaginary.real()), samples_imaginary);
    const MatrixXd spectrum_imaginary =
        product(MatrixXd(real.imag()), samples_real) - product(MatrixXd(imaginary.imag()), samples_imaginary);
    for (Index f = 0; f < real.rows(); ++f) {
      Eigen::MatrixXcd& matrix = part.spectrum.emplace_back(amplitudes, amplitudes);
      matrix.real() = spectrum_real.row(f).reshaped(amplitudes, amplitudes);
      matrix.imag() = spectrum_imaginary.row(f).reshaped(amplitudes, amplitudes);
    }
  }
}

Eigen::ArrayXXd SideProduct::apply(const Eigen::ArrayXXd& loads) const {
  const auto count = static_cast<Index>(parts_[0].spectrum.size());
  RealBuffer line(static_cast<std::size_t>(period_));
  ComplexBuffer half(static_cast<std::size_t>(count));
  const Eigen::Map<Eigen::RowVectorXd> nodes(line.data(), shape_.phi_nodes);
  Eigen::ArrayXXd result = Eigen::ArrayXXd::Zero(loads.rows(), components_);
  for (const Part& part : parts_) {
    Eigen::MatrixXcd amplitudes(components_ * lines_, count);
    for (Index component = 0; component < components_; ++component) {
      const Eigen::Map<const MatrixXd> load(loads.col(component).data(), shape_.theta_nodes, shape_.phi_nodes);
      const MatrixXd gathered = part.gathered[static_cast<std::size_t>(component)] * load;
      for (Index i = 0; i < lines_; ++i) {
        std::ranges::fill(line, 0.0);
        Eigen::Map<Eigen::RowVectorXd>(line.data(), shape_.phi_nodes) = gathered.row(i);
        fft_.forward(line.data(), half.data());
        amplitudes.row(component * lines_ + i) = Eigen::Map<const Eigen::RowVectorXcd>(half.data(), count);
      }
    }
    for (Index f = 0; f < count; ++f) {
      amplitudes.col(f) = multiplied(part.spectrum[static_cast<std::size_t>(f)], amplitudes.col(f));
    }
    for (Index component = 0; component < components_; ++component) {
      MatrixXd moved(lines_, shape_.phi_nodes);
      for (Index i = 0; i < lines_; ++i) {
        Eigen::Map<Eigen::RowVectorXcd>(half.data(), count) = amplitudes.row(component * lines_ + i);
        fft_.backward(half.data(), line.data());
        moved.row(i) = nodes;
      }
      Eigen::Map<MatrixXd>(result.col(component).data(), shape_.theta_nodes, shape_.phi_nodes) +=
          part.read[static_cast<std::size_t>(component)].transpose() * moved;
    }
  }
  return result;
}

double SideProduct::operations() const {
  const auto lines = static_cast<double>(components_ * lines_);
  const auto frequencies = static_cast<double>(parts_[0].spectrum.size());
  return 2.0 * lines * (8.0 * frequencies * lines + 4.0 * static_cast<double>(shape_.size()));
}

}  // namespace viscoroll::detail

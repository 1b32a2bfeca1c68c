#include "influence/sphere_product.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "base/dense_products.hpp"

namespace viscoroll::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Operations below which threads cost more than they save.
constexpr double kWorthThreads = 4e6;

/// Limits of operations for joint products, whose table takes time to make: 16 MB of matrices with tangential
/// components, 2 MB for r by r, which saves fewer operations.
constexpr double kMaxJointOperations = 8e6;
constexpr double kMaxRadialJointOperations = 1e6;

constexpr Index kOrdersAtOnce = 8;
constexpr Index kPhisAtOnce = 32;

/// Each power of the metric is a separate convolution.
std::vector<ConvolutionTerm> local_terms(const SphereInfluence& influence) {
  const std::size_t components = influence.components();
  const std::size_t tables = influence.local.size() / influence.powers;
  std::vector<ConvolutionTerm> terms;
  for (std::size_t power = 0; power < influence.powers; ++power) {
    for (std::size_t p = 0; p < components; ++p) {
      for (std::size_t q = 0; q < components; ++q) {
        const SignedEntry source = entry_of(p, q);
        terms.push_back({.result = power * components + p,
                         .table = power * tables + static_cast<std::size_t>(source.entry),
                         .operand = power * components + q,
                         .sign = source.sign});
      }
    }
  }
  return terms;
}

double local_operations(WindowShape shape, const SphereInfluence& influence) {
  if (influence.powers == 0) return 0.0;
  const std::size_t components = influence.components();
  const std::size_t fields = influence.powers * components;
  return SpectralProduct::operations(doubled(shape), fields, fields * components, fields);
}

/// Number of nodes from the equator to the far edge of a window, on one side.
int one_side(WindowShape shape, int first_theta) {
  return std::max(-first_theta, first_theta + shape.theta_nodes - 1) + 1;
}

/// Operations of the sums over phi and over the degrees, to amplitudes and back.
double harmonic_operations(WindowShape shape, int first_theta, const SphereInfluence& influence) {
  const bool tangential = influence.tangential;
  const auto half = static_cast<double>(one_side(shape, first_theta));
  const auto orders = static_cast<double>(influence.orders.size());
  const double degrees = 0.5 * orders * (orders + 1.0);
  const double waves = 16.0 * (tangential ? 3.0 : 1.0) * half * shape.phi_nodes * orders;
  return waves + (tangential ? 40.0 : 8.0) * degrees * half;
}

/// Amplitudes of one component, or of phi and theta.
using Amplitudes = std::vector<Eigen::ArrayXcd>;

/// Sum forces to amplitudes of the degrees.
/// @param[in] harmonic harmonics at thetas
/// @param[in] force forces at thetas: real parts of all components, then imaginary parts
Amplitudes summed(const MatrixXd& harmonic, const MatrixXd& force) {
  const MatrixXd sums = product(harmonic.leftCols(force.rows()), force);
  const Index count = force.cols() / 2;
  Amplitudes amplitudes;
  for (Index i = 0; i < count; ++i) {
    amplitudes.emplace_back(sums.rows());
    amplitudes.back().real() = sums.col(i);
    amplitudes.back().imag() = sums.col(count + i);
  }
  return amplitudes;
}

/// Sum amplitudes of the degrees to displacements at thetas, with real and imaginary parts in the same order.
MatrixXd displacements_of(const MatrixXd& harmonic, const Amplitudes& amplitudes, Index thetas) {
  const auto count = static_cast<Index>(amplitudes.size());
  MatrixXd parts(harmonic.rows(), 2 * count);
  for (Index i = 0; i < count; ++i) {
    parts.col(i) = amplitudes[static_cast<std::size_t>(i)].real();
    parts.col(count + i) = amplitudes[static_cast<std::size_t>(i)].imag();
  }
  return product(harmonic.leftCols(thetas).transpose(), parts);
}

int phi_period(WindowShape shape) { return RealFft::fast_length(2 * shape.phi_nodes - 1); }

std::size_t frequencies(int period) { return static_cast<std::size_t>(period / 2 + 1); }

/// Displacement along P due to forces along Q: [offset -reach ... reach, thetas * loaded theta + displaced theta].
MatrixXd table_of(int p, int q, WindowShape shape, int first_theta, const SphereInfluence& influence,
                  const OrderPhases& phases, const Worker& worker) {
  const Index thetas = shape.theta_nodes;
  const int reach = shape.phi_nodes - 1;
  const Index half_theta = std::max<Index>(-first_theta, first_theta + thetas - 1);
  const auto orders = static_cast<Index>(influence.orders.size());
  MatrixXd real(orders, thetas * thetas);
  MatrixXd imaginary(orders, thetas * thetas);
  for (Index m = 0; m < orders; ++m) {
    const Eigen::MatrixXcd all = sum_between(influence.orders[static_cast<std::size_t>(m)], p, q, half_theta);
    const Eigen::MatrixXcd own = all.block(half_theta + first_theta, half_theta + first_theta, thetas, thetas);
    real.row(m) = own.real().reshaped().transpose();
    imaginary.row(m) = own.imag().reshaped().transpose();
    worker.checkpoint();
  }
  const OrderPhases::Sums sums = phases(real, imaginary);
  MatrixXd table(2 * reach + 1, thetas * thetas);
  table.bottomRows(reach + 1) = sums.even + sums.odd;
  table.topRows(reach + 1) = (sums.even - sums.odd).colwise().reverse();

  const SignedEntry source = entry_of(static_cast<std::size_t>(p), static_cast<std::size_t>(q));
  const Eigen::ArrayXd root = influence.root.segment(influence.half_theta() + first_theta, thetas);
  const std::size_t tables = influence.powers == 0 ? 0 : influence.local.size() / influence.powers;
  for (std::size_t power = 0; power < influence.powers; ++power) {
    const Table& local = influence.local[power * tables + static_cast<std::size_t>(source.entry)];
    const Eigen::ArrayXd metric = root.pow(static_cast<double>(power) - 1.0);
    for (Index from = 0; from < thetas; ++from) {
      for (Index to = 0; to < thetas; ++to) {
        const double factor = source.sign * metric[to] * metric[from];
        for (int j = -reach; j <= reach; ++j) {
          table(j + reach, from * thetas + to) += factor * local(j, static_cast<int>(to - from));
        }
      }
    }
  }
  return table;
}

}  // namespace

std::unique_ptr<const SphereProduct> make_sphere_product(WindowShape shape, int first_theta,
                                                         std::shared_ptr<const SphereInfluence> influence, int threads,
                                                         Watch& watch) {
  const double joint = JointSphereProduct::operations(shape, influence->components());
  const double most = influence->tangential ? kMaxJointOperations : kMaxRadialJointOperations;
  const bool pays =
      joint < most && joint < harmonic_operations(shape, first_theta, *influence) + local_operations(shape, *influence);
  if (pays) return std::make_unique<const JointSphereProduct>(shape, first_theta, *influence, threads, watch);
  return std::make_unique<const FactoredSphereProduct>(shape, first_theta, std::move(influence), threads, watch);
}

FactoredSphereProduct::FactoredSphereProduct(WindowShape shape, int first_theta,
                                             std::shared_ptr<const SphereInfluence> influence, int threads,
                                             Watch& watch)
    : shape_(shape),
      first_theta_(first_theta),
      half_(one_side(shape, first_theta)),
      components_(static_cast<Index>(influence->components())),
      influence_(std::move(influence)),
      waves_(shape.phi_nodes, 2 * static_cast<Index>(influence_->orders.size())) {
  const Eigen::ArrayXd phi =
      influence_->phi_spacing * Eigen::ArrayXd::LinSpaced(shape.phi_nodes, 0.0, shape.phi_nodes - 1.0);
  for (Index m = 0; 2 * m < waves_.cols(); ++m) {
    waves_.col(2 * m) = (static_cast<double>(m) * phi).cos();
    waves_.col(2 * m + 1) = -(static_cast<double>(m) * phi).sin();
  }
  if (influence_->local.empty()) return;
  const Eigen::ArrayXd root = influence_->root.segment(influence_->half_theta() + first_theta, shape.theta_nodes);
  for (std::size_t power = 0; power < influence_->powers; ++power) {
    metric_.emplace_back(root.pow(static_cast<double>(power) - 1.0).replicate(shape.phi_nodes, 1));
  }
  local_.emplace(shape, influence_->local, local_terms(*influence_), threads, watch);
}

Eigen::ArrayXXd FactoredSphereProduct::apply(const Eigen::ArrayXXd& loads, int threads, Watch& watch) const {
  const MatrixXd sides = folded(loads);
  const auto orders = static_cast<Index>(influence_->orders.size());
  const auto blocks = [](Index count, Index at_once) {
    return static_cast<std::size_t>((count + at_once - 1) / at_once);
  };
  const int used = operations() < kWorthThreads ? 1 : threads;

  MatrixXd amplitudes = MatrixXd::Zero(sides.rows(), waves_.cols());
  parallel_for(blocks(orders, kOrdersAtOnce), used, watch, "solving contact", [&](std::size_t block, const Worker&) {
    const Index first = static_cast<Index>(block) * kOrdersAtOnce;
    const Index count = std::min(kOrdersAtOnce, orders - first);
    add_product(sides, waves_.middleCols(2 * first, 2 * count), amplitudes.middleCols(2 * first, 2 * count));
    for (Index m = first; m < first + count; ++m) {
      respond(influence_->orders[static_cast<std::size_t>(m)], amplitudes.middleCols(2 * m, 2));
    }
  });

  MatrixXd moved = MatrixXd::Zero(sides.rows(), shape_.phi_nodes);
  parallel_for(blocks(shape_.phi_nodes, kPhisAtOnce), used, watch, "solving contact",
               [&](std::size_t block, const Worker&) {
                 const Index first = static_cast<Index>(block) * kPhisAtOnce;
                 const Index count = std::min<Index>(kPhisAtOnce, shape_.phi_nodes - first);
                 add_product(amplitudes, waves_.middleRows(first, count).transpose(), moved.middleCols(first, count));
               });
  Eigen::ArrayXXd result = unfolded(moved);
  if (local_) add_local(loads, result, threads, watch);
  return result;
}

double FactoredSphereProduct::operations() const {
  return harmonic_operations(shape_, first_theta_, *influence_) + (local_ ? local_->operations() : 0.0);
}

/// Even and odd part of each component about the equator, as sums and differences of the two sides.
/// @return [side * components * half + component * half + theta, phi]
MatrixXd FactoredSphereProduct::folded(const Eigen::ArrayXXd& loads) const {
  MatrixXd sides = MatrixXd::Zero(2 * components_ * half_, shape_.phi_nodes);
  for (Index component = 0; component < components_; ++component) {
    const double* load = loads.col(component).data();
    for (Index j = 0; j < shape_.phi_nodes; ++j) {
      double* even = sides.col(j).data() + component * half_;
      double* odd = even + components_ * half_;
      for (int k = first_theta_; k < first_theta_ + shape_.theta_nodes; ++k, ++load) {
        even[std::abs(k)] += *load;
        if (k != 0) odd[std::abs(k)] += k > 0 ? *load : -*load;
      }
    }
  }
  return sides;
}

Eigen::ArrayXXd FactoredSphereProduct::unfolded(const MatrixXd& sides) const {
  Eigen::ArrayXXd result(shape_.size(), components_);
  for (Index component = 0; component < components_; ++component) {
    double* moved = result.col(component).data();
    for (Index j = 0; j < shape_.phi_nodes; ++j) {
      const double* even = sides.col(j).data() + component * half_;
      const double* odd = even + components_ * half_;
      for (int k = first_theta_; k < first_theta_ + shape_.theta_nodes; ++k, ++moved) {
        *moved = even[std::abs(k)] + (k == 0 ? 0.0 : (k > 0 ? odd[std::abs(k)] : -odd[std::abs(k)]));
      }
    }
  }
  return result;
}

/// Replace forces by displacements at one order; the two columns are real and imaginary parts.
void FactoredSphereProduct::respond(const SphericalOrder& order, Eigen::Ref<MatrixXd> amplitudes) const {
  const MatrixXd force = amplitudes;
  amplitudes.setZero();
  const auto place = [&](std::size_t side, Index component) {
    return (static_cast<Index>(side) * components_ + component) * half_;
  };
  // Components phi and theta: real parts of both, then imaginary parts of both.
  const auto along = [&](std::size_t side) -> MatrixXd {
    return MatrixXd(force.middleRows(place(side, 1), 2 * half_)).reshaped(half_, 4);
  };
  const auto add_along = [&](const MatrixXd& harmonic, const Amplitudes& pair, std::size_t side) {
    amplitudes.middleRows(place(side, 1), 2 * half_) += displacements_of(harmonic, pair, half_).reshaped(2 * half_, 2);
  };
  constexpr std::complex<double> kI(0.0, 1.0);
  for (std::size_t side = 0; side < 2; ++side) {  // parity of P and E; that of D is opposite
    const EveryOtherDegree& own = order[side];
    const std::size_t other = 1 - side;
    const Eigen::ArrayXcd y = summed(own.loaded->p, force.middleRows(place(side, 0), half_)).front();
    Eigen::ArrayXcd moved_y = own.radial * y;
    if (components_ == 3) {
      const Amplitudes e = summed(own.loaded->e, along(side));
      const Amplitudes d = summed(own.loaded->d, along(other));
      const Eigen::ArrayXcd psi = d.back() - kI * e.front();
      const Eigen::ArrayXcd phi = d.front() + kI * e.back();
      const Eigen::ArrayXcd moved_psi = own.mixed * y + own.along * psi;
      const Eigen::ArrayXcd moved_phi = own.across * phi;
      moved_y += own.mixed * psi;
      add_along(own.displaced->e, {kI * moved_psi, -kI * moved_phi}, side);
      add_along(own.displaced->d, {moved_phi, moved_psi}, other);
    }
    amplitudes.middleRows(place(side, 0), half_) += displacements_of(own.displaced->p, {moved_y}, half_);
  }
}

void FactoredSphereProduct::add_local(const Eigen::ArrayXXd& loads, Eigen::ArrayXXd& result, int threads,
                                      Watch& watch) const {
  const auto powers = static_cast<Index>(metric_.size());
  Eigen::ArrayXXd weighted(loads.rows(), powers * components_);
  for (Index field = 0; field < weighted.cols(); ++field) {
    weighted.col(field) = metric_[static_cast<std::size_t>(field / components_)] * loads.col(field % components_);
  }
  const Eigen::ArrayXXd moved = local_->apply(weighted, threads, watch);
  for (Index field = 0; field < moved.cols(); ++field) {
    result.col(field % components_) += metric_[static_cast<std::size_t>(field / components_)] * moved.col(field);
  }
}

JointSphereProduct::JointSphereProduct(WindowShape shape, int first_theta, const SphereInfluence& influence,
                                       int threads, Watch& watch)
    : shape_(shape),
      components_(static_cast<Index>(influence.components())),
      period_(phi_period(shape)),
      fft_(period_),
      spectrum_(frequencies(period_)) {
  const Index thetas = shape.theta_nodes;
  const Index lines = components_ * thetas;
  const int reach = shape.phi_nodes - 1;
  for (Eigen::MatrixXcd& matrix : spectrum_) matrix.resize(lines, lines);
  const OrderPhases phases(static_cast<int>(influence.orders.size()), reach, influence.phi_spacing);
  parallel_for(static_cast<std::size_t>(components_ * components_), threads, watch, "transforming tables",
               [&](std::size_t pair, const Worker& worker) {
                 const Index p = static_cast<Index>(pair) / components_;
                 const Index q = static_cast<Index>(pair) % components_;
                 const MatrixXd table =
                     table_of(static_cast<int>(p), static_cast<int>(q), shape, first_theta, influence, phases, worker);
                 worker.checkpoint();
                 RealBuffer line(static_cast<std::size_t>(period_));
                 ComplexBuffer transformed(spectrum_.size());
                 for (Index i = 0; i < table.cols(); ++i) {
                   std::ranges::fill(line, 0.0);
                   for (int j = -reach; j <= reach; ++j) {
                     line[static_cast<std::size_t>((j + period_) % period_)] = table(j + reach, i) / period_;
                   }
                   fft_.forward(line.data(), transformed.data());
                   for (std::size_t f = 0; f < spectrum_.size(); ++f) {
                     spectrum_[f](p * thetas + i % thetas, q * thetas + i / thetas) = transformed[f];
                   }
                 }
               });
}

double JointSphereProduct::operations(WindowShape shape, std::size_t components) {
  const auto lines = static_cast<double>(components) * shape.theta_nodes;
  return 8.0 * static_cast<double>(frequencies(phi_period(shape))) * lines * lines;
}

double JointSphereProduct::operations() const { return operations(shape_, static_cast<std::size_t>(components_)); }

Eigen::ArrayXXd JointSphereProduct::apply(const Eigen::ArrayXXd& loads, int /*threads*/, Watch& /*watch*/) const {
  const Index thetas = shape_.theta_nodes;
  const auto count = static_cast<Index>(spectrum_.size());
  Eigen::MatrixXcd transformed(components_ * thetas, count);
  RealBuffer line(static_cast<std::size_t>(period_));
  ComplexBuffer half(spectrum_.size());
  const Eigen::Map<Eigen::ArrayXd> nodes(line.data(), shape_.phi_nodes);
  for (Index row = 0; row < transformed.rows(); ++row) {
    const Eigen::Map<const Eigen::ArrayXXd> load(loads.col(row / thetas).data(), thetas, shape_.phi_nodes);
    std::ranges::fill(line, 0.0);
    for (Index j = 0; j < shape_.phi_nodes; ++j) line[static_cast<std::size_t>(j)] = load(row % thetas, j);
    fft_.forward(line.data(), half.data());
    transformed.row(row) = Eigen::Map<const Eigen::RowVectorXcd>(half.data(), count);
  }
  for (Index f = 0; f < count; ++f) {
    transformed.col(f) = multiplied(spectrum_[static_cast<std::size_t>(f)], transformed.col(f));
  }
  Eigen::ArrayXXd result(loads.rows(), components_);
  for (Index row = 0; row < transformed.rows(); ++row) {
    Eigen::Map<Eigen::RowVectorXcd>(half.data(), count) = transformed.row(row);
    fft_.backward(half.data(), line.data());
    Eigen::Map<Eigen::ArrayXXd> moved(result.col(row / thetas).data(), thetas, shape_.phi_nodes);
    moved.row(row % thetas) = nodes.transpose();
  }
  return result;
}

}  // namespace viscoroll::detail

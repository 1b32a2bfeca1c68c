#include "contact/stick_slip_preconditioner.hpp"

#include <complex>
#include <numbers>

#include "influence/table_product.hpp"

namespace viscoroll::detail {
namespace {

/// Return the inverse of all nine entries of the compliance, in the order (r, phi, theta).
InverseConvolution make_inverse(const SurfaceOperator& surface) {
  std::vector<const Table*> tables;
  for (const auto& table : surface.local().tables) tables.push_back(table.get());
  std::vector<ConvolutionTerm> terms;
  for (std::size_t p = 0; p < 3; ++p) {
    for (std::size_t q = 0; q < 3; ++q) {
      const SignedEntry source = entry_of(p, q);
      terms.push_back({p, static_cast<std::size_t>(source.entry), q, source.sign});
    }
  }
  const Execution& execution = surface.execution();
  return {surface.shape(), doubled(surface.shape()), tables, terms, execution.threads, execution.watch};
}

}  // namespace

StickSlipPreconditioner::StickSlipPreconditioner(const SurfaceOperator& surface)
    : surface_(surface), inverse_(make_inverse(surface)), product_(surface.shape(), doubled(surface.shape())) {
  const WindowShape period = product_.period();
  const PeriodicTable forward(surface.local().table(Entry::phiphi), surface.shape(), period);
  const PeriodicTable sideways(surface.local().table(Entry::thetatheta), surface.shape(), period);
  const Execution& execution = surface.execution();
  slip_compliance_ = product_.spectrum([&](int j, int l) { return 0.5 * (forward(j, l) + sideways(j, l)); }, false,
                                       execution.threads, execution.watch);
  const std::size_t stride = product_.column_stride();
  for (std::size_t i = 0; i < slip_compliance_.size(); ++i) {
    const double turn = static_cast<double>(i % stride) / period.phi_nodes;
    slip_compliance_[i] *= static_cast<double>(period.size()) * (1.0 - std::polar(1.0, -2.0 * std::numbers::pi * turn));
  }
}

VectorField StickSlipPreconditioner::force(const VectorField& displacement) const {
  const LocalCompliance& local = surface_.local();
  const Execution& execution = surface_.execution();
  return local.forces(inverse_.apply(local.loads(displacement), execution.threads, execution.watch));
}

ComplexBuffer StickSlipPreconditioner::turning_symbol(double rigidity, double scale) const {
  ComplexBuffer symbol(slip_compliance_.size());
  const auto points = static_cast<double>(product_.period().size());
  for (std::size_t i = 0; i < symbol.size(); ++i) {
    symbol[i] = 1.0 / (points * (1.0 - rigidity + rigidity * scale * slip_compliance_[i]));
  }
  return symbol;
}

Eigen::ArrayXd StickSlipPreconditioner::apply(const ComplexBuffer& symbol, const Eigen::ArrayXd& field) const {
  const Execution& execution = surface_.execution();
  return product_.apply(field, {{0, &symbol, 0, 1.0}}, 1, execution.threads, execution.watch);
}

}  // namespace viscoroll::detail

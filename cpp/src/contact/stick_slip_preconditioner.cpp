#include "contact/stick_slip_preconditioner.hpp"

#include <complex>
#include <numbers>

#include "influence/periodic_table.hpp"

namespace viscoroll::detail {
StickSlipPreconditioner::StickSlipPreconditioner(const CoatingCompliance& coating)
    : coating_(coating),
      inverse_(coating.make_inverse(doubled(coating.shape()))),
      product_(coating.shape(), doubled(coating.shape())) {
  const WindowShape period = product_.period();
  const PeriodicTable forward(coating.table(Entry::phiphi), coating.shape(), period);
  const PeriodicTable sideways(coating.table(Entry::thetatheta), coating.shape(), period);
  const Execution& execution = coating.execution();
  slip_compliance_ = product_.spectrum([&](int j, int l) { return 0.5 * (forward(j, l) + sideways(j, l)); },
                                       execution.threads, execution.watch);
  const std::size_t stride = product_.column_stride();
  for (std::size_t i = 0; i < slip_compliance_.size(); ++i) {
    const double turn = static_cast<double>(i % stride) / period.phi_nodes;
    slip_compliance_[i] *= static_cast<double>(period.size()) * (1.0 - std::polar(1.0, -2.0 * std::numbers::pi * turn));
  }
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
  const Execution& execution = coating_.execution();
  return product_.apply(field, {{0, &symbol, 0, 1.0}}, 1, execution.threads, execution.watch);
}

}  // namespace viscoroll::detail

#include "rolling/free_side_tables.hpp"

#include <utility>
#include <vector>

#include "rolling/spot_surface.hpp"
#include "section/tread_store.hpp"
#include "surface/free_sides_operator.hpp"

namespace viscoroll::detail {

FreeSideTables::FreeSideTables(std::unique_ptr<const SurfaceTables> endless, const CoatedWheel& wheel,
                               const LayeredBody& layers, const Crossing& crossing)
    : endless_(std::move(endless)),
      wheel_(wheel),
      layers_(layers),
      patches_(patches_under(layers, crossing)),
      mesh_(nearest_mesh(patches_, crossing.mesh)),
      angular_speed_(patches_.turns * crossing.angular_speed) {}

std::shared_ptr<const SurfaceOperator> FreeSideTables::operator_on(const SurfaceWindow& nodes,
                                                                   const Formulation& formulation,
                                                                   const Execution& execution) const {
  const bool tangential = formulation.tangential || formulation.compliance == Compliance::vertical;
  auto sum = this->sum(tangential, execution);
  SideFactors factors = sum->factors({.phi_reach = nodes.shape().phi_nodes - 1, .phi_shift = formulation.collocation});
  auto difference = sum->difference();
  return std::make_shared<FreeSidesOperator>(
      endless_->operator_on(nodes, formulation, execution), std::move(difference), std::move(factors),
      [sum = std::move(sum)](int phi_reach) { return sum->factors({.phi_reach = phi_reach, .power = true}); },
      NodeSpacing{.along = nodes.grid().radius * nodes.grid().phi_spacing,
                  .across = nodes.grid().radius * nodes.grid().theta_spacing});
}

std::shared_ptr<const SideSum> FreeSideTables::sum(bool tangential, const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  auto& sum = sums_[tangential ? 1 : 0];
  if (sum) return sum;
  const Eigen::ArrayXd samples = sampled_orders(wheel_);
  const double limit = measured_order(mesh_);
  const HarmonicBody sampled(layers_, angular_speed_, {samples.begin(), samples.end()}, limit);
  auto difference = kept_difference(wheel_, sampled, tangential, execution.threads, execution.watch);
  std::vector<OrderBand> bands = phi_bands(layers_, angular_speed_, mesh_);
  const HarmonicBody harmonics(layers_, angular_speed_, all_orders(bands), limit);
  sum = std::make_shared<const SideSum>(std::move(difference), std::move(bands), harmonics, patches_);
  return sum;
}

}  // namespace viscoroll::detail

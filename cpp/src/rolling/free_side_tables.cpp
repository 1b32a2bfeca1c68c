#include "rolling/free_side_tables.hpp"

#include <utility>
#include <vector>

#include "section/tread_store.hpp"
#include "surface/free_sides_operator.hpp"

namespace viscoroll::detail {

FreeSideTables::FreeSideTables(std::unique_ptr<const SurfaceTables> endless, CoatedWheel wheel, LayeredBody layers,
                               const Crossing& crossing)
    : endless_(std::move(endless)),
      wheel_(std::move(wheel)),
      layers_(std::move(layers)),
      mesh_(crossing.mesh_at(layers_.metric.radius)),
      angular_speed_(crossing.angular_speed_at(layers_.metric.radius)) {}

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
      nodes.grid().radius * nodes.grid().theta_spacing);
}

std::shared_ptr<const SideSum> FreeSideTables::sum(bool tangential, const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  auto& sum = sums_[tangential ? 1 : 0];
  if (sum) return sum;
  const Eigen::ArrayXd samples = sampled_orders(wheel_);
  const double limit = measured_order(mesh_.rounded());
  const HarmonicBody sampled(layers_, angular_speed_, {samples.begin(), samples.end()}, limit);
  auto difference = kept_difference(wheel_, sampled, tangential, execution.threads, execution.watch);
  std::vector<OrderBand> bands = phi_bands(layers_, angular_speed_, mesh_.rounded());
  const HarmonicBody harmonics(layers_, angular_speed_, all_orders(bands), limit);
  sum = std::make_shared<const SideSum>(std::move(difference), std::move(bands), harmonics, mesh_);
  return sum;
}

}  // namespace viscoroll::detail

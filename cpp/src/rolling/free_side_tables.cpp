#include "rolling/free_side_tables.hpp"

#include <utility>
#include <vector>

#include "section/side_difference.hpp"
#include "surface/corrected_operator.hpp"

namespace viscoroll::detail {

FreeSideTables::FreeSideTables(std::unique_ptr<const SurfaceTables> unbounded, CoatedWheel wheel, LayeredBody layers,
                               const ContactKinematics& kinematics)
    : unbounded_(std::move(unbounded)),
      wheel_(std::move(wheel)),
      layers_(std::move(layers)),
      rolling_{.mesh = kinematics.mesh_at(layers_.metric.radius),
               .angular_speed = kinematics.angular_speed_at(layers_.metric.radius)} {}

std::shared_ptr<const SurfaceOperator> FreeSideTables::operator_on(const SurfaceWindow& nodes,
                                                                   const Formulation& formulation,
                                                                   const Execution& execution) const {
  const bool tangential = formulation.tangential || formulation.compliance == Compliance::vertical;
  auto sum = this->sum(tangential, execution);
  SideFactors factors = sum->factors({.phi_reach = nodes.shape().phi_nodes - 1, .phi_shift = formulation.collocation});
  auto difference = sum->difference();
  return std::make_shared<FreeSidesOperator>(
      unbounded_->operator_on(nodes, formulation, execution), std::move(difference), std::move(factors),
      [kept = std::move(sum)](int phi_reach) { return kept->factors({.phi_reach = phi_reach, .power = true}); },
      nodes.grid().radius * nodes.grid().theta_spacing);
}

std::shared_ptr<const SideSum> FreeSideTables::sum(bool tangential, const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  auto& sum = sums_[tangential ? 1 : 0];
  if (!sum) {
    sum = std::make_shared<const SideSum>(sum_of_sides(wheel_, layers_, rolling_, tangential, execution));
  }
  return sum;
}

SideSum sum_of_sides(const CoatedWheel& wheel, const LayeredBody& layers, const MeshAtSpeed& rolling, bool tangential,
                     const Execution& execution) {
  const auto& [mesh, angular_speed] = rolling;
  const Eigen::ArrayXd samples = sampled_orders(wheel);
  const double limit = measured_order(mesh.rounded());
  const HarmonicBody sampled(layers, angular_speed, {samples.begin(), samples.end()}, limit);
  auto difference = cached_difference(wheel, sampled, tangential, execution.threads, execution.watch);
  std::vector<OrderBand> bands = phi_bands(layers, angular_speed, mesh.rounded());
  const HarmonicBody harmonics(layers, angular_speed, all_orders(bands), limit);
  return {std::move(difference), std::move(bands), inverse_outer_modulus(harmonics), mesh};
}

}  // namespace viscoroll::detail

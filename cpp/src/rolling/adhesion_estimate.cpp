#include "rolling/adhesion_estimate.hpp"

#include <cmath>
#include <cstddef>

namespace viscoroll::detail {
namespace {

/// J(t) [1/Pa]
double compliance_after(const EdgeCreep& creep, double time) {
  double value = creep.instantaneous;
  for (std::size_t j = 0; j < creep.delayed.size(); ++j) {
    value -= creep.delayed[j] * std::expm1(-time / creep.retardation_times[j]);
  }
  return value;
}

}  // namespace

double adhesion_torque_estimate(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, const RollingStrip& contact) {
  constexpr double kPassage = 1.2;
  const auto& [separation, bonding, strength] = adhesion;
  const double edge = separation / (creep.relaxed() * strength * strength);
  const double ratio = compliance_after(creep, kPassage * contact.half_length / contact.speed) /
                       compliance_after(creep, edge / contact.speed);
  return contact.width * contact.radius * (separation * ratio - bonding / ratio);
}

}  // namespace viscoroll::detail

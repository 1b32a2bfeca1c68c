#include "rolling/adhesion_estimate.hpp"

#include <cmath>

namespace viscoroll::detail {
double adhesion_torque_estimate(const EdgeCreep& creep, const SurfaceAdhesion& adhesion, const RollingStrip& contact) {
  constexpr double kPassage = 1.2;
  const auto& [separation, bonding, strength] = adhesion;
  const double edge = separation / (creep.relaxed() * strength * strength);
  const double ratio = creep.after(kPassage * contact.half_length / contact.speed) / creep.after(edge / contact.speed);
  return contact.width * contact.radius * (separation * ratio - bonding / ratio);
}

}  // namespace viscoroll::detail

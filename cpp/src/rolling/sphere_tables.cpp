#include "rolling/sphere_tables.hpp"

#include <algorithm>
#include <utility>

namespace viscoroll::detail {

std::shared_ptr<const SphereInfluence> SphereTables::influence(const SphereRequest& request, int phi_reach,
                                                               int half_theta, const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  const auto found = std::ranges::find(entries_, request, &Entry::request);
  if (found != entries_.end()) {
    const SphereInfluence& widest = *found->influence;
    if (widest.phi_reach >= phi_reach && widest.half_theta() >= half_theta) return found->influence;
    phi_reach = std::max(phi_reach, widest.phi_reach);
    half_theta = std::max(half_theta, widest.half_theta());
  }
  // What displaces will dissipate: the local metric serves both at once.
  std::vector<SphereRequest> requests{request, request};
  requests.back().power = !request.power;
  auto influences = sum_.influences(requests, phi_reach, half_theta, execution.threads, execution.watch);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    std::erase_if(entries_, [&](const Entry& entry) { return entry.request == requests[i]; });
    entries_.push_back(
        {.request = requests[i], .influence = std::make_shared<const SphereInfluence>(std::move(influences[i]))});
  }
  return std::ranges::find(entries_, request, &Entry::request)->influence;
}

}  // namespace viscoroll::detail

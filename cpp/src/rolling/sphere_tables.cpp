#include "rolling/sphere_tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viscoroll::detail {
namespace {

constexpr double kFewValues = 0.1 * kMostTableValues;

}  // namespace

std::shared_ptr<const std::vector<SphereTable>> SphereTables::tables(const SphereRequest& request, int phi_reach,
                                                                     int half_theta, const Execution& execution) const {
  const auto lock = lock_watched(mutex_, execution.watch, "waiting for another thread's tables");
  const auto found = std::ranges::find(sets_, request, &Set::request);
  if (found != sets_.end()) {
    const SphereTable& table = found->tables->front();
    const int half = (table.theta_nodes() - 1) / 2;
    if (table.phi_reach() >= phi_reach && half >= half_theta) return found->tables;
    phi_reach = std::max(phi_reach, table.phi_reach());
    half_theta = std::max(half_theta, half);
  }
  std::vector<SphereRequest> requests{request};
  // What displaces will dissipate: tables that are small are made for both at once, which costs hardly more.
  const double values = request.count() * (2.0 * phi_reach + 1.0) * std::pow(2.0 * half_theta + 1.0, 2);
  if (values < kFewValues) {
    requests.push_back(request);
    requests.back().power = !request.power;
  }
  auto sets = sum_.tables(requests, phi_reach, half_theta, execution.threads, execution.watch);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    std::erase_if(sets_, [&](const Set& set) { return set.request == requests[i]; });
    sets_.push_back(
        {.request = requests[i], .tables = std::make_shared<const std::vector<SphereTable>>(std::move(sets[i]))});
  }
  return std::ranges::find(sets_, request, &Set::request)->tables;
}

}  // namespace viscoroll::detail

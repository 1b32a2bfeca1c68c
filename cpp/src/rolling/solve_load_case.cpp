#include "rolling/solve_load_case.hpp"

#include <algorithm>
#include <cmath>

#include "rolling/refusals.hpp"
#include "rolling/result.hpp"

namespace viscoroll::detail {

ContactReach contact_reach(const Result& result) {
  ContactReach reach{.along = 0.0, .across = 0.0};
  for (std::size_t node = 0; node < result.contact.size(); ++node) {
    if (result.contact[node] == 0) continue;
    reach.along = std::max(reach.along, std::abs(result.x[node]));
    reach.across = std::max(reach.across, std::abs(result.z[node]));
  }
  return reach;
}

Result solve_load_case(const MeshModel& model, const LoadCase& load_case, const Options& options, Watch& watch,
                       const std::optional<ContactReach>& seen) {
  require_formulation(model, options);
  require_bearable_load(model, load_case.load);
  const Assembly assembly = assemble(model, load_case, options, watch);
  require_lasting_stiffness(assembly);
  return make_result(assembly, find_window(assembly, seen));
}

}  // namespace viscoroll::detail

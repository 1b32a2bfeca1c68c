#include "answer_to_json.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace viscoroll::wasm {
namespace {

// The functions name_of have no default case, so that the compiler warns if an enumerator is missing.

std::string_view name_of(Status status) {
  switch (status) {
    case Status::converged:
      return "converged";
    case Status::max_iterations:
      return "max_iterations";
    case Status::accuracy_not_reached:
      return "accuracy_not_reached";
  }
  return "";
}

std::string_view name_of(WarningKind kind) {
  switch (kind) {
    case WarningKind::max_iterations:
      return "max_iterations";
    case WarningKind::accuracy_not_reached:
      return "accuracy_not_reached";
    case WarningKind::coarse_mesh:
      return "coarse_mesh";
    case WarningKind::power_balance:
      return "power_balance";
    case WarningKind::pressure_peak:
      return "pressure_peak";
    case WarningKind::large_strain:
      return "large_strain";
    case WarningKind::contact_at_side:
      return "contact_at_side";
    case WarningKind::edge_pressure:
      return "edge_pressure";
    case WarningKind::tight_crown:
      return "tight_crown";
    case WarningKind::slow_terms:
      return "slow_terms";
  }
  return "";
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

template <class Value>
Json or_null(const Value& value) {
  return value;
}

/// Access to the nodes of a result by row and column.
class Nodes {
 public:
  explicit Nodes(const Result& result)
      : rows_(static_cast<std::size_t>(result.phi_nodes)), columns_(static_cast<std::size_t>(result.theta_nodes)) {}

  /// @return value of each row in the middle plane
  template <class Value>
  [[nodiscard]] Json middle(const Value& value) const {
    Json all = Json::array();
    for (std::size_t row = 0; row < rows_; ++row) all.push_back(value(row * columns_ + columns_ / 2));
    return all;
  }

  /// @return values of all columns of the first row
  template <class Value>
  [[nodiscard]] Json across(const Value& value) const {
    Json all = Json::array();
    for (std::size_t column = 0; column < columns_; ++column) all.push_back(value(column));
    return all;
  }

  /// @return values of all nodes, as an array of rows
  template <class Value>
  [[nodiscard]] Json all(const Value& value) const {
    Json rows = Json::array();
    for (std::size_t row = 0; row < rows_; ++row) {
      rows.push_back(across([&](std::size_t column) { return value(row * columns_ + column); }));
    }
    return rows;
  }

 private:
  std::size_t rows_;
  std::size_t columns_;
};

}  // namespace

Json result_to_json(const Result& result) {
  Json scalars;
#define VISCOROLL_SCALAR(type, name, group, precision, unit, label, details) scalars[#name] = or_null(result.name);
#include "viscoroll/result_scalars.def"
#undef VISCOROLL_SCALAR
  scalars["contact_nodes"] = result.refinements.back().contact_nodes;
  scalars["nodes_per_revolution"] = result.mesh.nodes_per_revolution;
  scalars["max_order"] = or_null(result.mesh.max_order);
  Json warnings = Json::array();
  for (const Warning& warning : result.warnings) {
    warnings.push_back({{"kind", name_of(warning.kind)}, {"message", warning.message}});
  }
  return {{"scalars", scalars}, {"state", name_of(result.status)}, {"warnings", warnings}};
}

Json fields_to_json(const Result& result, bool with_friction) {
  const Nodes nodes(result);
  const auto of = [](const std::vector<double>& field) { return [&](std::size_t node) { return field[node]; }; };
  const auto state = [&](std::size_t node) { return result.stick[node] + 2 * result.slip[node]; };
  const auto rigid = [&](std::size_t node) { return result.gap[node] - result.displacement[node]; };
  const Json x = nodes.middle(of(result.x));
  return {{"x", x},
          {"z", nodes.across(of(result.z))},
          {"pressure", nodes.all(of(result.pressure))},
          {"stick", with_friction ? nodes.all(state) : Json()},
          {"profile", {{"x", x}, {"surface", nodes.middle(of(result.gap))}, {"rigid", nodes.middle(rigid)}}}};
}

Json scalars_to_json() {
  return {
#define VISCOROLL_SCALAR(type, name, group, precision, unit, label, details) \
  {{"name", #name}, {"unit", unit}, {"description", label}, {"group", #group}, {"precision", precision}},
#include "viscoroll/result_scalars.def"
#undef VISCOROLL_SCALAR
  };
}

Json series_to_json(std::span<const RollingInstant> instants, double outer_radius) {
  const auto series = [&](const auto& value) {
    Json all = Json::array();
    for (const RollingInstant& instant : instants) {
      const double number = value(instant);
      all.push_back(std::isfinite(number) ? Json(number) : Json());
    }
    return all;
  };
  return {
      {"distance", series([&](const RollingInstant& instant) { return outer_radius * instant.angle; })},
#define VISCOROLL_HISTORY_SCALAR(name, unit, label, details) \
  {#name, series([](const RollingInstant& instant) { return instant.name; })},
#define VISCOROLL_HISTORY_SUMMARY VISCOROLL_HISTORY_SCALAR
#include "viscoroll/history_scalars.def"
#undef VISCOROLL_HISTORY_SUMMARY
#undef VISCOROLL_HISTORY_SCALAR
  };
}

Json history_scalars_to_json() {
  return {
      {{"name", "distance"}, {"unit", "m"}, {"description", "distance rolled along the track, r_o ψ"}},
#define VISCOROLL_HISTORY_SCALAR(name, unit, label, details) {{"name", #name}, {"unit", unit}, {"description", label}},
#define VISCOROLL_HISTORY_SUMMARY VISCOROLL_HISTORY_SCALAR
#include "viscoroll/history_scalars.def"
#undef VISCOROLL_HISTORY_SUMMARY
#undef VISCOROLL_HISTORY_SCALAR
  };
}

}  // namespace viscoroll::wasm

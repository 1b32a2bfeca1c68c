#include "rolling/rolling_body.hpp"

namespace viscoroll::detail {

double outer_radius(const RollingBody& body) {
  return std::visit([](const auto& shape) { return viscoroll::outer_radius(shape); }, body);
}

double coating_thickness(const RollingBody& body) {
  return std::visit([](const auto& shape) { return viscoroll::coating_thickness(shape); }, body);
}

const std::vector<Layer>& layers(const RollingBody& body) {
  return std::visit([](const auto& shape) -> const std::vector<Layer>& { return shape.layers; }, body);
}

bool is_roller(const RollingBody& body) { return std::holds_alternative<CoatedCylinder>(body); }

std::string_view name(const RollingBody& body) { return is_roller(body) ? "roller" : "sphere"; }

std::string_view load_unit(const RollingBody& body) { return is_roller(body) ? "N/m" : "N"; }

}  // namespace viscoroll::detail

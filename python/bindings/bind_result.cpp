#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bindings.hpp"
#include "viscoroll/result.hpp"

namespace {

using namespace viscoroll;

/// Return the getter of a field of the result: a read-only array over its memory, [phi][theta].
template <class T>
auto field(std::vector<T> Result::* member) {
  return [member](const py::object& self) {
    const auto& result = self.cast<const Result&>();
    return read_only(result.*member, {result.phi_nodes, result.theta_nodes}, self);
  };
}

/// Return the getter of a vector field with components along x and z, [component][phi][theta].
auto vector_field(std::vector<double> Result::* member) {
  return [member](const py::object& self) {
    const auto& result = self.cast<const Result&>();
    return read_only(result.*member, {2, result.phi_nodes, result.theta_nodes}, self);
  };
}

std::map<WarningKind, std::string> warnings_by_kind(const Result& result) {
  std::map<WarningKind, std::string> texts;
  for (const Warning& warning : result.warnings) texts.emplace(warning.kind, warning.message);
  return texts;
}

template <class T>
constexpr const char* kTypeName = "float";
template <>
constexpr const char* kTypeName<std::optional<double>> = "float or None";
template <>
constexpr const char* kTypeName<int> = "int";

/// Bind a member. The parameter `text` is a pointer, so that the compiler instantiates only one function for each type
/// of member, not one for each length of the text.
template <class T>
void bind_scalar(py::classh<ResultScalars>& scalars, const char* name, T ResultScalars::* member, const char* text) {
  scalars.def_readonly(name, member, text);
}

void bind_scalars(py::module_& m) {
  py::classh<ScalarDescription>(m, "ScalarDescription")
      .def_readonly("name", &ScalarDescription::name)
      .def_readonly("type", &ScalarDescription::type)
      .def_readonly("unit", &ScalarDescription::unit)
      .def_readonly("label", &ScalarDescription::label)
      .def_readonly("details", &ScalarDescription::details)
      .def_readonly("group", &ScalarDescription::group)
      .def_readonly("precision", &ScalarDescription::precision);
  const auto descriptions = [] {
    return std::vector<ScalarDescription>{
#define VISCOROLL_SCALAR(type, name, group, precision, unit, label, details) \
  {#name, kTypeName<type>, unit, label, details, #group, precision},
#include "viscoroll/result_scalars.def"
#undef VISCOROLL_SCALAR
    };
  };
  m.def("result_scalars", descriptions, "Descriptions of the scalar results, in SI units.");

  py::classh<ResultScalars> scalars(m, "ResultScalars");
#define VISCOROLL_SCALAR(type, name, group, precision, unit, label, details) \
  bind_scalar(scalars, #name, &ResultScalars::name, label " [" unit "]. " details);
#include "viscoroll/result_scalars.def"
#undef VISCOROLL_SCALAR
}

}  // namespace

void bind_result(py::module_& m) {
  py::native_enum<Status>(m, "Status", "enum.Enum", "Outcome of a solve.")
      .value("CONVERGED", Status::converged, "all contact conditions are satisfied")
      .value("MAX_ITERATIONS", Status::max_iterations, "the limit of iterations was reached")
      .value("ACCURACY_NOT_REACHED", Status::accuracy_not_reached,
             "the error estimate exceeds the requested accuracy on the finest mesh")
      .finalize();

  py::native_enum<WarningKind>(m, "WarningKind", "enum.Enum", "Kinds of warnings about a result.")
      .value("MAX_ITERATIONS", WarningKind::max_iterations, "the contact still changed at the limit of iterations")
      .value("ACCURACY_NOT_REACHED", WarningKind::accuracy_not_reached,
             "the error estimate exceeds the requested accuracy")
      .value("COARSE_MESH", WarningKind::coarse_mesh, "a given mesh has few nodes across the contact")
      .value("POWER_BALANCE", WarningKind::power_balance, "on a given mesh the energy-balance error is large")
      .value("PRESSURE_PEAK", WarningKind::pressure_peak,
             "the error estimate of the largest pressure exceeds the accuracy, or 0.1 on a given mesh")
      .value("LARGE_STRAIN", WarningKind::large_strain, "the strain exceeds the range of linear theory")
      .value("CONTACT_AT_SIDE", WarningKind::contact_at_side,
             "the contact of a crowned wheel reaches a face or, with unbounded sides, is closer to it than the tread "
             "thickness")
      .value("EDGE_PRESSURE", WarningKind::edge_pressure,
             "the pressure is singular at the edges of a flat wheel with unbounded sides or on a wider deformable "
             "counterbody")
      .value("TIGHT_CROWN", WarningKind::tight_crown, "the crown radius is smaller than the tread thickness")
      .value("SLOW_TERMS", WarningKind::slow_terms, "terms of a Prony series are too slow to relax at this speed")
      .finalize();

  py::classh<Refinement>(m, "Refinement")
      .def_readonly("mesh", &Refinement::mesh)
      .def_readonly("contact_nodes", &Refinement::contact_nodes)
      .def_readonly("resisting_torque", &Refinement::resisting_torque)
      .def_readonly("penetration", &Refinement::penetration)
      .def_readonly("energy_balance_error", &Refinement::energy_balance_error)
      .def_readonly("error_estimate", &Refinement::error_estimate);

  bind_scalars(m);
  py::classh<Result, ResultScalars>(m, "Result")
      .def_readonly("status", &Result::status)
      .def_readonly("mesh", &Result::mesh)
      .def_readonly("refinements", &Result::refinements)
      .def_property_readonly("warnings", &warnings_by_kind)
      .def_property_readonly("x", field(&Result::x))
      .def_property_readonly("z", field(&Result::z))
      .def_property_readonly("pressure", field(&Result::pressure))
      .def_property_readonly("displacement", field(&Result::displacement))
      .def_property_readonly("gap", field(&Result::gap))
      .def_property_readonly("contact", field(&Result::contact))
      .def_property_readonly("stick", field(&Result::stick))
      .def_property_readonly("slip", field(&Result::slip))
      .def_property_readonly("shear_traction", vector_field(&Result::shear_traction))
      .def_property_readonly("slip_velocity", vector_field(&Result::slip_velocity));
}

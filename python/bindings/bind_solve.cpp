#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "viscoroll/solve.hpp"

namespace {

using namespace viscoroll;

Result solve_released(const CoatedSphere& sphere, double load, double angular_speed, std::optional<Mesh> mesh,
                      double accuracy, Compliance compliance, PatchLoad patch_load, int max_iterations, int threads,
                      const py::object& progress) {
  const Options options{.mesh = mesh,
                        .accuracy = accuracy,
                        .compliance = compliance,
                        .patch_load = patch_load,
                        .max_iterations = max_iterations,
                        .threads = threads,
                        .observer = python_observer(progress)};
  const py::gil_scoped_release release;
  return solve(sphere, {.load = load, .angular_speed = angular_speed}, options);
}

/// A field of the result as a read-only array over its memory, [phi][theta].
template <class T>
auto field(std::vector<T> Result::* member) {
  return [member](const py::object& self) {
    const auto& result = self.cast<const Result&>();
    return read_only(result.*member, {result.phi_nodes, result.theta_nodes}, self);
  };
}

}  // namespace

void bind_solve(py::module_& m) {
  py::native_enum<Compliance>(m, "Compliance", "enum.Enum", "The compliance in the contact condition.")
      .value("VERTICAL", Compliance::vertical, "C_WW, the model itself")
      .value("RADIAL", Compliance::radial, "C_RR, the paper's shortcut")
      .finalize();
  py::native_enum<PatchLoad>(m, "PatchLoad", "enum.Enum", "Traction on the patch of a node.")
      .value("FLAT", PatchLoad::flat, "uniform in (phi, theta), equation (53)")
      .value("SPHERICAL", PatchLoad::spherical, "proportional to 1/sin(theta), equation (38)")
      .finalize();
  py::native_enum<Status>(m, "Status", "enum.Enum", "How a solve ended.")
      .value("CONVERGED", Status::converged, "every condition holds")
      .value("MAX_ITERATIONS", Status::max_iterations, "the passes of the active set ran out")
      .value("ACCURACY_NOT_REACHED", Status::accuracy_not_reached, "the finest mesh allowed is not accurate enough")
      .finalize();

  py::classh<Options>(m, "Options")
      .def(py::init<>())
      .def_readonly("accuracy", &Options::accuracy)
      .def_readonly("compliance", &Options::compliance)
      .def_readonly("patch_load", &Options::patch_load)
      .def_readonly("max_iterations", &Options::max_iterations)
      .def_readonly("threads", &Options::threads);

  py::classh<Refinement>(m, "Refinement")
      .def_readonly("mesh", &Refinement::mesh)
      .def_readonly("contact_nodes", &Refinement::contact_nodes)
      .def_readonly("resisting_torque", &Refinement::resisting_torque)
      .def_readonly("penetration", &Refinement::penetration)
      .def_readonly("power_balance_error", &Refinement::power_balance_error)
      .def_readonly("error_estimate", &Refinement::error_estimate);

  py::classh<Result>(m, "Result")
      .def_readonly("status", &Result::status)
      .def_readonly("iterations", &Result::iterations)
      .def_readonly("residual", &Result::residual)
      .def_readonly("resisting_torque", &Result::resisting_torque)
      .def_readonly("rolling_resistance_coefficient", &Result::rolling_resistance_coefficient)
      .def_readonly("center_height", &Result::center_height)
      .def_readonly("penetration", &Result::penetration)
      .def_readonly("semi_axis_x", &Result::semi_axis_x)
      .def_readonly("semi_axis_z", &Result::semi_axis_z)
      .def_readonly("contact_area", &Result::contact_area)
      .def_readonly("max_pressure", &Result::max_pressure)
      .def_readonly("work_torque", &Result::work_torque)
      .def_readonly("dissipated_power", &Result::dissipated_power)
      .def_readonly("power_balance_error", &Result::power_balance_error)
      .def_readonly("centrifugal_displacement", &Result::centrifugal_displacement)
      .def_readonly("mesh", &Result::mesh)
      .def_readonly("error_estimate", &Result::error_estimate)
      .def_readonly("refinements", &Result::refinements)
      .def_property_readonly("x", field(&Result::x))
      .def_property_readonly("z", field(&Result::z))
      .def_property_readonly("pressure", field(&Result::pressure))
      .def_property_readonly("displacement", field(&Result::displacement))
      .def_property_readonly("gap", field(&Result::gap))
      .def_property_readonly("contact", field(&Result::contact));

  m.def("solve", &solve_released, py::arg("sphere"), py::kw_only(), py::arg("load"), py::arg("angular_speed"),
        py::arg("mesh").none(true), py::arg("accuracy"), py::arg("compliance"), py::arg("patch_load"),
        py::arg("max_iterations"), py::arg("threads"), py::arg("progress").none(true));
}

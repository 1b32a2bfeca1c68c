#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include <map>
#include <string>

#include "bindings.hpp"
#include "viscoroll/solve.hpp"

namespace {

using namespace viscoroll;

Options make_options(std::optional<Mesh> mesh, double accuracy, Compliance compliance, Curvature curvature,
                     PatchLoad patch_load, SlipKinematics slip_kinematics, int max_iterations, int threads,
                     const py::object& progress) {
  return {.mesh = mesh,
          .accuracy = accuracy,
          .compliance = compliance,
          .curvature = curvature,
          .patch_load = patch_load,
          .slip_kinematics = slip_kinematics,
          .max_iterations = max_iterations,
          .threads = threads,
          .observer = python_observer(progress)};
}

Result solve_released(const CoatedSphere& sphere, double load, double angular_speed, std::optional<Mesh> mesh,
                      double accuracy, double friction, Drive drive, Compliance compliance, Curvature curvature,
                      PatchLoad patch_load, SlipKinematics slip_kinematics, int max_iterations, int threads,
                      const py::object& progress) {
  const Options options = make_options(mesh, accuracy, compliance, curvature, patch_load, slip_kinematics,
                                       max_iterations, threads, progress);
  const py::gil_scoped_release release;
  return solve(sphere, {.load = load, .angular_speed = angular_speed, .friction = friction, .drive = drive}, options);
}

RollingModel make_model(const CoatedSphere& sphere, double angular_speed, const Mesh& mesh, Curvature curvature,
                        int threads, const py::object& progress) {
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  return {sphere, angular_speed, mesh, threads, curvature, observer};
}

Result solve_on_model(const RollingModel& model, double load, double angular_speed, double friction, Drive drive,
                      Compliance compliance, PatchLoad patch_load, SlipKinematics slip_kinematics, int max_iterations,
                      int threads, const py::object& progress) {
  const Options options = make_options({}, Options{}.accuracy, compliance, Options{}.curvature, patch_load,
                                       slip_kinematics, max_iterations, threads, progress);
  const py::gil_scoped_release release;
  return model.solve({.load = load, .angular_speed = angular_speed, .friction = friction, .drive = drive}, options);
}

/// A field of the result as a read-only array over its memory, [phi][theta].
template <class T>
auto field(std::vector<T> Result::* member) {
  return [member](const py::object& self) {
    const auto& result = self.cast<const Result&>();
    return read_only(result.*member, {result.phi_nodes, result.theta_nodes}, self);
  };
}

/// Vectors along x and z, [component][phi][theta].
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

}  // namespace

void bind_solve(py::module_& m) {
  py::native_enum<Compliance>(m, "Compliance", "enum.Enum", "The compliance in the contact condition.")
      .value("RADIAL", Compliance::radial, "C_RR: pressure along the radius, the one nearer to finite strain")
      .value("VERTICAL", Compliance::vertical, "C_WW: pressure on the normals of the undeformed sphere")
      .finalize();
  py::native_enum<PatchLoad>(m, "PatchLoad", "enum.Enum", "Traction on the patch of a node.")
      .value("FLAT", PatchLoad::flat, "uniform in (phi, theta), equation (53)")
      .value("SPHERICAL", PatchLoad::spherical, "proportional to 1/sin(theta), equation (38)")
      .finalize();
  py::native_enum<Status>(m, "Status", "enum.Enum", "How a solve ended.")
      .value("CONVERGED", Status::converged, "every condition holds")
      .value("MAX_ITERATIONS", Status::max_iterations, "the iterations ran out")
      .value("ACCURACY_NOT_REACHED", Status::accuracy_not_reached, "the finest mesh allowed is not accurate enough")
      .finalize();

  py::native_enum<WarningKind>(m, "WarningKind", "enum.Enum", "What a user should know before relying on a result.")
      .value("MAX_ITERATIONS", WarningKind::max_iterations, "the contact still changed when the iterations ran out")
      .value("ACCURACY_NOT_REACHED", WarningKind::accuracy_not_reached,
             "the error estimate is above what was asked for")
      .value("COARSE_MESH", WarningKind::coarse_mesh, "a given mesh has few nodes across the contact")
      .value("LARGE_STRAIN", WarningKind::large_strain, "beyond what linear theory is good for")
      .finalize();
  py::native_enum<SlipKinematics>(m, "SlipKinematics", "enum.Enum",
                                  "How far material travels between nodes of an undeformed sphere.")
      .value("EXACT", SlipKinematics::exact, "the difference of x = r_o sin(theta) cos(phi)")
      .value("FLAT", SlipKinematics::flat, "r_o times the spacing everywhere, the last form of (55a)")
      .finalize();

  py::classh<DriveForce>(m, "DriveForce").def(py::init<double>(), py::arg("force"));
  py::classh<DriveTorque>(m, "DriveTorque").def(py::init<double>(), py::arg("torque"));
  py::classh<DriveCreepage>(m, "DriveCreepage")
      .def(py::init<double, double>(), py::kw_only(), py::arg("creepage"), py::arg("lateral_creepage"));

  py::classh<Options>(m, "Options")
      .def(py::init<>())
      .def_readonly("accuracy", &Options::accuracy)
      .def_readonly("compliance", &Options::compliance)
      .def_readonly("curvature", &Options::curvature)
      .def_readonly("patch_load", &Options::patch_load)
      .def_readonly("slip_kinematics", &Options::slip_kinematics)
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
      .def_readonly("products", &Result::products)
      .def_readonly("residual", &Result::residual)
      .def_readonly("resisting_torque", &Result::resisting_torque)
      .def_readonly("rolling_resistance_coefficient", &Result::rolling_resistance_coefficient)
      .def_readonly("center_height", &Result::center_height)
      .def_readonly("penetration", &Result::penetration)
      .def_readonly("strain", &Result::strain)
      .def_readonly("model_error", &Result::model_error)
      .def_readonly("semi_axis_x", &Result::semi_axis_x)
      .def_readonly("semi_axis_z", &Result::semi_axis_z)
      .def_readonly("contact_area", &Result::contact_area)
      .def_readonly("max_pressure", &Result::max_pressure)
      .def_readonly("driving_torque", &Result::driving_torque)
      .def_readonly("driving_force", &Result::driving_force)
      .def_readonly("lateral_force", &Result::lateral_force)
      .def_readonly("linear_speed", &Result::linear_speed)
      .def_readonly("creepage", &Result::creepage)
      .def_readonly("bulk_power", &Result::bulk_power)
      .def_readonly("slip_power", &Result::slip_power)
      .def_readonly("dissipated_power", &Result::dissipated_power)
      .def_readonly("power_balance_error", &Result::power_balance_error)
      .def_readonly("centrifugal_displacement", &Result::centrifugal_displacement)
      .def_readonly("mesh", &Result::mesh)
      .def_readonly("error_estimate", &Result::error_estimate)
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

  py::classh<RollingModel>(m, "RollingModel")
      .def(py::init(&make_model), py::arg("sphere"), py::kw_only(), py::arg("angular_speed"), py::arg("mesh"),
           py::arg("curvature"), py::arg("threads"), py::arg("progress").none(true))
      .def("solve", &solve_on_model, py::kw_only(), py::arg("load"), py::arg("angular_speed"), py::arg("friction"),
           py::arg("drive"), py::arg("compliance"), py::arg("patch_load"), py::arg("slip_kinematics"),
           py::arg("max_iterations"), py::arg("threads"), py::arg("progress").none(true));

  m.def("solve", &solve_released, py::arg("sphere"), py::kw_only(), py::arg("load"), py::arg("angular_speed"),
        py::arg("mesh").none(true), py::arg("accuracy"), py::arg("friction"), py::arg("drive"), py::arg("compliance"),
        py::arg("curvature"), py::arg("patch_load"), py::arg("slip_kinematics"), py::arg("max_iterations"),
        py::arg("threads"), py::arg("progress").none(true));
}

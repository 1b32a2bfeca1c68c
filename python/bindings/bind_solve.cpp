#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include <optional>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "bindings.hpp"
#include "viscoroll/solve.hpp"

namespace {

using namespace viscoroll;

/// Return the options with an observer that reports to Python.
Options observed(Options options, const py::object& progress) {
  options.observer = python_observer(progress);
  return options;
}

Result solve_released(const RollingBody& body, const Counterbody& on, const LoadCase& load_case, const Options& options,
                      const py::object& progress) {
  const Options given = observed(options, progress);
  const py::gil_scoped_release release;
  return solve(body, on, load_case, given);
}

template <class T>
std::vector<T> copied(const InputArray<T>& array) {
  const auto values = view(array);
  return {values.begin(), values.end()};
}

Result solve_frozen_released(const RollingBody& body, const Counterbody& on, const LoadCase& load_case,
                             const Options& options, const InputArray<unsigned char>& contact,
                             const InputArray<unsigned char>& stick, const InputArray<double>& pressure,
                             const InputArray<double>& shear_traction, double penetration, double creepage,
                             const py::object& progress) {
  if (contact.ndim() != 2) throw py::value_error("contact must be a two-dimensional array");
  const FrozenContact frozen{.phi_nodes = static_cast<int>(contact.shape(0)),
                             .theta_nodes = static_cast<int>(contact.shape(1)),
                             .contact = copied(contact),
                             .stick = copied(stick),
                             .pressure = copied(pressure),
                             .shear_traction = copied(shear_traction),
                             .penetration = penetration,
                             .creepage = creepage};
  const Options given = observed(options, progress);
  const py::gil_scoped_release release;
  return solve_frozen(body, on, load_case, frozen, given);
}

RollingModel rolling_model(const RollingBody& body, const Counterbody& on, double angular_speed,
                           std::optional<double> speed, const Mesh& mesh, Curvature curvature, int threads,
                           const py::object& progress) {
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  if (speed) return {body, on, GroundSpeed{*speed}, mesh, threads, curvature, observer};
  return {body, on, angular_speed, mesh, threads, curvature, observer};
}

Result solve_on_model(const RollingModel& model, const LoadCase& load_case, const Options& options,
                      const py::object& progress) {
  const Options given = observed(options, progress);
  const py::gil_scoped_release release;
  return model.solve(load_case, given);
}

/// Return the drive whose prescribed quantity is given.
Drive drive_of(const py::KWArgs<py::object>& parameters) {
  const auto read = [&]<class... Kinds>(std::type_identity<std::variant<Kinds...>> /*kinds*/) {
    std::optional<Drive> drive;
    (void)((parameters.contains(std::get<0>(Kinds::fields()).name) &&
            (drive = read_fields<Kinds>(reader_of(parameters)), true)) ||
           ...);
    return drive;
  };
  return read(std::type_identity<Drive>{}).value();
}

}  // namespace

void bind_solve(py::module_& m) {
  py::native_enum<Compliance>(m, "Compliance", "enum.Enum", "Compliance in the contact condition.")
      .value("RADIAL", Compliance::radial, "C_RR: pressure along the radius; closer to finite strain")
      .value("VERTICAL", Compliance::vertical, "C_WW: pressure along the normals of the undeformed sphere")
      .finalize();
  py::native_enum<PatchLoad>(m, "PatchLoad", "enum.Enum", "Traction on the patch of a node.")
      .value("FLAT", PatchLoad::flat, "uniform in (phi, theta), equation (53)")
      .value("SPHERICAL", PatchLoad::spherical, "proportional to 1/sin(theta), equation (38)")
      .finalize();
  py::native_enum<SlipKinematics>(m, "SlipKinematics", "enum.Enum",
                                  "Distance that material travels between nodes of an undeformed sphere.")
      .value("EXACT", SlipKinematics::exact, "the difference of x = r_o sin(theta) cos(phi)")
      .value("FLAT", SlipKinematics::flat, "r_o times the spacing everywhere, the last form of equation (55a)")
      .finalize();

  py::classh<Drive>(m, "Drive").def(py::init(&drive_of));

  bind_fields<LoadCase>(m, "LoadCase");
  bind_fields<Options>(m, "Options");

  py::classh<RollingModel>(m, "RollingModel")
      .def(py::init(&rolling_model), py::arg("body"), py::arg("on"), py::kw_only(), py::arg("angular_speed"),
           py::arg("speed") = py::none(), py::arg("mesh"), py::arg("curvature"), py::arg("threads"),
           py::arg("progress").none(true))
      .def("solve", &solve_on_model, py::arg("load_case"), py::arg("options"), py::kw_only(),
           py::arg("progress").none(true));

  m.def("solve", &solve_released, py::arg("body"), py::arg("on"), py::arg("load_case"), py::arg("options"),
        py::kw_only(), py::arg("progress").none(true));
  m.def("solve_frozen", &solve_frozen_released, py::arg("body"), py::arg("on"), py::arg("load_case"),
        py::arg("options"), py::kw_only(), py::arg("contact").noconvert(), py::arg("stick").noconvert(),
        py::arg("pressure").noconvert(), py::arg("shear_traction").noconvert(), py::arg("penetration"),
        py::arg("creepage"), py::arg("progress").none(true));
}

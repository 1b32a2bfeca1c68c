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

Options make_options(std::optional<Mesh> mesh, double accuracy, Compliance compliance, Curvature curvature,
                     PatchLoad patch_load, SlipKinematics slip_kinematics, bool finite_strain, int max_iterations,
                     int threads, const py::object& progress) {
  return {.mesh = mesh,
          .accuracy = accuracy,
          .compliance = compliance,
          .curvature = curvature,
          .patch_load = patch_load,
          .slip_kinematics = slip_kinematics,
          .finite_strain = finite_strain,
          .max_iterations = max_iterations,
          .threads = threads,
          .observer = python_observer(progress)};
}

Result solve_released(const RollingBody& body, const Counterbody& on, const LoadCase& load_case,
                      std::optional<Mesh> mesh, double accuracy, Compliance compliance, Curvature curvature,
                      PatchLoad patch_load, SlipKinematics slip_kinematics, bool finite_strain, int max_iterations,
                      int threads, const py::object& progress) {
  const Options options = make_options(mesh, accuracy, compliance, curvature, patch_load, slip_kinematics,
                                       finite_strain, max_iterations, threads, progress);
  const py::gil_scoped_release release;
  return solve(body, on, load_case, options);
}

template <class T>
std::vector<T> copied(const InputArray<T>& array) {
  const auto values = view(array);
  return {values.begin(), values.end()};
}

Result solve_frozen_released(const RollingBody& body, const Counterbody& on, const LoadCase& load_case,
                             const Mesh& mesh, Compliance compliance, Curvature curvature, PatchLoad patch_load,
                             const InputArray<unsigned char>& contact, const InputArray<unsigned char>& stick,
                             const InputArray<double>& pressure, const InputArray<double>& shear_traction,
                             double penetration, double creepage, int threads, const py::object& progress) {
  if (contact.ndim() != 2) throw py::value_error("contact must be a two-dimensional array");
  const FrozenContact frozen{.phi_nodes = static_cast<int>(contact.shape(0)),
                             .theta_nodes = static_cast<int>(contact.shape(1)),
                             .contact = copied(contact),
                             .stick = copied(stick),
                             .pressure = copied(pressure),
                             .shear_traction = copied(shear_traction),
                             .penetration = penetration,
                             .creepage = creepage};
  const Options defaults;
  const Options options = make_options(mesh, defaults.accuracy, compliance, curvature, patch_load,
                                       defaults.slip_kinematics, false, defaults.max_iterations, threads, progress);
  const py::gil_scoped_release release;
  return solve_frozen(body, on, load_case, frozen, options);
}

RollingModel rolling_model(const RollingBody& body, const Counterbody& on, double angular_speed,
                           std::optional<double> speed, const Mesh& mesh, Curvature curvature, int threads,
                           const py::object& progress) {
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  if (speed) return {body, on, GroundSpeed{*speed}, mesh, threads, curvature, observer};
  return {body, on, angular_speed, mesh, threads, curvature, observer};
}

Result solve_on_model(const RollingModel& model, const LoadCase& load_case, Compliance compliance, PatchLoad patch_load,
                      SlipKinematics slip_kinematics, bool finite_strain, int max_iterations, int threads,
                      const py::object& progress) {
  const Options options = make_options({}, Options{}.accuracy, compliance, Options{}.curvature, patch_load,
                                       slip_kinematics, finite_strain, max_iterations, threads, progress);
  const py::gil_scoped_release release;
  return model.solve(load_case, options);
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

  py::classh<LoadCase>(m, "LoadCase")
      .def(py::init([](std::optional<double> load, std::optional<double> penetration, double angular_speed,
                       std::optional<double> speed, double friction, Drive drive, std::optional<Adhesion> adhesion,
                       bool pulls_off) {
             return LoadCase{load, penetration, angular_speed, speed, friction, drive, adhesion, pulls_off};
           }),
           py::kw_only(), py::arg("load"), py::arg("penetration"), py::arg("angular_speed"),
           py::arg("speed") = py::none(), py::arg("friction"), py::arg("drive"), py::arg("adhesion") = py::none(),
           py::arg("pulls_off") = false)
      .def_readonly("load", &LoadCase::load)
      .def_readonly("angular_speed", &LoadCase::angular_speed)
      .def_readonly("friction", &LoadCase::friction);

  py::classh<Options>(m, "Options")
      .def(py::init<>())
      .def_readonly("accuracy", &Options::accuracy)
      .def_readonly("compliance", &Options::compliance)
      .def_readonly("curvature", &Options::curvature)
      .def_readonly("patch_load", &Options::patch_load)
      .def_readonly("slip_kinematics", &Options::slip_kinematics)
      .def_readonly("finite_strain", &Options::finite_strain)
      .def_readonly("max_iterations", &Options::max_iterations)
      .def_readonly("threads", &Options::threads);

  py::classh<RollingModel>(m, "RollingModel")
      .def(py::init(&rolling_model), py::arg("body"), py::arg("on"), py::kw_only(), py::arg("angular_speed"),
           py::arg("speed") = py::none(), py::arg("mesh"), py::arg("curvature"), py::arg("threads"),
           py::arg("progress").none(true))
      .def("solve", &solve_on_model, py::arg("load_case"), py::kw_only(), py::arg("compliance"), py::arg("patch_load"),
           py::arg("slip_kinematics"), py::arg("finite_strain"), py::arg("max_iterations"), py::arg("threads"),
           py::arg("progress").none(true));

  m.def("solve", &solve_released, py::arg("body"), py::arg("on"), py::arg("load_case"), py::kw_only(),
        py::arg("mesh").none(true), py::arg("accuracy"), py::arg("compliance"), py::arg("curvature"),
        py::arg("patch_load"), py::arg("slip_kinematics"), py::arg("finite_strain"), py::arg("max_iterations"),
        py::arg("threads"), py::arg("progress").none(true));
  m.def("solve_frozen", &solve_frozen_released, py::arg("body"), py::arg("on"), py::arg("load_case"), py::kw_only(),
        py::arg("mesh"), py::arg("compliance"), py::arg("curvature"), py::arg("patch_load"),
        py::arg("contact").noconvert(), py::arg("stick").noconvert(), py::arg("pressure").noconvert(),
        py::arg("shear_traction").noconvert(), py::arg("penetration"), py::arg("creepage"), py::arg("threads"),
        py::arg("progress").none(true));
}

#include <pybind11/complex.h>
#include <pybind11/native_enum.h>
#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <memory>

#include "bindings.hpp"
#include "viscoroll/cylinder.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/materials.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace {

using namespace viscoroll;
using cplx = std::complex<double>;

/// Return a Python callable as a modulus. The library copies the modulus on threads that do not hold the GIL; therefore
/// a shared pointer holds the callable, and its deleter takes the GIL.
CustomModulus custom_modulus(const py::typing::Callable<py::object(py::array_t<double>)>& function) {
  const std::shared_ptr<py::function> callable(new py::function(function), [](py::function* owned) {
    const py::gil_scoped_acquire gil;
    delete owned;
  });
  return {[callable](std::span<const double> omega, std::span<cplx> modulus) {
    const py::gil_scoped_acquire gil;
    const py::array_t<double> argument(static_cast<py::ssize_t>(omega.size()), omega.data());
    const auto values = py::array_t<cplx, py::array::c_style | py::array::forcecast>::ensure((*callable)(argument));
    if (!values) throw py::type_error("shear_modulus must be a function that returns complex numbers");
    if (values.ndim() != 1 || static_cast<std::size_t>(values.size()) != omega.size()) {
      throw InvalidInput(
          "shear_modulus", "must be a function that returns one value for each frequency",
          "shape " + std::string(py::str(values.attr("shape"))) + " for " + std::to_string(omega.size()));
    }
    std::copy_n(values.data(), omega.size(), modulus.begin());
  }};
}

}  // namespace

void bind_inputs(py::module_& m) {
  py::native_enum<Extrapolation>(m, "Extrapolation", "enum.Enum", "Behavior of a master curve outside its table.")
      .value("ERROR", Extrapolation::error, "raise an error")
      .value("HOLD", Extrapolation::hold, "keep the value at the nearer end of the table")
      .finalize();

  py::classh<Elastic>(m, "Elastic")
      .def(py::init([](double modulus) { return Elastic{modulus}; }), py::kw_only(), py::arg("modulus"));
  py::classh<Prony>(m, "Prony")
      .def(
          py::init([](double instantaneous_modulus, std::vector<double> weights, std::vector<double> relaxation_times) {
            return Prony{instantaneous_modulus, std::move(weights), std::move(relaxation_times)};
          }),
          py::kw_only(), py::arg("instantaneous_modulus"), py::arg("weights"), py::arg("relaxation_times"))
      .def_readonly("instantaneous_modulus", &Prony::instantaneous_modulus)
      .def_readonly("weights", &Prony::weights)
      .def_readonly("relaxation_times", &Prony::relaxation_times);
  m.def("standard_linear_solid", &standard_linear_solid, py::kw_only(), py::arg("instantaneous_modulus"),
        py::arg("relaxed_modulus"), py::arg("relaxation_time"));
  m.def(
      "creep_compliance",
      [](double instantaneous_compliance, const std::vector<double>& compliances,
         const std::vector<double>& retardation_times) {
        return creep_compliance(instantaneous_compliance, compliances, retardation_times);
      },
      py::kw_only(), py::arg("instantaneous_compliance"), py::arg("compliances"), py::arg("retardation_times"));
  py::classh<KelvinVoigt>(m, "KelvinVoigt")
      .def(py::init([](double modulus, double viscosity) { return KelvinVoigt{modulus, viscosity}; }), py::kw_only(),
           py::arg("modulus"), py::arg("viscosity"));
  py::classh<FractionalZener>(m, "FractionalZener")
      .def(py::init([](double instantaneous, double relaxed, double time, double order) {
             return FractionalZener{instantaneous, relaxed, time, order};
           }),
           py::kw_only(), py::arg("instantaneous_modulus"), py::arg("relaxed_modulus"), py::arg("relaxation_time"),
           py::arg("order"));
  py::classh<MasterCurve>(m, "MasterCurve")
      .def(py::init([](std::vector<double> frequency, std::vector<double> storage, std::vector<double> loss,
                       Extrapolation extrapolation) {
             return MasterCurve{std::move(frequency), std::move(storage), std::move(loss), extrapolation};
           }),
           py::kw_only(), py::arg("frequency"), py::arg("storage"), py::arg("loss"), py::arg("extrapolation"));
  py::classh<CustomModulus>(m, "CustomModulus").def(py::init(&custom_modulus), py::arg("function"));

  m.def("validate_modulus", [](const ShearModulus& modulus) { validate(modulus, ""); }, py::arg("modulus"));
  m.def(
      "complex_modulus",
      [](const ShearModulus& modulus, const InputArray<double>& omega) {
        const std::vector<cplx> values = complex_modulus(modulus, view(omega));
        return py::array_t<cplx>(static_cast<py::ssize_t>(values.size()), values.data());
      },
      py::arg("modulus"), py::arg("omega").noconvert());

  py::classh<Layer>(m, "Layer")
      .def(py::init([](double thickness, const ShearModulus& shear_modulus, std::optional<double> poisson_ratio,
                       std::optional<double> bulk_modulus, double density) {
             Layer layer{thickness, shear_modulus, poisson_ratio, bulk_modulus, density};
             validate(layer, "");
             return layer;
           }),
           py::kw_only(), py::arg("thickness"), py::arg("shear_modulus"), py::arg("poisson_ratio").none(true),
           py::arg("bulk_modulus").none(true), py::arg("density"));
  py::native_enum<InnerBoundary>(m, "InnerBoundary", "enum.Enum",
                                 "Boundary condition at the inner surface of the innermost layer.")
#define VISCOROLL_INNER_BOUNDARY(name, NAME, details, is_core, is_free) .value(#NAME, InnerBoundary::name, details)
#include "viscoroll/inner_boundaries.def"
#undef VISCOROLL_INNER_BOUNDARY
      .finalize();
  py::native_enum<Curvature>(m, "Curvature", "enum.Enum", "Curvature terms in the layer equations of a sphere.")
      .value("SPHERE", Curvature::sphere, "the paper's orders with the membrane stiffness of a sphere")
      .value("PAPER", Curvature::paper, "equation (26) as printed")
      .value("EXACT", Curvature::exact, "spherical harmonics in place of the paper's orders")
      .finalize();
  py::classh<CoatedSphere>(m, "CoatedSphere")
      .def(py::init([](double core_radius, std::vector<Layer> layers, InnerBoundary inner_boundary) {
             CoatedSphere sphere{core_radius, std::move(layers), inner_boundary};
             validate(sphere);
             return sphere;
           }),
           py::kw_only(), py::arg("core_radius"), py::arg("layers"), py::arg("inner_boundary"));
  py::classh<CoatedCylinder>(m, "CoatedCylinder")
      .def(py::init([](double core_radius, std::vector<Layer> layers) {
             CoatedCylinder cylinder{core_radius, std::move(layers)};
             validate(cylinder);
             return cylinder;
           }),
           py::kw_only(), py::arg("core_radius"), py::arg("layers"));
  py::native_enum<Hub>(m, "Hub", "enum.Enum", "Shape of the hub under the tread of a crowned wheel.")
      .value("STRAIGHT", Hub::straight, "a cylinder; the tread is thinner at its faces")
      .value("CROWNED", Hub::crowned, "parallel to the crown; the thickness of the layers is constant")
      .finalize();
  py::native_enum<Sides>(m, "Sides", "enum.Enum", "Lateral ends of a tread.")
      .value("FREE", Sides::free, "stress-free faces at half the width, which bulge")
      .value("UNBOUNDED", Sides::unbounded, "no faces; the tread continues, but is loaded only within the width")
      .finalize();
  py::classh<CoatedWheel>(m, "CoatedWheel")
      .def(py::init([](double core_radius, std::vector<Layer> layers, double width, double crown_radius, Hub hub,
                       Sides sides) {
             CoatedWheel wheel{core_radius, std::move(layers), width, crown_radius, hub, sides};
             validate(wheel);
             return wheel;
           }),
           py::kw_only(), py::arg("core_radius"), py::arg("layers"), py::arg("width"), py::arg("crown_radius"),
           py::arg("hub"), py::arg("sides"));
  py::classh<HalfSpace>(m, "HalfSpace")
      .def(py::init([](const ShearModulus& shear_modulus, std::optional<double> poisson_ratio,
                       std::optional<double> bulk_modulus,
                       double density) { return HalfSpace{shear_modulus, poisson_ratio, bulk_modulus, density}; }),
           py::kw_only(), py::arg("shear_modulus"), py::arg("poisson_ratio").none(true),
           py::arg("bulk_modulus").none(true), py::arg("density"));
  py::classh<CoatedPlane>(m, "CoatedPlane")
      .def(py::init([](std::vector<Layer> layers, std::optional<HalfSpace> base) {
             CoatedPlane plane{std::move(layers), std::move(base)};
             validate(plane);
             return plane;
           }),
           py::kw_only(), py::arg("layers"), py::arg("base").none(true));
  py::classh<Groove>(m, "Groove")
      .def(py::init([](std::optional<double> radius, std::optional<double> path_radius, CoatedPlane surface) {
             Groove groove{radius, path_radius, std::move(surface)};
             validate(groove);
             return groove;
           }),
           py::kw_only(), py::arg("radius").none(true), py::arg("path_radius").none(true), py::arg("surface"));
  py::classh<Mesh>(m, "Mesh")
      .def(py::init([](int nodes_per_revolution, std::optional<int> max_order,
                       std::optional<int> theta_nodes_per_revolution) {
             const Mesh mesh{nodes_per_revolution, max_order, theta_nodes_per_revolution};
             validate(mesh);
             return mesh;
           }),
           py::kw_only(), py::arg("nodes_per_revolution"), py::arg("max_order").none(true),
           py::arg("theta_nodes_per_revolution").none(true))
      .def_readonly("nodes_per_revolution", &Mesh::nodes_per_revolution)
      .def_readonly("max_order", &Mesh::max_order)
      .def_readonly("theta_nodes_per_revolution", &Mesh::theta_nodes_per_revolution);
}

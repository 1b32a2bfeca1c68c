#include <pybind11/complex.h>
#include <pybind11/native_enum.h>
#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <variant>

#include "bindings.hpp"
#include "viscoroll/adhesion.hpp"
#include "viscoroll/cylinder.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/materials.hpp"
#include "viscoroll/mesh.hpp"
#include "viscoroll/modulus_functions.hpp"
#include "viscoroll/modulus_types.hpp"
#include "viscoroll/plane.hpp"
#include "viscoroll/profile.hpp"
#include "viscoroll/rolling_history.hpp"
#include "viscoroll/slow_terms.hpp"
#include "viscoroll/sphere.hpp"
#include "viscoroll/wheel.hpp"

namespace {

using namespace viscoroll;
using cplx = std::complex<double>;
using Frequencies = py::typing::Callable<py::object(py::array_t<double>)>;

/// Return a Python callable as a modulus. The library copies the modulus on threads that do not hold the GIL; therefore
/// a shared pointer holds the callable, and its deleter takes the GIL.
CustomModulus custom_modulus(const Frequencies& function) {
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

ShearModulus modulus_of(const std::string& type, const py::KWArgs<py::object>& parameters) {
  const MadeModulus made = read_modulus(type, reader_of(parameters));
  if (!made) throw InvalidInput("type", "must be a type of modulus", type);
  ShearModulus modulus = made();
  validate(modulus, "");
  return modulus;
}

/// Return the points of the shape of a type.
template <class... Shapes>
HeightProfile profile_of_type(const std::string& type, const py::KWArgs<py::object>& parameters,
                              std::type_identity<std::variant<Shapes...>> /*shapes*/) {
  std::optional<HeightProfile> profile;
  const auto read = [&]<class Shape>(std::type_identity<Shape> /*shape*/) {
    if (type == Shape::type) profile = profile_of(read_fields<Shape>(reader_of(parameters)));
  };
  (read(std::type_identity<Shapes>{}), ...);
  if (!profile) throw InvalidInput("type", "must be a type of profile", type);
  return *std::move(profile);
}

py::typing::Dict<py::str, py::object> parameters_of(const ShearModulus& modulus) {
  py::typing::Dict<py::str, py::object> parameters;
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.fields(); }) {
          std::apply([&](const auto&... field) { ((parameters[field.name] = kind.*field.member), ...); },
                     kind.fields());
        }
      },
      modulus);
  return parameters;
}

/// Bind a struct with a constructor that has a keyword for each field, and checks the values.
template <class Struct, class Check>
py::classh<Struct> bind_struct(py::module_& m, const char* name, const Check& check) {
  return std::apply(
      [&]<class... Values>(const Field<Struct, Values>&... field) {
        const auto made = [check](Values... values) {
          Struct value;
          std::apply([&](const auto&... own) { ((value.*own.member = std::move(values)), ...); }, Struct::fields());
          check(value);
          return value;
        };
        return py::classh<Struct>(m, name).def(py::init(made), py::kw_only(), py::arg(field.name)...);
      },
      Struct::fields());
}

}  // namespace

void bind_inputs(py::module_& m) {
  const auto check = [](const auto& value) { validate(value); };

  py::native_enum<Extrapolation>(m, "Extrapolation", "enum.Enum", "Behavior of a master curve outside its table.")
      .value("ERROR", Extrapolation::error, "raise an error")
      .value("HOLD", Extrapolation::hold, "keep the value at the nearer end of the table")
      .finalize();

  py::native_enum<ShoreScale>(m, "ShoreScale", "enum.Enum", "Scale of a Shore durometer.")
      .value("A", ShoreScale::a, "for soft rubbers")
      .value("D", ShoreScale::d, "for hard rubbers and plastics")
      .finalize();
  const auto bounds = [](const Estimate& found) { return std::tuple{found.value, found.lower, found.upper}; };
  m.def(
      "hardness_to_modulus",
      [bounds](double hardness, ShoreScale scale) { return bounds(hardness_to_modulus(hardness, scale)); },
      py::arg("hardness"), py::arg("scale"));
  m.def(
      "rebound_to_loss_factor", [bounds](double rebound) { return bounds(rebound_to_loss_factor(rebound)); },
      py::arg("rebound"));

  py::classh<ShearModulus>(m, "ShearModulus")
      .def(py::init(&modulus_of), py::arg("type"))
      .def("parameters", &parameters_of);
  m.def(
      "custom_modulus", [](const Frequencies& function) { return ShearModulus(custom_modulus(function)); },
      py::arg("function"));
  m.def(
      "complex_modulus",
      [](const ShearModulus& modulus, const InputArray<double>& omega) {
        const std::vector<cplx> values = complex_modulus(modulus, view(omega));
        return py::array_t<cplx>(static_cast<py::ssize_t>(values.size()), values.data());
      },
      py::arg("modulus"), py::arg("omega").noconvert());
  m.def(
      "modulus_in_rolling",
      [](const ShearModulus& modulus, double angular_speed, const InputArray<double>& omega) {
        const std::vector<cplx> values = modulus_in_rolling(modulus, angular_speed, view(omega));
        return py::array_t<cplx>(static_cast<py::ssize_t>(values.size()), values.data());
      },
      py::arg("modulus"), py::arg("angular_speed"), py::arg("omega").noconvert());

  bind_struct<HeightProfile>(m, "HeightProfile", check)
      .def_readonly("distance", &HeightProfile::distance)
      .def_readonly("height", &HeightProfile::height)
      .def_readonly("periodic", &HeightProfile::periodic)
      .def(
          "height_at",
          [](const HeightProfile& profile, const InputArray<double>& distance) {
            py::array_t<double> heights(distance.size());
            std::ranges::transform(view(distance), heights.mutable_data(),
                                   [&](double at) { return height_at(profile, at); });
            return heights;
          },
          py::arg("distance").noconvert());
  m.def(
      "profile_of",
      [](const std::string& type, const py::KWArgs<py::object>& parameters) {
        return profile_of_type(type, parameters, std::type_identity<ProfileShape>{});
      },
      py::arg("type"));
  bind_struct<Axle>(m, "Axle", check);
  bind_struct<Adhesion>(m, "Adhesion", check);

  bind_struct<Layer>(m, "Layer", [](const Layer& layer) { validate(layer, ""); });
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
  bind_struct<CoatedSphere>(m, "CoatedSphere", check);
  bind_struct<CoatedCylinder>(m, "CoatedCylinder", check);
  py::native_enum<Hub>(m, "Hub", "enum.Enum", "Shape of the hub under the tread of a crowned wheel.")
      .value("STRAIGHT", Hub::straight, "a cylinder; the tread is thinner at its faces")
      .value("CROWNED", Hub::crowned, "parallel to the crown; the thickness of the layers is constant")
      .finalize();
  py::native_enum<Sides>(m, "Sides", "enum.Enum", "Lateral ends of a tread.")
      .value("FREE", Sides::free, "stress-free faces at half the width, which bulge")
      .value("UNBOUNDED", Sides::unbounded, "no faces; the tread continues, but is loaded only within the width")
      .finalize();
  bind_struct<CoatedWheel>(m, "CoatedWheel", check);
  bind_struct<HalfSpace>(m, "HalfSpace", [](const HalfSpace&) {});  // a plane checks its base
  bind_struct<CoatedPlane>(m, "CoatedPlane", check);
  bind_struct<Groove>(m, "Groove", check);
  bind_struct<Mesh>(m, "Mesh", check)
      .def_readonly("nodes_per_revolution", &Mesh::nodes_per_revolution)
      .def_readonly("max_order", &Mesh::max_order)
      .def_readonly("theta_nodes_per_revolution", &Mesh::theta_nodes_per_revolution);
}

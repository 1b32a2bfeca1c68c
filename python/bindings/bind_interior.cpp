#include <pybind11/complex.h>
#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <algorithm>

#include "bindings.hpp"
#include "viscoroll/interior.hpp"

namespace {

using namespace viscoroll;
using cplx = std::complex<double>;

Tractions make_tractions(const Mesh& mesh, const InputArray<double>& pressure, const InputArray<double>& shear_traction,
                         bool friction, Compliance compliance, Curvature curvature, PatchLoad patch_load) {
  if (pressure.ndim() != 2) throw py::value_error("pressure must have the dimensions phi and theta");
  const auto normal = view(pressure);
  const auto shear = view(shear_traction);
  return {.mesh = mesh,
          .phi_nodes = static_cast<int>(pressure.shape(0)),
          .theta_nodes = static_cast<int>(pressure.shape(1)),
          .pressure = {normal.begin(), normal.end()},
          .shear_traction = {shear.begin(), shear.end()},
          .friction = friction,
          .compliance = compliance,
          .curvature = curvature,
          .patch_load = patch_load};
}

/// Places as two arrays: radii, and numbers of layers.
std::vector<Place> places_from(const InputArray<double>& radius, const InputArray<int>& layer) {
  if (radius.size() != layer.size()) throw py::value_error("radius and layer must be of one length");
  std::vector<Place> places;
  for (py::ssize_t i = 0; i < radius.size(); ++i) places.push_back({.radius = radius.at(i), .layer = layer.at(i)});
  return places;
}

/// Radii and numbers of layers.
using PlaceArrays = py::typing::Tuple<py::array_t<double>, py::array_t<int>>;

PlaceArrays to_arrays(const std::vector<Place>& places) {
  const auto count = static_cast<py::ssize_t>(places.size());
  py::array_t<double> radius(count);
  py::array_t<int> layer(count);
  for (py::ssize_t i = 0; i < count; ++i) {
    radius.mutable_at(i) = places[static_cast<std::size_t>(i)].radius;
    layer.mutable_at(i) = places[static_cast<std::size_t>(i)].layer;
  }
  return PlaceArrays(py::make_tuple(radius, layer));
}

py::array_t<double> to_array(const std::vector<double>& values, const std::vector<py::ssize_t>& shape) {
  py::array_t<double> array(shape);
  std::ranges::copy(values, array.mutable_data());
  return array;
}

py::array_t<cplx> order_fields_array(const CoatedSphere& sphere, const InputArray<int>& m, const InputArray<int>& n,
                                     const InputArray<double>& radius, const InputArray<int>& layer,
                                     double angular_speed, Curvature curvature) {
  const auto orders_m = view(m);
  const auto orders_n = view(n);
  const auto places = places_from(radius, layer);
  std::vector<cplx> values;
  {
    const Observer observer = python_observer(py::none());
    const py::gil_scoped_release release;
    values = order_fields(sphere, angular_speed, orders_m, orders_n, places, curvature, observer);
  }
  py::array_t<cplx> array({m.size(), radius.size(), static_cast<py::ssize_t>(kFieldComponents), py::ssize_t{3}});
  std::ranges::copy(values, array.mutable_data());
  return array;
}

py::array_t<double> interior_fields_array(const CoatedSphere& sphere, const Tractions& tractions,
                                          const InputArray<double>& radius, const InputArray<int>& layer,
                                          const InputArray<double>& phi, const InputArray<double>& theta,
                                          double angular_speed, int threads, const py::object& progress) {
  const auto places = places_from(radius, layer);
  const auto rows = view(phi);
  const auto columns = view(theta);
  InteriorFields fields;
  {
    const Observer observer = python_observer(progress);
    const py::gil_scoped_release release;
    fields = interior_fields(sphere, angular_speed, tractions, places, rows, columns, threads, observer);
  }
  return to_array(fields.values, {radius.size(), static_cast<py::ssize_t>(kFieldComponents), phi.size(), theta.size()});
}

LossDensity loss_released(const CoatedSphere& sphere, const Tractions& tractions, const InputArray<double>& radius,
                          const InputArray<int>& layer, double angular_speed, int max_order, int threads,
                          const py::object& progress) {
  const auto places = places_from(radius, layer);
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  return loss_density(sphere, angular_speed, tractions, places, max_order, threads, observer);
}

}  // namespace

void bind_interior(py::module_& m) {
  py::classh<Tractions>(m, "Tractions")
      .def(py::init(&make_tractions), py::kw_only(), py::arg("mesh"), py::arg("pressure").noconvert(),
           py::arg("shear_traction").noconvert(), py::arg("friction"), py::arg("compliance"), py::arg("curvature"),
           py::arg("patch_load"));

  py::classh<LossDensity>(m, "LossDensity")
      .def_property_readonly("places", [](const LossDensity& loss) { return to_arrays(loss.places); })
      .def_property_readonly("radial_weights",
                             [](const LossDensity& loss) {
                               return to_array(loss.radial_weights,
                                               {static_cast<py::ssize_t>(loss.radial_weights.size())});
                             })
      .def_property_readonly(
          "theta",
          [](const LossDensity& loss) { return to_array(loss.theta, {static_cast<py::ssize_t>(loss.theta.size())}); })
      .def_property_readonly("density",
                             [](const LossDensity& loss) {
                               return to_array(loss.density, {static_cast<py::ssize_t>(loss.places.size()),
                                                              static_cast<py::ssize_t>(loss.theta.size())});
                             })
      .def_property_readonly("order_power",
                             [](const LossDensity& loss) {
                               return to_array(loss.order_power, {static_cast<py::ssize_t>(loss.order_power.size())});
                             })
      .def_readonly("volume_power", &LossDensity::volume_power)
      .def_readonly("surface_power", &LossDensity::surface_power);

  m.def(
      "places_at",
      [](const CoatedSphere& sphere, const InputArray<double>& radius) {
        return to_arrays(places_at(sphere, view(radius)));
      },
      py::arg("sphere"), py::arg("radius").noconvert());
  m.def("order_fields", &order_fields_array, py::arg("sphere"), py::arg("m").noconvert(), py::arg("n").noconvert(),
        py::kw_only(), py::arg("radius").noconvert(), py::arg("layer").noconvert(), py::arg("angular_speed"),
        py::arg("curvature"));
  m.def("interior_fields", &interior_fields_array, py::arg("sphere"), py::arg("tractions"), py::kw_only(),
        py::arg("radius").noconvert(), py::arg("layer").noconvert(), py::arg("phi").noconvert(),
        py::arg("theta").noconvert(), py::arg("angular_speed"), py::arg("threads"), py::arg("progress").none(true));
  m.def("loss_density", &loss_released, py::arg("sphere"), py::arg("tractions"), py::kw_only(),
        py::arg("radius").noconvert(), py::arg("layer").noconvert(), py::arg("angular_speed"), py::arg("max_order"),
        py::arg("threads"), py::arg("progress").none(true));
}

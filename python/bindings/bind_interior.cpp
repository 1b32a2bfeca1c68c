#include <pybind11/complex.h>
#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <algorithm>
#include <optional>

#include "bindings.hpp"
#include "viscoroll/interior.hpp"

namespace {

using namespace viscoroll;
using cplx = std::complex<double>;

Tractions make_tractions(const Mesh& mesh, double radius, std::optional<double> theta_spacing,
                         std::optional<double> crown_radius, bool line, const InputArray<double>& pressure,
                         const InputArray<double>& shear_traction, bool friction, Compliance compliance,
                         Curvature curvature, PatchLoad patch_load, bool counterbody,
                         std::array<double, 2> counterbody_curvature) {
  if (pressure.ndim() != 2) throw py::value_error("pressure must have the dimensions phi and theta");
  const auto normal = view(pressure);
  const auto shear = view(shear_traction);
  return {.mesh = mesh,
          .radius = radius,
          .theta_spacing = theta_spacing,
          .crown_radius = crown_radius,
          .line = line,
          .phi_nodes = static_cast<int>(pressure.shape(0)),
          .theta_nodes = static_cast<int>(pressure.shape(1)),
          .pressure = {normal.begin(), normal.end()},
          .shear_traction = {shear.begin(), shear.end()},
          .friction = friction,
          .compliance = compliance,
          .curvature = curvature,
          .patch_load = patch_load,
          .counterbody = counterbody,
          .counterbody_curvature = counterbody_curvature};
}

/// Return places from two arrays, the positions and the indices of the layers.
std::vector<Place> places_from(const InputArray<double>& position, const InputArray<int>& layer) {
  if (position.size() != layer.size()) throw py::value_error("position and layer must have the same length");
  std::vector<Place> places;
  places.reserve(static_cast<std::size_t>(position.size()));
  for (py::ssize_t i = 0; i < position.size(); ++i) {
    places.push_back({.position = position.at(i), .layer = layer.at(i)});
  }
  return places;
}

/// Positions and indices of the layers.
using PlaceArrays = py::typing::Tuple<py::array_t<double>, py::array_t<int>>;

PlaceArrays to_arrays(const std::vector<Place>& places) {
  const auto count = static_cast<py::ssize_t>(places.size());
  py::array_t<double> position(count);
  py::array_t<int> layer(count);
  for (py::ssize_t i = 0; i < count; ++i) {
    position.mutable_at(i) = places[static_cast<std::size_t>(i)].position;
    layer.mutable_at(i) = places[static_cast<std::size_t>(i)].layer;
  }
  return {py::make_tuple(position, layer)};
}

py::array_t<double> to_array(const std::vector<double>& values, const std::vector<py::ssize_t>& shape) {
  py::array_t<double> array(shape);
  std::ranges::copy(values, array.mutable_data());
  return array;
}

py::array_t<double> to_line(const std::vector<double>& values) {
  return to_array(values, {static_cast<py::ssize_t>(values.size())});
}

py::array_t<cplx> order_fields_array(const LayeredShape& shape, const InputArray<int>& m, const InputArray<int>& n,
                                     const InputArray<double>& position, const InputArray<int>& layer,
                                     double angular_speed, double radius, Curvature curvature) {
  const auto orders_m = view(m);
  const auto orders_n = view(n);
  const auto places = places_from(position, layer);
  std::vector<cplx> values;
  {
    const Observer observer = python_observer(py::none());
    const py::gil_scoped_release release;
    values = order_fields(shape, angular_speed, orders_m, orders_n, places, radius, curvature, observer);
  }
  py::array_t<cplx> array({m.size(), position.size(), static_cast<py::ssize_t>(kFieldComponents), py::ssize_t{3}});
  std::ranges::copy(values, array.mutable_data());
  return array;
}

py::array_t<double> interior_fields_array(const LayeredShape& shape, const Tractions& tractions,
                                          const InputArray<double>& position, const InputArray<int>& layer,
                                          const InputArray<double>& phi, const InputArray<double>& theta,
                                          double angular_speed, std::optional<double> max_order, int threads,
                                          const py::object& progress) {
  const auto places = places_from(position, layer);
  const auto rows = view(phi);
  const auto columns = view(theta);
  InteriorFields fields;
  {
    const Observer observer = python_observer(progress);
    const py::gil_scoped_release release;
    fields = interior_fields(shape, angular_speed, tractions, places, rows, columns, max_order, threads, observer);
  }
  return to_array(fields.values,
                  {position.size(), static_cast<py::ssize_t>(kFieldComponents), phi.size(), theta.size()});
}

LossDensity loss_released(const LayeredShape& shape, const Tractions& tractions, const InputArray<double>& position,
                          const InputArray<int>& layer, double angular_speed, int max_order, int threads,
                          const py::object& progress) {
  const auto places = places_from(position, layer);
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  return loss_density(shape, angular_speed, tractions, places, max_order, threads, observer);
}

}  // namespace

void bind_interior(py::module_& m) {
  py::classh<Tractions>(m, "Tractions")
      .def(py::init(&make_tractions), py::kw_only(), py::arg("mesh"), py::arg("radius"),
           py::arg("theta_spacing").none(true), py::arg("crown_radius").none(true), py::arg("line"),
           py::arg("pressure").noconvert(), py::arg("shear_traction").noconvert(), py::arg("friction"),
           py::arg("compliance"), py::arg("curvature"), py::arg("patch_load"), py::arg("counterbody"),
           py::arg("counterbody_curvature"));

  py::classh<LossDensity>(m, "LossDensity")
      .def_property_readonly("places", [](const LossDensity& loss) { return to_arrays(loss.places); })
      .def_property_readonly("weights", [](const LossDensity& loss) { return to_line(loss.weights); })
      .def_property_readonly("theta", [](const LossDensity& loss) { return to_line(loss.theta); })
      .def_property_readonly("orders", [](const LossDensity& loss) { return to_line(loss.orders); })
      .def_property_readonly("density",
                             [](const LossDensity& loss) {
                               return to_array(loss.density, {static_cast<py::ssize_t>(loss.places.size()),
                                                              static_cast<py::ssize_t>(loss.theta.size())});
                             })
      .def_property_readonly("order_power", [](const LossDensity& loss) { return to_line(loss.order_power); })
      .def_readonly("volume_power", &LossDensity::volume_power)
      .def_readonly("surface_power", &LossDensity::surface_power);

  m.def(
      "places_at",
      [](const LayeredShape& shape, const InputArray<double>& position) {
        return to_arrays(places_at(shape, view(position)));
      },
      py::arg("shape"), py::arg("position").noconvert());
  m.def("order_fields", &order_fields_array, py::arg("shape"), py::arg("m").noconvert(), py::arg("n").noconvert(),
        py::kw_only(), py::arg("position").noconvert(), py::arg("layer").noconvert(), py::arg("angular_speed"),
        py::arg("radius"), py::arg("curvature"));
  m.def("interior_fields", &interior_fields_array, py::arg("shape"), py::arg("tractions"), py::kw_only(),
        py::arg("position").noconvert(), py::arg("layer").noconvert(), py::arg("phi").noconvert(),
        py::arg("theta").noconvert(), py::arg("angular_speed"), py::arg("max_order").none(true), py::arg("threads"),
        py::arg("progress").none(true));
  m.def("loss_density", &loss_released, py::arg("shape"), py::arg("tractions"), py::kw_only(),
        py::arg("position").noconvert(), py::arg("layer").noconvert(), py::arg("angular_speed"), py::arg("max_order"),
        py::arg("threads"), py::arg("progress").none(true));
}

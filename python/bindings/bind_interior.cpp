#include <pybind11/complex.h>
#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include <algorithm>
#include <optional>

#include "bindings.hpp"
#include "viscoroll/interior.hpp"
#include "viscoroll/sliding_interior.hpp"

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

SlidingTractions make_sliding_tractions(const InputArray<double>& pressure, double spacing_x, double spacing_z,
                                        bool periodic, double friction) {
  if (pressure.ndim() != 2) throw py::value_error("pressure must have the dimensions x and z");
  const auto values = view(pressure);
  return {.rows = static_cast<int>(pressure.shape(0)),
          .columns = static_cast<int>(pressure.shape(1)),
          .spacing_x = spacing_x,
          .spacing_z = spacing_z,
          .periodic = periodic,
          .pressure = {values.begin(), values.end()},
          .friction = friction};
}

py::array_t<double> sliding_fields_array(const CoatedPlane& on, const SlidingTractions& tractions,
                                         const InputArray<double>& position, const InputArray<int>& layer,
                                         const InputArray<double>& x, const InputArray<double>& z, double speed,
                                         int threads, const py::object& progress) {
  const auto places = places_from(position, layer);
  const auto rows = view(x);
  const auto columns = view(z);
  SlidingFields fields;
  {
    const Observer observer = python_observer(progress);
    const py::gil_scoped_release release;
    fields = sliding_fields(on, speed, tractions, places, rows, columns, threads, observer);
  }
  return to_array(fields.values, {position.size(), static_cast<py::ssize_t>(kFieldComponents), x.size(), z.size()});
}

SlidingLoss sliding_loss_released(const CoatedPlane& on, const SlidingTractions& tractions,
                                  const InputArray<double>& position, const InputArray<int>& layer, double speed,
                                  double shortest_wave, int threads, const py::object& progress) {
  const auto places = places_from(position, layer);
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  return sliding_loss(on, speed, tractions, places, shortest_wave, threads, observer);
}

/// Bind a loss: its places, densities over places and positions across, and powers.
template <class Loss>
py::classh<Loss> bind_loss(py::module_& m, const char* name, const char* across,
                           std::vector<double> Loss::* positions) {
  py::classh<Loss> type(m, name);
  type.def_property_readonly("places", [](const Loss& loss) { return to_arrays(loss.places); })
      .def_property_readonly(across, [positions](const Loss& loss) { return to_line(loss.*positions); })
      .def_property_readonly("density",
                             [positions](const Loss& loss) {
                               return to_array(loss.density, {static_cast<py::ssize_t>(loss.places.size()),
                                                              static_cast<py::ssize_t>((loss.*positions).size())});
                             })
      .def_readonly("volume_power", &Loss::volume_power)
      .def_readonly("surface_power", &Loss::surface_power);
  return type;
}

}  // namespace

void bind_interior(py::module_& m) {
  py::classh<Tractions>(m, "Tractions")
      .def(py::init(&make_tractions), py::kw_only(), py::arg("mesh"), py::arg("radius"),
           py::arg("theta_spacing").none(true), py::arg("crown_radius").none(true), py::arg("line"),
           py::arg("pressure").noconvert(), py::arg("shear_traction").noconvert(), py::arg("friction"),
           py::arg("compliance"), py::arg("curvature"), py::arg("patch_load"), py::arg("counterbody"),
           py::arg("counterbody_curvature"));

  bind_loss(m, "LossDensity", "theta", &LossDensity::theta)
      .def_property_readonly("weights", [](const LossDensity& loss) { return to_line(loss.weights); })
      .def_property_readonly("orders", [](const LossDensity& loss) { return to_line(loss.orders); })
      .def_property_readonly("order_power", [](const LossDensity& loss) { return to_line(loss.order_power); });

  py::classh<SlidingTractions>(m, "SlidingTractions")
      .def(py::init(&make_sliding_tractions), py::kw_only(), py::arg("pressure").noconvert(), py::arg("spacing_x"),
           py::arg("spacing_z"), py::arg("periodic"), py::arg("friction"));
  bind_loss(m, "SlidingLoss", "z", &SlidingLoss::z)
      .def_readonly("track_distance", &SlidingLoss::track_distance)
      .def_property_readonly("frequency", [](const SlidingLoss& loss) { return to_line(loss.frequency); })
      .def_property_readonly("wave_power", [](const SlidingLoss& loss) { return to_line(loss.wave_power); });

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
  m.def("sliding_fields", &sliding_fields_array, py::arg("on"), py::arg("tractions"), py::kw_only(),
        py::arg("position").noconvert(), py::arg("layer").noconvert(), py::arg("x").noconvert(),
        py::arg("z").noconvert(), py::arg("speed"), py::arg("threads"), py::arg("progress").none(true));
  m.def("sliding_loss", &sliding_loss_released, py::arg("on"), py::arg("tractions"), py::kw_only(),
        py::arg("position").noconvert(), py::arg("layer").noconvert(), py::arg("speed"), py::arg("shortest_wave"),
        py::arg("threads"), py::arg("progress").none(true));
}

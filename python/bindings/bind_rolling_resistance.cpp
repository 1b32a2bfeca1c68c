#include <pybind11/stl.h>

#include <array>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "viscoroll/rolling_resistance.hpp"

namespace {

using namespace viscoroll;

RollingResistance make_surface(std::array<double, 2> load, std::array<double, 2> angular_speed, double radius,
                               std::vector<std::vector<double>> coefficients, double error, double largest_error) {
  RollingResistance surface{load, angular_speed, radius, std::move(coefficients), error, largest_error};
  validate(surface);
  return surface;
}

py::array_t<double> torques(const RollingResistance& surface, const InputArray<double>& load,
                            const InputArray<double>& angular_speed, Extrapolation outside) {
  const auto loads = view(load);
  const auto speeds = view(angular_speed);
  if (loads.size() != speeds.size()) throw py::value_error("load and angular_speed must have the same length");
  py::array_t<double> found(load.size());
  double* torque = found.mutable_data();
  for (std::size_t i = 0; i < loads.size(); ++i) torque[i] = resisting_torque(surface, loads[i], speeds[i], outside);
  return found;
}

}  // namespace

void bind_rolling_resistance(py::module_& m) {
  py::classh<RollingResistance>(m, "RollingResistance")
      .def(py::init(&make_surface), py::kw_only(), py::arg("load"), py::arg("angular_speed"), py::arg("radius"),
           py::arg("coefficients"), py::arg("error"), py::arg("largest_error"))
      .def_readonly("load", &RollingResistance::load)
      .def_readonly("angular_speed", &RollingResistance::angular_speed)
      .def_readonly("radius", &RollingResistance::radius)
      .def_readonly("coefficients", &RollingResistance::coefficients)
      .def_readonly("error", &RollingResistance::error)
      .def_readonly("largest_error", &RollingResistance::largest_error)
      .def("torques", &torques, py::arg("load").noconvert(), py::arg("angular_speed").noconvert(), py::arg("outside"));
}

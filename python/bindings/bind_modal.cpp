#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>

#include "bindings.hpp"
#include "viscoroll/cylinder.hpp"
#include "viscoroll/influence.hpp"
#include "viscoroll/modal.hpp"
#include "viscoroll/wheel.hpp"

namespace {

using namespace viscoroll;
using cplx = std::complex<double>;

py::array_t<cplx> as_array(const std::vector<ComplexMatrix3>& compliances) {
  py::array_t<cplx> result({static_cast<py::ssize_t>(compliances.size()), py::ssize_t{3}, py::ssize_t{3}});
  cplx* out = result.mutable_data();
  for (const ComplexMatrix3& compliance : compliances) out = std::ranges::copy(compliance, out).out;
  return result;
}

py::array_t<cplx> degree_compliance_array(const CoatedSphere& sphere, const InputArray<int>& degree,
                                          const InputArray<int>& order, double angular_speed) {
  const auto degrees = view(degree);
  const auto orders = view(order);
  std::vector<ComplexMatrix3> compliances;
  {
    const Observer observer = python_observer(py::none());
    const py::gil_scoped_release release;
    compliances = degree_compliance(sphere, angular_speed, degrees, orders, observer);
  }
  return as_array(compliances);
}

py::array_t<cplx> surface_compliance_array(const CoatedSphere& sphere, const InputArray<int>& m,
                                           const InputArray<int>& n, double angular_speed, Curvature curvature) {
  const auto orders_m = view(m);
  const auto orders_n = view(n);
  std::vector<ComplexMatrix3> compliances;
  {
    const Observer observer = python_observer(py::none());
    const py::gil_scoped_release release;
    compliances = surface_compliance(sphere, angular_speed, orders_m, orders_n, curvature, observer);
  }
  return as_array(compliances);
}

py::array_t<cplx> wheel_compliance_array(const CoatedWheel& wheel, const InputArray<int>& m,
                                         const InputArray<double>& k, double angular_speed) {
  const auto orders = view(m);
  const auto wave_numbers = view(k);
  std::vector<ComplexMatrix3> compliances;
  {
    const py::gil_scoped_release release;
    compliances = surface_compliance(wheel, angular_speed, orders, wave_numbers);
  }
  return as_array(compliances);
}

py::array_t<double> influence_tables_array(const CoatedSphere& sphere, const Mesh& mesh, double angular_speed,
                                           int phi_reach, int theta_reach, int threads, Curvature curvature,
                                           const py::object& progress) {
  InfluenceTables tables;
  {
    const Observer observer = python_observer(progress);
    const py::gil_scoped_release release;
    tables = influence_tables(sphere, angular_speed, mesh, phi_reach, theta_reach, threads, curvature, observer);
  }
  py::array_t<double> result({3, 3, 2 * phi_reach + 1, 2 * theta_reach + 1});
  std::ranges::copy(tables.values, result.mutable_data());
  return result;
}

}  // namespace

void bind_modal(py::module_& m) {
  m.def("degree_compliance", &degree_compliance_array, py::arg("sphere"), py::arg("degree").noconvert(),
        py::arg("order").noconvert(), py::kw_only(), py::arg("angular_speed"));
  m.def("surface_compliance", &surface_compliance_array, py::arg("sphere"), py::arg("m").noconvert(),
        py::arg("n").noconvert(), py::kw_only(), py::arg("angular_speed"), py::arg("curvature"));
  m.def("surface_compliance", &wheel_compliance_array, py::arg("wheel"), py::arg("m").noconvert(),
        py::arg("k").noconvert(), py::kw_only(), py::arg("angular_speed"));
  m.def(
      "state_matrix",
      [](const Layer& layer, double angular_speed, double radius, int order_m, int order_n, Curvature curvature) {
        const ComplexMatrix6 matrix = state_matrix(layer, angular_speed, radius, order_m, order_n, curvature);
        return py::array_t<cplx>({6, 6}, matrix.data());
      },
      py::arg("layer"), py::kw_only(), py::arg("angular_speed"), py::arg("radius"), py::arg("m"), py::arg("n"),
      py::arg("curvature"));
  m.def("centrifugal_displacement", &centrifugal_displacement, py::arg("sphere"), py::kw_only(),
        py::arg("angular_speed"), py::call_guard<py::gil_scoped_release>());
  m.def("critical_speed", py::overload_cast<const CoatedSphere&, double, Curvature>(&critical_speed), py::arg("sphere"),
        py::kw_only(), py::arg("highest_frequency"), py::arg("curvature"), py::call_guard<py::gil_scoped_release>());
  m.def("critical_speed", py::overload_cast<const CoatedCylinder&, double>(&critical_speed), py::arg("cylinder"),
        py::kw_only(), py::arg("highest_frequency"), py::call_guard<py::gil_scoped_release>());
  m.def("critical_speed", py::overload_cast<const CoatedWheel&, double>(&critical_speed), py::arg("wheel"),
        py::kw_only(), py::arg("highest_frequency"), py::call_guard<py::gil_scoped_release>());
  m.def("influence_tables", &influence_tables_array, py::arg("sphere"), py::arg("mesh"), py::kw_only(),
        py::arg("angular_speed"), py::arg("phi_reach"), py::arg("theta_reach"), py::arg("threads"),
        py::arg("curvature"), py::arg("progress").none(true));
}

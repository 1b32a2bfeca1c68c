#include <pybind11/pybind11.h>

#include <exception>
#include <utility>

#include "bindings.hpp"
#include "viscoroll/cores.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/version.hpp"

PYBIND11_MODULE(_core, m, py::mod_gil_not_used()) {
  m.doc() = "C++ core of viscoroll; use the package viscoroll instead.";
  m.attr("__version__") = viscoroll::kVersion;
  m.attr("__fft__") = viscoroll::kFft;
  m.attr("__commit__") = VISCOROLL_COMMIT;
  py::register_exception<viscoroll::ConvergenceError>(m, "ConvergenceError", PyExc_RuntimeError).attr("__doc__") =
      "An iteration ended without a usable result.";
  // The Python class has the same attributes; it is defined in Python for its documentation and for pickle.
  py::register_local_exception_translator([](std::exception_ptr raised) {
    try {
      if (raised) std::rethrow_exception(std::move(raised));
    } catch (const viscoroll::InvalidInput& error) {
      const py::module_ errors = py::module_::import("viscoroll._support.errors");
      const py::object kind = errors.attr("InvalidInput");
      py::object allowed = py::none();
      if (const auto& of = error.allowed()) {
        allowed = errors.attr("Range")(of->minimum, of->maximum, of->unit, of->excludes_minimum, of->excludes_maximum);
      }
      py::set_error(kind, kind(error.parameter(), error.rule(), error.value(), py::arg("allowed") = allowed));
    }
  });
  m.def("core_count", &viscoroll::core_count, "Cores that this process may use.");
  bind_inputs(m);
  bind_modal(m);
  bind_result(m);
  bind_solve(m);
  bind_interior(m);
  bind_roll(m);
  bind_rolling_resistance(m);
  bind_sliding(m);
}

#include <pybind11/pybind11.h>

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
  m.def("core_count", &viscoroll::core_count, "Cores that this process may use.");
  bind_inputs(m);
  bind_modal(m);
  bind_result(m);
  bind_solve(m);
  bind_interior(m);
  bind_roll(m);
  bind_rolling_resistance(m);
}

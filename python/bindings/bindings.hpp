/// @file
/// @brief What the files of this folder share: the areas of the module, and views of arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <vector>

#include "viscoroll/observer.hpp"

namespace py = pybind11;

void bind_inputs(py::module_& m);
void bind_interior(py::module_& m);
void bind_modal(py::module_& m);
void bind_result(py::module_& m);
void bind_roll(py::module_& m);
void bind_rolling_resistance(py::module_& m);
void bind_solve(py::module_& m);

/// @brief A line of result_scalars.def or history_scalars.def.
struct ScalarDescription {
  std::string name;
  std::string type;  ///< as Python's documentation names it
  std::string unit;
  std::string label;
  std::string details;
};

/// C-contiguous array; other types and layouts are refused, not copied.
template <class T>
using InputArray = py::array_t<T, py::array::c_style>;

template <class T>
std::span<const T> view(const InputArray<T>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Read-only array over `values`, which live as long as `owner`.
template <class T>
py::array_t<T> read_only(const std::vector<T>& values, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array_t<T> array(std::move(shape), values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Observer that stops on Python's signals (Ctrl-C) and reports to an optional callable progress(stage, fraction).
inline viscoroll::Observer python_observer(const py::object& progress) {
  viscoroll::Observer observer;
  observer.cancelled = [] {
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return false;
  };
  if (!progress.is_none()) {
    observer.progress = [callable = py::handle(progress)](const viscoroll::Progress& report) {
      const py::gil_scoped_acquire gil;
      callable(py::str(report.stage.data(), report.stage.size()), report.fraction);
    };
  }
  return observer;
}

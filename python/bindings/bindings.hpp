/// @file
/// @brief Declarations shared by the files of this folder: the parts of the module, and views of arrays.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "viscoroll/drive.hpp"
#include "viscoroll/errors.hpp"
#include "viscoroll/materials.hpp"
#include "viscoroll/observer.hpp"

// Python makes these from the name of a type or parameter, and sees no type for each alternative.
PYBIND11_MAKE_OPAQUE(viscoroll::ShearModulus)
PYBIND11_MAKE_OPAQUE(viscoroll::Drive)

namespace py = pybind11;

void bind_inputs(py::module_& m);
void bind_interior(py::module_& m);
void bind_modal(py::module_& m);
void bind_result(py::module_& m);
void bind_roll(py::module_& m);
void bind_rolling_resistance(py::module_& m);
void bind_sliding(py::module_& m);
void bind_solve(py::module_& m);

/// @brief One entry of result_scalars.def, history_scalars.def or sliding_scalars.def.
struct ScalarDescription {
  std::string name;
  std::string type;  ///< type in the Python documentation
  std::string unit;
  std::string label;
  std::string details;
  std::string group = "other";  ///< part of reports; see result_scalars.def
  std::string precision = {};   ///< error estimates that limit the printed digits; see result_scalars.def
};

/// C-contiguous input array. Arrays of other types and layouts are rejected, not copied.
template <class T>
using InputArray = py::array_t<T, py::array::c_style>;

template <class T>
std::span<const T> view(const InputArray<T>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Return a reader of keyword arguments, whose types Python has checked; see fields.hpp.
inline auto reader_of(const py::kwargs& given) {
  return [&given]<class Value>(const char* name, Value otherwise, bool is_optional) -> Value {
    if (is_optional && !given.contains(name)) return otherwise;
    if (!given.contains(name)) throw viscoroll::InvalidInput(name, "must be given", "");
    return given[name].template cast<Value>();
  };
}

/// Bind an input struct with a list of its members, all of them optional keyword arguments; see fields.hpp.
template <class Struct>
void bind_fields(py::module_& m, const char* name) {
  py::classh<Struct> type(m, name);
  type.def(py::init([name](const py::KWArgs<py::object>& given) {
    std::apply(
        [&](const auto&... field) {
          for (const auto& [key, value] : given) {
            if (((key.template cast<std::string>() != field.name) && ...)) {
              throw py::type_error(std::string(name) + " has no parameter " + key.template cast<std::string>());
            }
          }
        },
        Struct::fields());
    return viscoroll::read_fields<Struct>(reader_of(given));
  }));
  std::apply([&](const auto&... field) { (type.def_readonly(field.name, field.member), ...); }, Struct::fields());
}

/// Return a read-only array over the memory of `values`. The array keeps `owner`, which holds the values, alive.
template <class T>
py::array_t<T> read_only(const std::vector<T>& values, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array_t<T> array(std::move(shape), values.data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Return an observer that stops on Python signals (Ctrl-C) and calls progress(stage, fraction) unless it is None.
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

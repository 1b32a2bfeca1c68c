#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "bindings.hpp"
#include "viscoroll/sliding.hpp"

namespace {

using namespace viscoroll;

/// Steady contact with the shape of its fields.
struct ShapedResult : SlidingResult {
  py::ssize_t rows;
  py::ssize_t columns;
};

HeightMap height_map(const InputArray<double>& heights, double spacing_x, double spacing_z, bool periodic = true) {
  if (heights.ndim() != 2) throw py::value_error("heights must be a two-dimensional array");
  const auto values = view(heights);
  return {.heights = {values.begin(), values.end()},
          .rows = static_cast<int>(heights.shape(0)),
          .columns = static_cast<int>(heights.shape(1)),
          .spacing_x = spacing_x,
          .spacing_z = spacing_z,
          .periodic = periodic};
}

ShapedResult slide_released(const InputArray<double>& heights, double spacing_x, double spacing_z, bool periodic,
                            const CoatedPlane& on, double pressure, double speed, double friction, double tolerance,
                            int max_iterations, int threads, const py::object& progress) {
  const HeightMap map = height_map(heights, spacing_x, spacing_z, periodic);
  const SlidingOptions options{friction, tolerance, max_iterations, threads, python_observer(progress)};
  const py::gil_scoped_release release;
  return {slide(map, on, pressure, speed, options), map.rows, map.columns};
}

PerssonEstimate persson_released(const InputArray<double>& heights, double spacing_x, double spacing_z,
                                 const CoatedPlane& on, double pressure, double speed, double gamma, int threads) {
  const HeightMap map = height_map(heights, spacing_x, spacing_z);
  SlidingOptions options;
  options.threads = threads;
  options.observer = python_observer(py::none());
  const py::gil_scoped_release release;
  return persson_estimate(map, on, pressure, speed, gamma, options);
}

/// Return the getter of a field of the result: a read-only array over its memory, [x][z].
auto map_field(std::vector<double> SlidingResult::* member) {
  return [member](const py::object& self) {
    const auto& shaped = self.cast<const ShapedResult&>();
    return read_only(shaped.*member, {shaped.rows, shaped.columns}, self);
  };
}

template <class T>
constexpr const char* kSlidingTypeName = "float";
template <>
constexpr const char* kSlidingTypeName<int> = "int";

/// Bind a scalar, see `bind_scalar` of results.
template <class T>
void bind_sliding_scalar(py::classh<SlidingScalars>& scalars, const char* name, T SlidingScalars::* member,
                         const char* text) {
  scalars.def_readonly(name, member, text);
}

}  // namespace

void bind_sliding(py::module_& m) {
  const auto descriptions = [] {
    return std::vector<ScalarDescription>{
#define VISCOROLL_SLIDING_SCALAR(type, name, unit, label, details) \
  {#name, kSlidingTypeName<type>, unit, label, details},
#include "viscoroll/sliding_scalars.def"
#undef VISCOROLL_SLIDING_SCALAR
    };
  };
  m.def("sliding_scalars", descriptions, "Descriptions of the scalar results of sliding, in SI units.");

  py::classh<SlidingScalars> scalars(m, "SlidingScalars");
#define VISCOROLL_SLIDING_SCALAR(type, name, unit, label, details) \
  bind_sliding_scalar(scalars, #name, &SlidingScalars::name, label " [" unit "]. " details);
#include "viscoroll/sliding_scalars.def"
#undef VISCOROLL_SLIDING_SCALAR

  py::classh<ShapedResult, SlidingScalars>(m, "SlidingResult")
      .def_readonly("converged", &ShapedResult::converged)
      .def_property_readonly("pressure", map_field(&SlidingResult::pressure))
      .def_property_readonly("gap", map_field(&SlidingResult::gap));

  py::classh<PerssonEstimate>(m, "PerssonEstimate")
      .def_readonly("friction_coefficient", &PerssonEstimate::friction_coefficient)
      .def_readonly("contact_share", &PerssonEstimate::contact_share);

  m.def("slide", &slide_released, py::arg("heights").noconvert(), py::kw_only(), py::arg("spacing_x"),
        py::arg("spacing_z"), py::arg("periodic"), py::arg("on"), py::arg("pressure"), py::arg("speed"),
        py::arg("friction"), py::arg("tolerance"), py::arg("max_iterations"), py::arg("threads"), py::arg("progress"));
  m.def("persson_estimate", &persson_released, py::arg("heights").noconvert(), py::kw_only(), py::arg("spacing_x"),
        py::arg("spacing_z"), py::arg("on"), py::arg("pressure"), py::arg("speed"), py::arg("gamma"),
        py::arg("threads"));
}

#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "bindings.hpp"
#include "viscoroll/rolling_history.hpp"

namespace {

using namespace viscoroll;

/// Instants of a history; Python reads each scalar as an array over all instants.
struct InstantSeries {
  std::vector<RollingInstant> instants;
};

/// Bind a member of an instant, and the array of this member over a series. The compiler makes one function for all
/// members.
void bind_scalar(py::classh<RollingInstant>& instant, py::classh<InstantSeries>& series, const char* name,
                 double RollingInstant::* member, const char* text) {
  instant.def_readonly(name, member, text);
  series.def_property_readonly(
      name,
      [member](const InstantSeries& self) {
        py::array_t<double> values(static_cast<py::ssize_t>(self.instants.size()));
        std::ranges::transform(self.instants, values.mutable_data(), member);
        return values;
      },
      text);
}

void bind_scalars(py::module_& m) {
  const auto descriptions = [] {
    return std::vector<ScalarDescription>{
#define VISCOROLL_HISTORY_SCALAR(name, unit, label, details) {#name, "float", unit, label, details},
#define VISCOROLL_HISTORY_SUMMARY VISCOROLL_HISTORY_SCALAR
#include "viscoroll/history_scalars.def"
#undef VISCOROLL_HISTORY_SUMMARY
#undef VISCOROLL_HISTORY_SCALAR
    };
  };
  m.def("history_scalars", descriptions, "Descriptions of the scalars of a history, in SI units.");

  py::classh<RollingInstant> instant(m, "RollingInstant");
  py::classh<InstantSeries> series(m, "InstantSeries");
#define VISCOROLL_HISTORY_SCALAR(name, unit, label, details) \
  bind_scalar(instant, series, #name, &RollingInstant::name, label " [" unit "]. " details);
#define VISCOROLL_HISTORY_SUMMARY VISCOROLL_HISTORY_SCALAR
#include "viscoroll/history_scalars.def"
#undef VISCOROLL_HISTORY_SUMMARY
#undef VISCOROLL_HISTORY_SCALAR
}

RollingHistory make_history(const RollingBody& body, const Counterbody& on, double load, Start start,
                            const HistoryOptions& options, double time, double angle, std::optional<double> axle_height,
                            const py::object& progress) {
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  return {body, on, load, start, options, time, angle, observer, axle_height};
}

RollingHistory restored_history(const RollingBody& body, const Counterbody& on, double load,
                                const InputArray<double>& state, const HistoryOptions& options,
                                std::optional<double> axle_height, const py::object& progress) {
  const auto values = view(state);
  const RollingState numbers{.numbers = {values.begin(), values.end()}};
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  return {body, on, load, numbers, options, observer, axle_height};
}

InstantSeries roll_released(RollingHistory& history, const Motion& motion, const py::object& receive,
                            const py::object& progress) {
  const Observer observer = python_observer(progress);
  InstantReceiver receiver;
  if (!receive.is_none()) {
    receiver = [callable = py::handle(receive)](std::span<const RollingInstant> instants) {
      const py::gil_scoped_acquire gil;
      callable(InstantSeries{.instants = {instants.begin(), instants.end()}});
    };
  }
  const py::gil_scoped_release release;
  return {roll(history, motion, observer, receiver)};
}

void advance_released(RollingHistory& history, double time, double angle, double load,
                      std::optional<double> center_displacement, std::optional<double> axle_height) {
  const Observer observer = python_observer(py::none());
  const py::gil_scoped_release release;
  history.advance(time, angle, load, center_displacement, observer, axle_height);
}

template <class T>
auto field(std::vector<T> ContactField::* member) {
  return [member](const py::object& self) {
    const auto& contact = self.cast<const ContactField&>();
    return read_only(contact.*member, {contact.phi_nodes, contact.theta_nodes}, self);
  };
}

}  // namespace

void bind_roll(py::module_& m) {
  py::native_enum<Start>(m, "Start", "enum.Enum", "Load history of the coating before the first instant.")
      .value("RELAXED", Start::relaxed, "the coating has relaxed fully under the load")
      .value("UNDEFORMED", Start::undeformed, "the load is applied instantaneously to an undeformed coating")
      .finalize();

  bind_fields<HistoryOptions>(m, "HistoryOptions");

  bind_scalars(m);

  bind_fields<Motion>(m, "Motion");
  m.def("check_motion", [](const Motion& motion) { validate(motion); }, py::arg("motion"));
  bind_fields<Oscillation>(m, "Oscillation");
  m.def("motion_of", &motion_of, py::arg("oscillation"));
  m.def(
      "time_range",
      [](const Motion& motion, const std::optional<Mesh>& mesh, std::optional<int> steps_per_spacing) {
        const TimeRange range = time_range(motion, mesh, steps_per_spacing);
        return std::tuple{range.shortest, range.longest};
      },
      py::arg("motion"), py::arg("mesh").none(true), py::arg("steps_per_spacing").none(true));

  py::classh<ContactField>(m, "ContactField")
      .def_readonly("time", &ContactField::time)
      .def_property_readonly("x", field(&ContactField::x))
      .def_property_readonly("z", field(&ContactField::z))
      .def_property_readonly("pressure", field(&ContactField::pressure));

  py::classh<RollingHistory>(m, "RollingHistory")
      .def(py::init(&make_history), py::arg("body"), py::arg("on"), py::kw_only(), py::arg("load"), py::arg("start"),
           py::arg("options"), py::arg("time"), py::arg("angle"), py::arg("axle_height").none(true),
           py::arg("progress").none(true))
      .def(py::init(&restored_history), py::arg("body"), py::arg("on"), py::kw_only(), py::arg("load"),
           py::arg("state").noconvert(), py::arg("options"), py::arg("axle_height").none(true),
           py::arg("progress").none(true))
      .def("copy", [](const RollingHistory& self) { return RollingHistory(self); })
      .def("advance", &advance_released, py::kw_only(), py::arg("time"), py::arg("angle"), py::arg("load"),
           py::arg("center_displacement").none(true), py::arg("axle_height").none(true))
      .def("roll", &roll_released, py::arg("motion"), py::kw_only(), py::arg("receive").none(true),
           py::arg("progress").none(true))
      .def("state",
           [](const RollingHistory& self) {
             const RollingState state = self.state();
             return py::array_t<double>(static_cast<py::ssize_t>(state.numbers.size()), state.numbers.data());
           })
      .def("current", &RollingHistory::current)
      .def("contact", &RollingHistory::contact)
      .def_property_readonly("steps", &RollingHistory::steps)
      .def_property_readonly("mesh", &RollingHistory::mesh)
      .def_property_readonly("spectrum_error", &RollingHistory::spectrum_error);
}

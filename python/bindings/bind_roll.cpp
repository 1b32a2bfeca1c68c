#include <pybind11/native_enum.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "viscoroll/rolling_history.hpp"

namespace {

using namespace viscoroll;

/// Numbers of an instant, in the order of `instant_names`.
constexpr std::array kInstantMembers{
    std::pair{"time", &RollingInstant::time},
    std::pair{"angle", &RollingInstant::angle},
    std::pair{"load", &RollingInstant::load},
    std::pair{"resisting_torque", &RollingInstant::resisting_torque},
    std::pair{"driving_torque", &RollingInstant::driving_torque},
    std::pair{"penetration", &RollingInstant::penetration},
    std::pair{"contact_area", &RollingInstant::contact_area},
    std::pair{"semi_axis_x", &RollingInstant::semi_axis_x},
    std::pair{"semi_axis_z", &RollingInstant::semi_axis_z},
    std::pair{"max_pressure", &RollingInstant::max_pressure},
    std::pair{"stored_energy", &RollingInstant::stored_energy},
    std::pair{"counterpart_stored_energy", &RollingInstant::counterpart_stored_energy},
    std::pair{"dissipated_energy", &RollingInstant::dissipated_energy},
    std::pair{"counterpart_dissipated_energy", &RollingInstant::counterpart_dissipated_energy},
    std::pair{"work", &RollingInstant::work},
    std::pair{"energy_imbalance", &RollingInstant::energy_imbalance},
    std::pair{"driving_force", &RollingInstant::driving_force},
    std::pair{"center_way", &RollingInstant::center_way},
    std::pair{"center_speed", &RollingInstant::center_speed},
    std::pair{"slip_energy", &RollingInstant::slip_energy},
    std::pair{"stick_share", &RollingInstant::stick_share},
    std::pair{"error_estimate", &RollingInstant::error_estimate},
};

std::vector<std::string> instant_names() {
  std::vector<std::string> names;
  names.reserve(kInstantMembers.size());
  for (const auto& [name, member] : kInstantMembers) names.emplace_back(name);
  return names;
}

/// Instants as an array, a row for each number.
py::array_t<double> as_array(const std::vector<RollingInstant>& instants) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(kInstantMembers.size()), static_cast<py::ssize_t>(instants.size())});
  double* value = array.mutable_data();
  for (const auto& [name, member] : kInstantMembers) {
    for (const RollingInstant& instant : instants) *value++ = instant.*member;
  }
  return array;
}

RollingHistory make_history(const RollingBody& body, const Counterpart& on, double load, Start start,
                            const HistoryOptions& options, double time, double angle, const py::object& progress) {
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  return {body, on, load, start, options, time, angle, observer};
}

RollingHistory restored_history(const RollingBody& body, const Counterpart& on, double load,
                                const InputArray<double>& state, const HistoryOptions& options,
                                const py::object& progress) {
  const auto values = view(state);
  const RollingState numbers{.numbers = {values.begin(), values.end()}};
  const Observer observer = python_observer(progress);
  const py::gil_scoped_release release;
  return {body, on, load, numbers, options, observer};
}

py::array_t<double> roll_array(RollingHistory& history, std::vector<double> time, std::vector<double> angle,
                               std::vector<double> load, std::vector<double> center_way, const py::object& progress) {
  std::vector<RollingInstant> instants;
  {
    const Observer observer = python_observer(progress);
    const py::gil_scoped_release release;
    const Motion motion{.time = std::move(time),
                        .angle = std::move(angle),
                        .load = std::move(load),
                        .center_way = std::move(center_way)};
    instants = roll(history, motion, observer);
  }
  return as_array(instants);
}

void advance_released(RollingHistory& history, double time, double angle, double load,
                      std::optional<double> center_way) {
  const Observer observer = python_observer(py::none());
  const py::gil_scoped_release release;
  history.advance(time, angle, load, center_way, observer);
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
  py::native_enum<Start>(m, "Start", "enum.Enum", "What the coating has gone through before the first instant.")
      .value("RELAXED", Start::relaxed, "it has borne the load for ever")
      .value("FRESH", Start::fresh, "it is pressed on in no time")
      .finalize();

  py::classh<HistoryOptions>(m, "HistoryOptions")
      .def(py::init<>())
      .def_readwrite("mesh", &HistoryOptions::mesh)
      .def_readwrite("compliance", &HistoryOptions::compliance)
      .def_readwrite("curvature", &HistoryOptions::curvature)
      .def_readwrite("friction", &HistoryOptions::friction)
      .def_readwrite("driving_force", &HistoryOptions::driving_force)
      .def_readwrite("driving_torque", &HistoryOptions::driving_torque)
      .def_readwrite("mass", &HistoryOptions::mass)
      .def_readwrite("center_speed", &HistoryOptions::center_speed)
      .def_readwrite("lattices", &HistoryOptions::lattices)
      .def_readwrite("steps_per_spacing", &HistoryOptions::steps_per_spacing)
      .def_readwrite("shortest_time", &HistoryOptions::shortest_time)
      .def_readwrite("longest_time", &HistoryOptions::longest_time)
      .def_readwrite("spectrum_tolerance", &HistoryOptions::spectrum_tolerance)
      .def_readwrite("threads", &HistoryOptions::threads);

  py::classh<ContactField>(m, "ContactField")
      .def_readonly("time", &ContactField::time)
      .def_property_readonly("x", field(&ContactField::x))
      .def_property_readonly("z", field(&ContactField::z))
      .def_property_readonly("pressure", field(&ContactField::pressure));

  py::classh<RollingHistory>(m, "RollingHistory")
      .def(py::init(&make_history), py::arg("body"), py::arg("on"), py::kw_only(), py::arg("load"), py::arg("start"),
           py::arg("options"), py::arg("time"), py::arg("angle"), py::arg("progress").none(true))
      .def(py::init(&restored_history), py::arg("body"), py::arg("on"), py::kw_only(), py::arg("load"),
           py::arg("state").noconvert(), py::arg("options"), py::arg("progress").none(true))
      .def("copy", [](const RollingHistory& self) { return RollingHistory(self); })
      .def("advance", &advance_released, py::kw_only(), py::arg("time"), py::arg("angle"), py::arg("load"),
           py::arg("center_way").none(true))
      .def("roll", &roll_array, py::kw_only(), py::arg("time"), py::arg("angle"), py::arg("load"),
           py::arg("center_way"), py::arg("progress").none(true))
      .def("state",
           [](const RollingHistory& self) {
             const RollingState state = self.state();
             return py::array_t<double>(static_cast<py::ssize_t>(state.numbers.size()), state.numbers.data());
           })
      .def("now", [](const RollingHistory& self) { return as_array({self.now()}); })
      .def("contact", &RollingHistory::contact)
      .def_property_readonly("steps", &RollingHistory::steps)
      .def_property_readonly("mesh", &RollingHistory::mesh)
      .def_property_readonly("spectrum_error", &RollingHistory::spectrum_error);

  m.def(
      "check_motion",
      [](std::vector<double> time, std::vector<double> angle, std::vector<double> load,
         std::vector<double> center_way) {
        validate({.time = std::move(time),
                  .angle = std::move(angle),
                  .load = std::move(load),
                  .center_way = std::move(center_way)});
      },
      py::kw_only(), py::arg("time"), py::arg("angle"), py::arg("load"), py::arg("center_way"));
  m.def("instant_names", &instant_names, "What the rows of a history are.");
}

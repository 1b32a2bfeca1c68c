#include "motion_from_json.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "numerics_from_json.hpp"

namespace viscoroll::wasm {

template <>
inline constexpr auto kNames<Start> =
    std::to_array<Name<Start>>({{"relaxed", Start::relaxed}, {"undeformed", Start::undeformed}});

namespace {

constexpr auto kCurvatures =
    std::to_array<Name<Curvature>>({{"sphere", Curvature::sphere}, {"paper", Curvature::paper}});

/// Read the table of a type of profile: points, or a shape.
template <class... Shapes>
HeightProfile profile_of_type(Table& table, std::type_identity<std::variant<Shapes...>> /*shapes*/) {
  const Json& type = table.take_type();
  std::optional<HeightProfile> profile;
  std::string types = "points";
  if (type == types) profile = read_fields<HeightProfile>(value_reader(table));
  std::optional<ProfileShape> shape;
  const auto read = [&]<class Shape>(std::type_identity<Shape> /*shape*/) {
    types += std::string(", ") + Shape::type;
    if (type == Shape::type) shape = read_fields<Shape>(value_reader(table));
  };
  (read(std::type_identity<Shapes>{}), ...);
  if (!profile && !shape) {
    throw InvalidInput(table.path_of("type"), type.is_null() ? "must be given" : "must be one of " + types,
                       type.is_null() ? "" : shown(type));
  }
  table.close();
  return at_path(table.path(), [&] {
    HeightProfile points = profile ? *std::move(profile) : profile_of(*shape);
    validate(points);
    return points;
  });
}

std::optional<HeightProfile> take_profile(Table& file, std::string_view key) {
  const Json* given = file.take(key);
  if (given == nullptr) return std::nullopt;
  Table table(*given, file.path_of(key));
  return profile_of_type(table, std::type_identity<ProfileShape>{});
}

std::optional<Axle> take_axle(Table& file, std::string_view key) {
  const Json* given = file.take(key);
  if (given == nullptr) return std::nullopt;
  Table table(*given, file.path_of(key));
  const Axle axle = read_fields<Axle>(value_reader(table));
  table.close();
  at_path(table.path(), [&] { validate(axle); });
  return axle;
}

/// Read the options of a history, which are in three places: in the file itself, in its motion and in its numerics.
HistoryOptions take_options(Table& file, Table& motion, Table& numerics) {
  const MeshKeys mesh(numerics);
  auto options =
      read_fields<HistoryOptions>([&]<class Value>(std::string_view key, Value otherwise, bool is_optional) -> Value {
        if constexpr (std::is_same_v<Value, std::optional<Mesh>>) {
          return otherwise;
        } else if constexpr (std::is_same_v<Value, std::optional<HeightProfile>>) {
          return take_profile(file, key);
        } else if constexpr (std::is_same_v<Value, std::optional<Axle>>) {
          return take_axle(file, key);
        } else if constexpr (std::is_same_v<Value, Curvature>) {
          return numerics.one_of(key, kCurvatures, otherwise);
        } else if constexpr (std::is_same_v<Value, Compliance>) {
          return numerics.value(key, otherwise, is_optional);
        } else if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, std::optional<int>>) {
          if (key == "threads") return otherwise;
          const auto given = numerics.maybe_integer(key);
          return given ? Value(*given) : otherwise;
        } else {
          if (key == "shortest_time" || key == "longest_time") return otherwise;
          return (key == "spectrum_tolerance" ? numerics : motion).value(key, otherwise, is_optional);
        }
      });
  numerics.close();
  options.mesh = mesh.mesh();
  options.threads = 1;  // a web worker has only one
  return options;
}

/// Keys of the waypoints.
struct WaypointKeys {
  std::optional<std::vector<double>> time;
  std::optional<std::vector<double>> angle;
  std::optional<std::vector<double>> distance;
  std::optional<std::vector<double>> center_displacement;
  std::variant<std::monostate, double, std::vector<double>> load;
  std::variant<std::monostate, double, std::vector<double>> axle_height;
  std::optional<double> amplitude;
  std::optional<double> frequency;
  double cycles = 1.0;
};

WaypointKeys take_waypoints(Table& motion) {
  return {.time = motion.maybe_numbers("time"),
          .angle = motion.maybe_numbers("angle"),
          .distance = motion.maybe_numbers("distance"),
          .center_displacement = motion.maybe_numbers("center_displacement"),
          .load = motion.maybe_number_or_numbers("load"),
          .axle_height = motion.maybe_number_or_numbers("axle_height"),
          .amplitude = motion.maybe_number("amplitude"),
          .frequency = motion.maybe_number("frequency"),
          .cycles = motion.maybe_number("cycles").value_or(Oscillation{}.cycles)};
}

bool is_given(const auto& value) { return value.index() != 0; }

/// The same number at all waypoints, or one for each.
std::vector<double> at_waypoints(const auto& given, std::size_t count) {
  if (const double* number = std::get_if<double>(&given)) return std::vector<double>(count, *number);
  if (const auto* numbers = std::get_if<std::vector<double>>(&given)) return *numbers;
  return {};
}

Motion motion_of(const WaypointKeys& keys, double radius) {
  if (keys.time.has_value() == keys.amplitude.has_value()) {
    throw InvalidInput("motion", "must have exactly one of time and amplitude", keys.time ? "time, amplitude" : "none");
  }
  Motion motion;
  if (keys.amplitude) {
    if (keys.center_displacement) {
      throw InvalidInput("motion.center_displacement", "must be left out with amplitude", "");
    }
    if (!keys.frequency || !is_given(keys.load)) {
      throw InvalidInput("motion", "must have frequency and load with amplitude", "");
    }
    motion = at_path("motion", [&] {
      return viscoroll::motion_of(
          Oscillation{.amplitude = *keys.amplitude, .frequency = *keys.frequency, .cycles = keys.cycles});
    });
    motion.load = at_waypoints(keys.load, motion.time.size());
    return motion;
  }
  const bool is_supported = is_given(keys.load) || is_given(keys.axle_height);
  if (!(keys.angle || keys.distance) || !is_supported) {
    throw InvalidInput("motion", "must have load or axle_height, and angle or distance, with time", "");
  }
  motion.time = *keys.time;
  if (motion.time.size() < 2) {
    throw InvalidInput("time", "must have at least two waypoints", std::to_string(motion.time.size()));
  }
  if (keys.angle && keys.distance) {
    throw std::invalid_argument("exactly one of angle and distance must be given, got both");
  }
  if (keys.angle) {
    motion.angle = *keys.angle;
  } else {
    if (keys.distance->size() != motion.time.size()) {
      throw InvalidInput("distance", "must be as long as time (" + std::to_string(motion.time.size()) + ")",
                         std::to_string(keys.distance->size()));
    }
    for (const double distance : *keys.distance) {
      if (!std::isfinite(distance)) {
        throw InvalidInput("distance", "must be finite",
                           std::isnan(distance) ? "nan"
                           : distance > 0.0     ? "inf"
                                                : "-inf");
      }
      motion.angle.push_back(distance / radius);
    }
  }
  if (is_given(keys.load) && is_given(keys.axle_height)) {
    throw std::invalid_argument("exactly one of load and axle_height must be given, got both");
  }
  motion.load = at_waypoints(keys.load, motion.time.size());
  motion.axle_height = at_waypoints(keys.axle_height, motion.time.size());
  if (keys.center_displacement) motion.center_displacement = *keys.center_displacement;
  validate(motion);
  return motion;
}

}  // namespace

MotionCase motion_from_json(const Json& json) {
  Table file(json, "");
  MotionCase read{.pair = pair_from_json(file), .motion = {}, .start = Start::relaxed, .options = {}};
  static const Json kEmpty = Json::object();
  const Json& given = file.require("motion");
  const Json* given_numerics = file.take("numerics");
  Table motion(given.is_null() ? kEmpty : given, "motion");
  Table numerics(given_numerics == nullptr ? kEmpty : *given_numerics, "numerics");
  const WaypointKeys keys = take_waypoints(motion);
  read.start = motion.value("start", read.start, true);
  read.options = take_options(file, motion, numerics);
  motion.close();
  file.close();
  if (read.options.driving_torque && read.options.driving_force != 0.0) {
    throw InvalidInput("motion.driving_force", "must be left out with driving_torque", "");
  }
  const double radius = std::visit([](const auto& body) { return outer_radius(body); }, read.pair.body);
  read.motion = motion_of(keys, radius);
  const TimeRange times = time_range(read.motion, read.options.mesh, read.options.steps_per_spacing);
  read.options.shortest_time = times.shortest;
  read.options.longest_time = times.longest;
  return read;
}

}  // namespace viscoroll::wasm

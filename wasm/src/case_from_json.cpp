#include "case_from_json.hpp"

#include <array>
#include <optional>
#include <string>

namespace viscoroll::wasm {
namespace {

constexpr auto kCompliances =
    std::to_array<Name<Compliance>>({{"radial", Compliance::radial}, {"vertical", Compliance::vertical}});
constexpr auto kCurvatures = std::to_array<Name<Curvature>>(
    {{"sphere", Curvature::sphere}, {"paper", Curvature::paper}, {"exact", Curvature::exact}});
constexpr auto kPatchLoads =
    std::to_array<Name<PatchLoad>>({{"flat", PatchLoad::flat}, {"spherical", PatchLoad::spherical}});
constexpr auto kSlipKinematics =
    std::to_array<Name<SlipKinematics>>({{"exact", SlipKinematics::exact}, {"flat", SlipKinematics::flat}});

Drive drive_from_json(const Json& json, const std::string& path) {
  Table table(json, path);
  const auto force = table.maybe_number("force");
  const auto torque = table.maybe_number("torque");
  const auto creepage = table.maybe_number("creepage");
  const auto lateral = table.maybe_number("lateral_creepage");
  const auto spin = table.maybe_number("spin");
  table.close();

  std::string given;
  for (const auto& [name, value] : {Name{"force", force}, Name{"torque", torque}, Name{"creepage", creepage}}) {
    if (value) given += (given.empty() ? "" : ", ") + std::string(name);
  }
  if (given.empty() || given.find(',') != std::string::npos) {
    throw InvalidInput(path, "must have exactly one of force, torque and creepage", given.empty() ? "none" : given);
  }
  for (const auto& [name, value] : {Name{"lateral_creepage", lateral}, Name{"spin", spin}}) {
    if (!creepage && value.value_or(0.0) != 0.0) {
      throw InvalidInput(path + "." + std::string(name), "must be 0 without drive.creepage", shown(*value));
    }
  }
  if (force) return DriveForce{*force};
  if (torque) return DriveTorque{*torque};
  return DriveCreepage{.creepage = *creepage, .lateral_creepage = lateral.value_or(0.0), .spin = spin.value_or(0.0)};
}

LoadCase load_case_from_json(const Json& json, const std::string& path) {
  Table table(json, path);
  const std::optional<double> penetration = table.maybe_number("penetration");
  LoadCase load_case{.load = penetration ? table.maybe_number("load") : table.number("load"),
                     .penetration = penetration,
                     .angular_speed = table.number("angular_speed"),
                     .friction = table.maybe_number("friction").value_or(0.0)};
  if (const Json* drive = table.take("drive")) load_case.drive = drive_from_json(*drive, table.path_of("drive"));
  table.close();
  return load_case;
}

Options options_from_json(const Json& json, const std::string& path) {
  Table table(json, path);
  const auto nodes = table.maybe_integer("nodes_per_revolution");
  const auto max_order = table.maybe_integer("max_order");
  const auto theta_nodes = table.maybe_integer("theta_nodes_per_revolution");
  const auto accuracy = table.maybe_number("accuracy");
  Options options{.compliance = table.one_of("compliance", kCompliances, Options{}.compliance),
                  .curvature = table.one_of("curvature", kCurvatures, Options{}.curvature),
                  .patch_load = table.one_of("patch_load", kPatchLoads, Options{}.patch_load),
                  .slip_kinematics = table.one_of("slip_kinematics", kSlipKinematics, Options{}.slip_kinematics)};
  table.close();
  if (nodes) {
    options.mesh =
        Mesh{.nodes_per_revolution = *nodes, .max_order = max_order, .theta_nodes_per_revolution = theta_nodes};
    validate(*options.mesh);
  } else if (max_order || theta_nodes) {
    throw InvalidInput("numerics.nodes_per_revolution", "must be given with max_order or theta_nodes_per_revolution",
                       "");
  }
  if (nodes && accuracy) {
    throw InvalidInput("numerics.accuracy", "must be left out if a mesh is given", "");
  }
  options.accuracy = accuracy.value_or(options.accuracy);
  return options;
}

}  // namespace

Case case_from_json(const Json& json) {
  Table file(json, "");
  Case read{.pair = pair_from_json(file), .load_case = {}, .options = {}};
  const Json& rolling = file.require("rolling");
  if (!rolling.is_null()) read.load_case = load_case_from_json(rolling, "rolling");
  if (const Json* numerics = file.take("numerics")) read.options = options_from_json(*numerics, "numerics");
  file.close();
  read.options.threads = 1;  // a web worker has only one
  return read;
}

}  // namespace viscoroll::wasm

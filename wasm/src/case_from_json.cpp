#include "case_from_json.hpp"

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "numerics_from_json.hpp"

namespace viscoroll::wasm {

template <>
inline constexpr auto kNames<PatchLoad> =
    std::to_array<Name<PatchLoad>>({{"flat", PatchLoad::flat}, {"spherical", PatchLoad::spherical}});
template <>
inline constexpr auto kNames<SlipKinematics> =
    std::to_array<Name<SlipKinematics>>({{"exact", SlipKinematics::exact}, {"flat", SlipKinematics::flat}});

namespace {

/// "a, b and c"
std::string joined(const std::vector<std::string>& names, const std::string& last = " and ") {
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) all += i + 1 == names.size() ? last : ", ";
    all += names[i];
  }
  return all;
}

/// Read a drive if its first field is given, which is the prescribed quantity; otherwise its other fields must be 0.
template <class Kind>
void read_drive(Table& table, Drive& drive) {
  const std::string_view first = std::get<0>(Kind::fields()).name;
  const bool is_given = table.take(first) != nullptr;
  const auto read = read_fields<Kind>([&](std::string_view key, double otherwise, bool /*is_optional*/) {
    const double value = table.value(key, otherwise, true);
    if (is_given || value == 0.0) return value;
    throw InvalidInput(table.path_of(key), "must be 0 without drive." + std::string(first), shown(value));
  });
  if (is_given) drive = read;
}

template <class... Kinds>
Drive drive_from_json(Table& table, std::type_identity<std::variant<Kinds...>> /*kinds*/) {
  std::vector<std::string> names;
  std::vector<std::string> given;
  const auto take = [&](const auto& first, const auto&... others) {
    names.emplace_back(first.name);
    if (table.take(first.name) != nullptr) given.emplace_back(first.name);
    ((void)table.take(others.name), ...);
  };
  (std::apply(take, Kinds::fields()), ...);
  table.close();
  if (given.size() != 1) {
    throw InvalidInput(table.path(), "must have exactly one of " + joined(names),
                       given.empty() ? "none" : joined(given, ", "));
  }
  Drive drive;
  (read_drive<Kinds>(table, drive), ...);
  return drive;
}

LoadCase load_case_from_json(const Json& json, const std::string& path) {
  Table table(json, path);
  if (table.take("penetration") == nullptr) (void)table.require("load");
  if (table.take("speed") == nullptr) (void)table.require("angular_speed");
  const auto load_case = read_fields<LoadCase>([&]<class Value>(const char* key, Value otherwise, bool is_optional) {
    if constexpr (std::is_same_v<Value, Drive>) {
      const Json* drive = table.take(key);
      if (drive == nullptr) return otherwise;
      Table of_drive(*drive, table.path_of(key));
      return drive_from_json(of_drive, std::type_identity<Drive>{});
    } else if constexpr (std::is_same_v<Value, std::optional<Adhesion>>) {
      const Json* adhesion = table.take(key);
      if (adhesion == nullptr) return otherwise;
      Table of_adhesion(*adhesion, table.path_of(key));
      Value read = read_fields<Adhesion>([&]<class Number>(const char* name, Number missing, bool may_be_missing) {
        return of_adhesion.value(name, std::move(missing), may_be_missing);
      });
      of_adhesion.close();
      return read;
    } else {
      return table.value(key, std::move(otherwise), is_optional);
    }
  });
  table.close();
  return load_case;
}

Options options_from_json(const Json& json, const std::string& path) {
  Table table(json, path);
  const MeshKeys mesh(table);
  const bool has_accuracy = table.take("accuracy") != nullptr;
  auto options = read_fields<Options>([&]<class Value>(const char* key, Value otherwise, bool is_optional) -> Value {
    // The keys of the mesh are those above, and case files have neither max_iterations nor threads.
    if constexpr (std::is_same_v<Value, std::optional<Mesh>> || std::is_same_v<Value, int>) {
      return otherwise;
    } else {
      return table.value(key, std::move(otherwise), is_optional);
    }
  });
  table.close();
  options.mesh = mesh.mesh();
  if (options.mesh && has_accuracy) {
    throw InvalidInput("numerics.accuracy", "must be left out if a mesh is given", "");
  }
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

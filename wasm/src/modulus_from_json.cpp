#include "modulus_from_json.hpp"

#include "viscoroll/modulus_types.hpp"

namespace viscoroll::wasm {
namespace {

ShearModulus checked(const MadeModulus& made, const std::string& path) {
  return at_path(path, [&] {
    ShearModulus modulus = made();
    validate(modulus, "");
    return modulus;
  });
}

}  // namespace

ShearModulus modulus_from_json(const Json& json, const std::string& path) {
  if (json.is_number()) {
    return checked([&] { return Elastic{json.get<double>()}; }, path);
  }
  if (!json.is_object()) {
    throw InvalidInput(path, "must be a table or a number", shown(json));
  }
  Table table(json, path);
  const Json& type = table.take_type();
  const MadeModulus made =
      type.is_string() ? read_modulus(type.get<std::string>(), value_reader(table)) : MadeModulus{};
  if (!made) {
    std::string types;
    for (const std::string_view name : modulus_types()) types += (types.empty() ? "" : ", ") + std::string(name);
    throw InvalidInput(table.path_of("type"), "must be one of " + types, shown(type));
  }
  table.close();
  return checked(made, path);
}

}  // namespace viscoroll::wasm

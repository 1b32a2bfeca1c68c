#include "modulus_from_json.hpp"

#include "viscoroll/modulus_types.hpp"

namespace viscoroll::wasm {
namespace {

ShearModulus checked(const MadeModulus& made, const std::string& place) {
  return at_place(place, [&] {
    ShearModulus modulus = made();
    validate(modulus, "");
    return modulus;
  });
}

}  // namespace

ShearModulus modulus_from_json(const Json& json, const std::string& place) {
  if (json.is_number()) {
    return checked([&] { return Elastic{json.get<double>()}; }, place);
  }
  if (!json.is_object()) {
    throw InvalidInput(place, "must be a table or a number", shown(json));
  }
  Table table(json, place);
  const Json& type = table.take_type();
  const MadeModulus made =
      type.is_string() ? read_modulus(type.get<std::string>(), value_reader(table)) : MadeModulus{};
  if (!made) {
    std::string types;
    for (const std::string_view name : modulus_types()) types += (types.empty() ? "" : ", ") + std::string(name);
    throw InvalidInput(table.place_of("type"), "must be one of " + types, shown(type));
  }
  table.close();
  return checked(made, place);
}

}  // namespace viscoroll::wasm

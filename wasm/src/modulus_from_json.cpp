#include "modulus_from_json.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace viscoroll::wasm {
namespace {

constexpr auto kExtrapolations =
    std::to_array<Name<Extrapolation>>({{"error", Extrapolation::error}, {"hold", Extrapolation::hold}});

/// Function that makes a modulus. Its parameters are read first, so that the table reports unknown and missing keys
/// before the modulus checks its parameters.
using Made = std::function<ShearModulus()>;

Made elastic(Table& table) {
  return [modulus = Elastic{table.number("modulus")}] { return modulus; };
}

Made standard_linear_solid(Table& table) {
  return [instantaneous = table.number("instantaneous_modulus"), relaxed = table.number("relaxed_modulus"),
          time = table.number("relaxation_time")] {
    return viscoroll::standard_linear_solid(instantaneous, relaxed, time);
  };
}

Made creep_compliance(Table& table) {
  return [instantaneous = table.number("instantaneous_compliance"), compliances = table.numbers("compliances"),
          times = table.numbers("retardation_times")] {
    return viscoroll::creep_compliance(instantaneous, compliances, times);
  };
}

Made prony(Table& table) {
  return [modulus = Prony{.instantaneous_modulus = table.number("instantaneous_modulus"),
                          .weights = table.numbers("weights"),
                          .relaxation_times = table.numbers("relaxation_times")}] { return modulus; };
}

Made kelvin_voigt(Table& table) {
  return [modulus = KelvinVoigt{.modulus = table.number("modulus"), .viscosity = table.number("viscosity")}] {
    return modulus;
  };
}

Made fractional_zener(Table& table) {
  return [modulus = FractionalZener{.instantaneous_modulus = table.number("instantaneous_modulus"),
                                    .relaxed_modulus = table.number("relaxed_modulus"),
                                    .relaxation_time = table.number("relaxation_time"),
                                    .order = table.number("order")}] { return modulus; };
}

Made master_curve(Table& table) {
  return [modulus = MasterCurve{.frequency = table.numbers("frequency"),
                                .storage = table.numbers("storage"),
                                .loss = table.numbers("loss"),
                                .extrapolation = table.one_of("extrapolation", kExtrapolations,
                                                              MasterCurve{}.extrapolation)}] { return modulus; };
}

/// Types of moduli in the C++ library. The Python package converts all other types to these.
constexpr auto kTypes = std::to_array<Name<Made (*)(Table&)>>({
    {"elastic", elastic},
    {"standard_linear_solid", standard_linear_solid},
    {"prony", prony},
    {"creep_compliance", creep_compliance},
    {"kelvin_voigt", kelvin_voigt},
    {"fractional_zener", fractional_zener},
    {"master_curve", master_curve},
});

ShearModulus checked(const Made& made, const std::string& path) {
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
  const auto found =
      std::ranges::find_if(kTypes, [&](const auto& one) { return type.is_string() && type == one.name; });
  if (found == kTypes.end()) {
    throw InvalidInput(table.path_of("type"), "must be one of " + names_of(kTypes), shown(type));
  }
  const Made made = found->value(table);
  table.close();
  return checked(made, path);
}

}  // namespace viscoroll::wasm

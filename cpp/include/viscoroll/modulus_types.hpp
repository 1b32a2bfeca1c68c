/// @file
/// @brief Reading of moduli by the name of their type, for files, WebAssembly and Python.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "viscoroll/materials.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll {

/// @brief Function that constructs a modulus and checks its values. It is called after all parameters have been read,
/// so that unknown and missing parameters are reported first.
using MadeModulus = std::function<ShearModulus()>;

namespace detail {

/// Type that stores an argument of a function.
template <class Argument>
using Stored = std::conditional_t<std::is_same_v<Argument, std::span<const double>>, std::vector<double>, Argument>;

template <class Reader, class Modulus, class Parameters>
[[nodiscard]] MadeModulus read_arguments(const ModulusFunction<Modulus(const Parameters&), 0>& function,
                                         const Reader& reader, std::index_sequence<> /*parameters*/) {
  return [make = function.make, parameters = read_fields<Parameters>(reader)] { return make(parameters); };
}

template <class Reader, class Modulus, class... Arguments, std::size_t count, std::size_t... index>
[[nodiscard]] MadeModulus read_arguments(const ModulusFunction<Modulus(Arguments...), count>& function,
                                         const Reader& reader, std::index_sequence<index...> /*parameters*/) {
  std::tuple<Stored<Arguments>...> arguments{reader(function.parameters[index], Stored<Arguments>{}, false)...};
  return [make = function.make, arguments = std::move(arguments)] { return std::apply(make, arguments); };
}

/// Call `visit(type, read)` for each type of modulus, where `read(reader)` returns a `MadeModulus`.
template <class Visitor>
void for_each_modulus_type(const Visitor& visit) {
  const auto visit_struct = [&]<class Modulus>(std::type_identity<Modulus> /*kind*/) {
    if constexpr (requires { Modulus::fields(); }) {
      visit(Modulus::type, [](const auto& reader) -> MadeModulus {
        return [modulus = read_fields<Modulus>(reader)] { return modulus; };
      });
    }
  };
  [&]<class... Moduli>(std::type_identity<std::variant<Moduli...>> /*kinds*/) {
    (visit_struct(std::type_identity<Moduli>{}), ...);
  }(std::type_identity<ShearModulus>{});
  const auto visit_function = [&]<class Function, std::size_t count>(const ModulusFunction<Function, count>& function) {
    visit(function.type,
          [&](const auto& reader) { return read_arguments(function, reader, std::make_index_sequence<count>{}); });
  };
  std::apply([&](const auto&... function) { (visit_function(function), ...); }, kModulusFunctions);
}

}  // namespace detail

/// @return names of all types, for example "kelvin_voigt"
[[nodiscard]] inline std::vector<std::string_view> modulus_types() {
  std::vector<std::string_view> types;
  detail::for_each_modulus_type([&](std::string_view type, const auto& /*read*/) { types.push_back(type); });
  return types;
}

/// @brief Read the parameters of a modulus.
/// @param[in] type name of the type
/// @param[in] reader see fields.hpp
/// @return function that makes the modulus; empty if there is no such type
template <class Reader>
[[nodiscard]] MadeModulus read_modulus(std::string_view type, const Reader& reader) {
  MadeModulus made;
  detail::for_each_modulus_type([&](std::string_view name, const auto& read) {
    if (name == type) made = read(reader);
  });
  return made;
}

}  // namespace viscoroll

/// @file
/// @brief Tables of a case: JSON objects whose keys are read one by one. Messages contain the path of the key.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "viscoroll/errors.hpp"
#include "viscoroll/materials.hpp"
#include "viscoroll/modulus_functions.hpp"

namespace viscoroll::wasm {

/// @brief JSON with keys in their original order.
using Json = nlohmann::ordered_json;

/// @return text of a value for messages, truncated if it is long
[[nodiscard]] std::string shown(const Json& value);

/// @brief List of allowed names for messages: "rigid, hollow, solid".
/// @param[in] named range whose elements have a member `name`
/// @param[in] between separator
template <class Named>
[[nodiscard]] std::string names_of(const Named& named, std::string_view between = ", ") {
  std::string all;
  for (const auto& one : named) all += (all.empty() ? "" : std::string(between)) + std::string(one.name);
  return all;
}

/// @brief A value and its name in a case, such as an enumerator.
template <class Value>
struct Name {
  std::string_view name;
  Value value;
};

/// @brief Names of the values of an enumeration in a case; specializations are arrays of `Name`.
template <class Enum>
inline constexpr std::array<Name<Enum>, 0> kNames{};

template <>
inline constexpr auto kNames<Extrapolation> =
    std::to_array<Name<Extrapolation>>({{"error", Extrapolation::error}, {"hold", Extrapolation::hold}});

template <>
inline constexpr auto kNames<ShoreScale> =
    std::to_array<Name<ShoreScale>>({{"A", ShoreScale::a}, {"D", ShoreScale::d}});

/// @brief Check a part of a case. Errors name the path in the case: "ball.layers[0].thickness".
template <class Check>
auto at_path(const std::string& path, const Check& check) {
  try {
    return check();
  } catch (const InvalidInput& error) {
    throw error.inside(path);
  }
}

/// @brief JSON object whose keys must all be taken before it is closed; null counts as missing.
/// Missing keys are reported when the table is closed, after unknown keys, which may be misspelled.
class Table {
 public:
  /// @param[in] content any JSON, which must outlive this object
  /// @param[in] path path of the table in the case, such as "ball.layers[0]"; empty for the whole case
  /// @throws InvalidInput unless `content` is an object
  Table(const Json& content, std::string path);

  /// @brief Take an optional key.
  /// @return its value, or a null pointer if it is missing
  [[nodiscard]] const Json* take(std::string_view key);
  /// @brief Take a required key.
  /// @return its value, or null, which is reported when the table is closed
  [[nodiscard]] const Json& require(std::string_view key);

  /// @throws InvalidInput (all six functions) if the value has another type
  [[nodiscard]] double number(std::string_view key);
  [[nodiscard]] std::optional<double> maybe_number(std::string_view key);
  [[nodiscard]] std::optional<int> maybe_integer(std::string_view key);
  [[nodiscard]] std::vector<double> numbers(std::string_view key);
  [[nodiscard]] std::optional<std::vector<double>> maybe_numbers(std::string_view key);
  [[nodiscard]] std::variant<std::monostate, double, std::vector<double>> maybe_number_or_numbers(std::string_view key);

  /// @brief Take a key whose value is one of several names.
  /// @return the value of this name, or `otherwise` if the key is missing
  template <class Value, std::size_t kCount>
  [[nodiscard]] Value one_of(std::string_view key, const std::array<Name<Value>, kCount>& names, Value otherwise) {
    const Json* given = take(key);
    if (given == nullptr) return otherwise;
    const auto found =
        std::ranges::find_if(names, [&](const auto& one) { return given->is_string() && *given == one.name; });
    if (found != names.end()) return found->value;
    throw InvalidInput(path_of(key), "must be one of " + names_of(names), shown(*given));
  }

  /// @brief Take a key whose value is a number, a list of numbers, true or false, or a name of an enumerator.
  /// @return the value; `otherwise` if the key is missing and optional
  template <class Value>
  [[nodiscard]] Value value(std::string_view key, Value otherwise, bool is_optional) {
    if constexpr (std::is_enum_v<Value>) {
      return one_of(key, kNames<Value>, otherwise);
    } else if constexpr (std::is_same_v<Value, bool>) {
      const Json* given = take(key);
      if (given == nullptr) return otherwise;
      if (given->is_boolean()) return given->template get<bool>();
      throw InvalidInput(path_of(key), "must be true or false", shown(*given));
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
      return maybe_number(key);
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
      return numbers(key);
    } else {
      static_assert(std::is_same_v<Value, double>);
      return is_optional ? maybe_number(key).value_or(otherwise) : number(key);
    }
  }

  /// @brief Take the key `type`; messages then name the type of the table.
  /// @return its value, or null
  [[nodiscard]] const Json& take_type();

  /// @return path of a key in the case
  [[nodiscard]] std::string path_of(std::string_view key) const;
  [[nodiscard]] const std::string& path() const { return path_; }

  /// @throws InvalidInput for keys that were not taken and for missing keys
  void close() const;

 private:
  const Json* content_;
  std::string path_;
  std::string type_;
  std::vector<std::string> taken_;
  std::vector<std::string> missing_;
};

/// @return reader of the values of a table; see fields.hpp
[[nodiscard]] inline auto value_reader(Table& table) {
  return [&table]<class Value>(std::string_view key, Value otherwise, bool is_optional) {
    return table.value(key, std::move(otherwise), is_optional);
  };
}

}  // namespace viscoroll::wasm

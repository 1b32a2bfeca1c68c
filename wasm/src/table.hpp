/// @file
/// @brief Tables of a case: JSON objects whose keys are taken one by one, each with its place for messages.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace viscoroll::wasm {

/// @brief Keys stay in their order.
using Json = nlohmann::ordered_json;

/// @return what a message shows of a value, cut where it is long
[[nodiscard]] std::string shown(const Json& value);

/// @brief Names among which a text chooses, as messages list them: "rigid, hollow, solid".
/// @param[in] named anything with a member `name`
template <class Named>
[[nodiscard]] std::string names_of(const Named& named, std::string_view between = ", ") {
  std::string all;
  for (const auto& one : named) all += (all.empty() ? "" : std::string(between)) + std::string(one.name);
  return all;
}

/// @brief A value of an enumeration, and how a case names it.
template <class Value>
struct Name {
  std::string_view name;
  Value value;
};

/// @brief Check a part of a case, whose messages then begin with its place: "ball.layers[0]: thickness must be ...".
template <class Check>
auto at_place(const std::string& place, const Check& check) {
  try {
    return check();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(place + ": " + error.what());
  }
}

/// @brief A JSON object of which each key must be taken before it is closed; null is as good as left out.
/// What is missing is told when it is closed: unknown keys, which may be misspelled, come first.
class Table {
 public:
  /// @param[in] content any JSON, which must outlive this
  /// @param[in] place where it stands: "ball.layers[0]"; empty for all of the case
  /// @throws std::invalid_argument unless it is an object
  Table(const Json& content, std::string place);

  /// @brief Take a key that may be left out.
  /// @return its value, or a null pointer without
  [[nodiscard]] const Json* take(std::string_view key);
  /// @brief Take a key that must be there.
  /// @return its value, or null, which is told when the table is closed
  [[nodiscard]] const Json& require(std::string_view key);

  /// @throws std::invalid_argument of all of these where the value is of another type
  [[nodiscard]] double number(std::string_view key);
  [[nodiscard]] std::optional<double> maybe_number(std::string_view key);
  [[nodiscard]] std::optional<int> maybe_integer(std::string_view key);
  [[nodiscard]] std::vector<double> numbers(std::string_view key);

  /// @brief Take a key whose value is one of several names.
  template <class Value, std::size_t kCount>
  [[nodiscard]] Value one_of(std::string_view key, const std::array<Name<Value>, kCount>& names, Value otherwise) {
    const Json* given = take(key);
    if (given == nullptr) return otherwise;
    const auto found =
        std::ranges::find_if(names, [&](const auto& one) { return given->is_string() && *given == one.name; });
    if (found != names.end()) return found->value;
    throw std::invalid_argument(place_ + ": " + std::string(key) + " must be one of " + names_of(names) + ", got " +
                                shown(*given));
  }

  /// @brief Take the key `type`, with which messages then name the table.
  /// @return it, or null
  [[nodiscard]] const Json& take_type();

  /// @return where the value of a key stands
  [[nodiscard]] std::string place_of(std::string_view key) const;
  [[nodiscard]] const std::string& place() const { return place_; }

  /// @throws std::invalid_argument for keys that were not taken, and for those that were missing
  void close() const;

 private:
  [[nodiscard]] std::string unknown(const std::string& key, const Json& value) const;
  [[nodiscard]] std::string missing(const std::string& key) const;

  const Json* content_;
  std::string place_;
  std::string type_;
  std::vector<std::string> taken_;
  std::vector<std::string> missing_;
};

}  // namespace viscoroll::wasm

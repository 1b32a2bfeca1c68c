#include "table.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace viscoroll::wasm {
namespace {

const Json kNull;

[[noreturn]] void reject(const std::string& path, const std::string& wanted, const Json& got) {
  throw InvalidInput(path, "must be a valid " + wanted, shown(got));
}

/// Names of the numbers that JSON cannot represent, same as in TOML.
constexpr auto kNotFinite = std::to_array<Name<double>>({{"inf", std::numeric_limits<double>::infinity()},
                                                         {"-inf", -std::numeric_limits<double>::infinity()},
                                                         {"nan", std::numeric_limits<double>::quiet_NaN()}});

double number_from_json(const Json& value, const std::string& path) {
  if (value.is_number()) return value.get<double>();
  for (const auto& [name, number] : kNotFinite) {
    if (value.is_string() && value == name) return number;
  }
  reject(path, "number", value);
}

std::vector<double> numbers_from_json(const Json& list, const std::string& path) {
  if (!list.is_array()) reject(path, "list", list);
  std::vector<double> values;
  values.reserve(list.size());
  for (const Json& value : list) {
    values.push_back(number_from_json(value, path + "[" + std::to_string(values.size()) + "]"));
  }
  return values;
}

}  // namespace

std::string shown(const Json& value) {
  constexpr std::size_t kLongest = 120;
  const std::string text = value.is_string() ? "'" + value.get<std::string>() + "'"
                                             : value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= kLongest ? text : text.substr(0, kLongest - 3) + "...";
}

Table::Table(const Json& content, std::string path) : content_(&content), path_(std::move(path)) {
  if (!content.is_object()) reject(path_.empty() ? "case" : path_, "table", content);
}

std::string Table::path_of(std::string_view key) const { return (path_.empty() ? "" : path_ + ".") + std::string(key); }

const Json* Table::take(std::string_view key) {
  taken_.emplace_back(key);
  const auto found = content_->find(taken_.back());
  return found == content_->end() || found->is_null() ? nullptr : &*found;
}

const Json& Table::require(std::string_view key) {
  const Json* given = take(key);
  if (given != nullptr) return *given;
  missing_.emplace_back(key);
  return kNull;
}

double Table::number(std::string_view key) {
  const Json& given = require(key);
  return given.is_null() ? std::numeric_limits<double>::quiet_NaN() : number_from_json(given, path_of(key));
}

std::optional<double> Table::maybe_number(std::string_view key) {
  const Json* given = take(key);
  return given == nullptr ? std::nullopt : std::optional(number_from_json(*given, path_of(key)));
}

std::optional<int> Table::maybe_integer(std::string_view key) {
  const Json* given = take(key);
  if (given == nullptr) return std::nullopt;
  if (!given->is_number_integer()) reject(path_of(key), "integer", *given);
  const double number = given->get<double>();
  if (std::abs(number) > std::numeric_limits<int>::max()) {
    throw InvalidInput(path_of(key), "must fit into 32 bits", shown(*given));
  }
  return given->get<int>();
}

std::vector<double> Table::numbers(std::string_view key) {
  const Json& given = require(key);
  return given.is_null() ? std::vector<double>{} : numbers_from_json(given, path_of(key));
}

std::optional<std::vector<double>> Table::maybe_numbers(std::string_view key) {
  const Json* given = take(key);
  return given == nullptr ? std::nullopt : std::optional(numbers_from_json(*given, path_of(key)));
}

std::variant<std::monostate, double, std::vector<double>> Table::maybe_number_or_numbers(std::string_view key) {
  const Json* given = take(key);
  if (given == nullptr) return {};
  if (given->is_array()) return numbers_from_json(*given, path_of(key));
  return number_from_json(*given, path_of(key));
}

const Json& Table::take_type() {
  const Json* given = take("type");
  if (given == nullptr) return kNull;
  if (given->is_string()) type_ = given->get<std::string>();
  return *given;
}

void Table::close() const {
  std::vector<InvalidInput> errors;
  for (const auto& [key, value] : content_->items()) {
    if (std::ranges::find(taken_, key) == taken_.end()) {
      errors.emplace_back(path_of(key), "is not a parameter" + (type_.empty() ? "" : " of the type " + type_),
                          shown(value));
    }
  }
  for (const std::string& key : missing_) {
    errors.emplace_back(path_of(key), "must be given" + (type_.empty() ? "" : " for the type " + type_), "");
  }
  if (errors.empty()) return;
  std::string more;
  for (std::size_t i = 1; i < errors.size(); ++i) more += (i == 1 ? "" : "; ") + std::string(errors[i].what());
  throw InvalidInput(errors[0].parameter(), errors[0].rule(), errors[0].value(), more);
}

}  // namespace viscoroll::wasm

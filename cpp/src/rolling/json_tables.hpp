/// @file
/// @brief The part of JSON that files of numbers are: an object of texts, numbers, lists, and lists of lists.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace viscoroll::detail {

/// @brief Numbers by their names, as rows: a number is a row of one, a list one row. Texts are left out.
using JsonTables = std::map<std::string, std::vector<std::vector<double>>>;

/// @throws std::invalid_argument where the stream holds something else
[[nodiscard]] JsonTables read_json_tables(std::istream& json);

/// @return the rows of that name
/// @throws std::invalid_argument where there are none
[[nodiscard]] const std::vector<std::vector<double>>& table_of(const JsonTables& tables, const std::string& name);

/// @return the only row of that name
/// @throws std::invalid_argument where there is none, or one of another length
[[nodiscard]] const std::vector<double>& row_of(const JsonTables& tables, const std::string& name, std::size_t length);

}  // namespace viscoroll::detail

#include "rolling/json_tables.hpp"

#include <istream>
#include <locale>
#include <utility>

#include "validate.hpp"

namespace viscoroll::detail {
namespace {

/// What stands next, after white space.
char next(std::istream& json) {
  char character = '\0';
  json >> std::ws;
  if (!json.get(character)) reject("file", "JSON with numbers", "an end before its end");
  return character;
}

char peek(std::istream& json) {
  const char character = next(json);
  json.putback(character);
  return character;
}

void expect(std::istream& json, char wanted) {
  const char found = next(json);
  if (found != wanted) reject("file", std::string("JSON with '") + wanted + "' here", std::string(1, found));
}

/// A text: what is escaped stays escaped, for names have none of it.
std::string read_text(std::istream& json) {
  expect(json, '"');
  std::string text;
  for (char character = '\0'; json.get(character) && character != '"';) {
    text += character;
    if (character == '\\' && json.get(character)) text += character;
  }
  if (!json) reject("file", "JSON with numbers", "a text without an end");
  return text;
}

double read_number(std::istream& json) {
  double number = 0.0;
  if (!(json >> number)) reject("file", "JSON with numbers, texts and lists of numbers", "another value");
  return number;
}

/// A list of what `read_item` reads.
template <class ReadItem>
void read_list(std::istream& json, const ReadItem& read_item) {
  expect(json, '[');
  if (peek(json) == ']') {
    next(json);
    return;
  }
  for (;;) {
    read_item();
    const char behind = next(json);
    if (behind == ']') return;
    if (behind != ',') reject("file", "JSON with ',' or ']' here", std::string(1, behind));
  }
}

std::vector<double> read_row(std::istream& json) {
  std::vector<double> row;
  read_list(json, [&] { row.push_back(read_number(json)); });
  return row;
}

std::vector<std::vector<double>> read_rows(std::istream& json) {
  if (peek(json) != '[') return {{read_number(json)}};
  std::vector<std::vector<double>> rows;
  std::vector<double> row;
  read_list(json, [&] {
    if (peek(json) == '[') {
      rows.push_back(read_row(json));
    } else {
      row.push_back(read_number(json));
    }
  });
  if (!rows.empty() && !row.empty()) reject("file", "JSON with lists of numbers or of lists", "one of both");
  if (rows.empty()) rows.push_back(std::move(row));
  return rows;
}

}  // namespace

JsonTables read_json_tables(std::istream& json) {
  json.imbue(std::locale::classic());
  JsonTables tables;
  expect(json, '{');
  if (peek(json) == '}') return tables;
  for (;;) {
    std::string name = read_text(json);
    expect(json, ':');
    if (peek(json) == '"') {
      read_text(json);
    } else {
      tables[std::move(name)] = read_rows(json);
    }
    const char behind = next(json);
    if (behind == '}') return tables;
    if (behind != ',') reject("file", "JSON with ',' or '}' here", std::string(1, behind));
  }
}

const std::vector<std::vector<double>>& table_of(const JsonTables& tables, const std::string& name) {
  const auto found = tables.find(name);
  if (found == tables.end()) reject("file", "JSON with a value of \"" + name + "\"", "none");
  return found->second;
}

const std::vector<double>& row_of(const JsonTables& tables, const std::string& name, std::size_t length) {
  const auto& rows = table_of(tables, name);
  if (rows.size() != 1 || rows.front().size() != length) {
    reject("file", "JSON with " + std::to_string(length) + " numbers as \"" + name + "\"", "another number of them");
  }
  return rows.front();
}

}  // namespace viscoroll::detail

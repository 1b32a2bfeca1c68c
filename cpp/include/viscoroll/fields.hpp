/// @file
/// @brief Lists of the members of input structs, from which files, WebAssembly and Python read these structs.
///
/// A struct with a static function `fields` is read member by member. A reader is a function
/// `reader(name, otherwise, is_optional)`. It returns the given value of the parameter, or `otherwise` if an optional
/// parameter is left out.
#pragma once

#include <tuple>
#include <utility>

namespace viscoroll {

/// @brief Member of an input struct.
template <class Struct, class Value>
struct Field {
  const char* name;          ///< name of the parameter in files and in Python
  Value Struct::* member;    ///< pointer to the member
  bool is_optional = false;  ///< whether files may omit the parameter; the member then has its default
};

template <class Struct, class Value>
Field(const char*, Value Struct::*) -> Field<Struct, Value>;
template <class Struct, class Value>
Field(const char*, Value Struct::*, bool) -> Field<Struct, Value>;

/// @brief Read a struct from its parameters, in the order of its list.
template <class Struct, class Reader>
[[nodiscard]] Struct read_fields(const Reader& reader) {
  Struct read;
  std::apply(
      [&](const auto&... field) {
        ((read.*field.member = reader(field.name, std::move(read.*field.member), field.is_optional)), ...);
      },
      Struct::fields());
  return read;
}

}  // namespace viscoroll

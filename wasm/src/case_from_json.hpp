/// @file
/// @brief Cases from JSON with the tables and keys of a case file.
#pragma once

#include "bodies_from_json.hpp"
#include "table.hpp"
#include "viscoroll/load_case.hpp"
#include "viscoroll/options.hpp"

namespace viscoroll::wasm {

/// @brief Arguments of `solve`.
struct Case {
  Pair pair;
  LoadCase load_case;
  Options options;  ///< with one thread
};

/// @param[in] json tables of a case file that do not refer to other files: bodies, rolling, numerics
/// @throws InvalidInput for unknown and missing keys and values out of range; its parameter is the path of the key
[[nodiscard]] Case case_from_json(const Json& json);

}  // namespace viscoroll::wasm

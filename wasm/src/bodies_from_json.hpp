/// @file
/// @brief What rolls, and what it rolls on, as case files have them.
#pragma once

#include "table.hpp"
#include "viscoroll/rolling_body.hpp"

namespace viscoroll::wasm {

/// @brief Two bodies.
struct Pair {
  RollingBody body;
  Counterpart on;  ///< the rigid plane unless the case says otherwise
};

/// @brief Take the tables of the bodies from a case.
/// @param[in,out] file all of a case
/// @throws std::invalid_argument for unknown and missing keys, values out of range, and unless one body rolls
[[nodiscard]] Pair pair_from_json(Table& file);

}  // namespace viscoroll::wasm
